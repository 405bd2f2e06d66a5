#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/draw_solver.hpp"

namespace tautline::bench {

/// A number that differs where the same draw of `setup` may have other values: another case,
/// another distribution, another program or plug-in, which `program` identifies. The count has no
/// part in it.
[[nodiscard]] std::uint64_t draws_fingerprint(const EnsembleSpec& spec, const EnsembleSetup& setup,
                                              std::uint64_t program);

/// Where a chunk of draws is kept, below the folder of an ensemble.
[[nodiscard]] std::filesystem::path chunk_file(const std::filesystem::path& out,
                                               const EnsembleSetup& setup, std::size_t first);

/// Draws as CSV with a heading, below a line with their fingerprint. Numbers read back as they are.
[[nodiscard]] std::string chunk_csv(const EnsembleSpec& spec, std::uint64_t fingerprint,
                                    const std::vector<DrawResult>& results);

/// The draws from `first` up to `end` in such a file; none if it is not there, or is of another
/// fingerprint or of other draws.
[[nodiscard]] std::optional<std::vector<DrawResult>> read_chunk(const std::filesystem::path& file,
                                                                const EnsembleSpec& spec,
                                                                std::uint64_t fingerprint,
                                                                std::size_t first, std::size_t end);

}  // namespace tautline::bench
