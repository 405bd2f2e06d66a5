#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::test {

/// What the contract tests ask beyond `bench::claims`: how near a model is to the exact motion.
inline constexpr std::string_view accuracy_claim = "accuracy";

/// A claim that a model does not keep, and why. It is asserted both ways: a model that starts to
/// keep it fails the test until it is taken out.
struct Exception {
  std::string engine;  // the one that it is of; empty: all of the folder
  std::string model;
  std::string claim;  // one of `bench::claims`, or `accuracy_claim`
  std::string reason;
};

/// What an engines/<folder>/contract.toml says, and what is wrong with it.
struct ContractFile {
  std::vector<Exception> exceptions;
  std::vector<std::string> problems;
};

/// The folder of `engine` in the source tree: of its name, or of its name without digits where two
/// precisions share one.
[[nodiscard]] std::filesystem::path folder_of(const std::string& engine);

/// `models` are those of the engine; a file that names another has a problem. With none, all pass.
[[nodiscard]] ContractFile read_contract(std::string_view text, const std::string& source_name,
                                         std::span<const std::string> models);

/// That of `engine`, from the source tree; without exceptions where it has no such file.
[[nodiscard]] ContractFile contract_of(const std::string& engine,
                                       std::span<const std::string> models);

/// Every contract.toml of the source tree.
[[nodiscard]] std::vector<std::filesystem::path> contract_files();

/// Fails unless `reached` <= `allowed`; for an exception, unless it is not.
void expect_claim(const std::string& engine, const std::string& model, std::string_view claim,
                  double reached, double allowed);

}  // namespace tautline::test
