#pragma once

#include <filesystem>
#include <string>

#include "bench/ensemble/output/words.hpp"

namespace tautline::bench {

/// Writes index.html, ensemble.md, ensemble.json and the pictures of an atlas into `out`. `command`
/// made them. Throws FileError if one cannot be written.
void write_ensemble(const std::filesystem::path& out, const EnsembleReport& report,
                    const std::string& command);

}  // namespace tautline::bench
