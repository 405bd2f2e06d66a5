#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/check/contract.hpp"

namespace tautline::test {

/// The folder of `engine` in the source tree: of its name, or of its name without digits where two
/// precisions share one.
[[nodiscard]] std::filesystem::path folder_of(const std::string& engine);

/// The contract of `engine`, from the source tree; without exceptions where it has no such file.
/// `models` are those of the engine; with none, all pass.
[[nodiscard]] bench::Contract contract_of(const std::string& engine,
                                          std::span<const std::string> models);

/// Every contract.toml of the source tree.
[[nodiscard]] std::vector<std::filesystem::path> contract_files();

/// Fails unless `reached` <= `allowed`; for an exception, unless it is not.
void expect_claim(const std::string& engine, const std::string& model, std::string_view claim,
                  double reached, double allowed);

}  // namespace tautline::test
