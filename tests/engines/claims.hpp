#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tautline::test {

/// What the contract tests claim of every model, unless its engine's contract.toml says otherwise.
enum class Claim {
  flight,                  // slack, it follows its recurrence to rounding
  central_restitution,     // a fast hit through the centre of mass rebounds with e
  off_centre_restitution,  // so does one of a spinning body
  slow_restitution,        // so does one at 0.05 m/s
  step_momentum,           // a step's impulses, at the pose of its solve, change the momentum
  mirror_symmetry,         // the mirrored case moves in the mirror
  overstretch,             // steps of 0.01 s stretch no cable by more than 5 % of its length
  convergence,             // the error is at least of first order in the step
};

/// The name used in files: "central-restitution", and so on.
[[nodiscard]] std::string_view to_string(Claim claim);

/// A claim that a model does not keep, and why. It is asserted both ways: a model that starts to
/// keep it fails the test until its row is taken out.
struct Exception {
  std::string model;
  Claim claim;
  std::string reason;
};

/// What an engines/<name>/contract.toml says, and what is wrong with it.
struct ContractFile {
  std::vector<Exception> exceptions;
  std::vector<std::string> problems;
};

/// `models` are those of the engine; a file that names another has a problem. With none, all pass.
[[nodiscard]] ContractFile read_contract(std::string_view text, const std::string& source_name,
                                         std::span<const std::string> models);

/// That of `engine`, from the source tree; without exceptions where it has no such file.
[[nodiscard]] ContractFile contract_of(const std::string& engine,
                                       std::span<const std::string> models);

/// Every contract.toml of the source tree.
[[nodiscard]] std::vector<std::filesystem::path> contract_files();

/// Fails unless `reached` <= `allowed`; for an exception, unless it is not.
void expect_claim(const std::string& engine, const std::string& model, Claim claim, double reached,
                  double allowed);

}  // namespace tautline::test
