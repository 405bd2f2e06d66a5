#pragma once

#include <string>
#include <vector>

namespace tautline::test {

/// What the contract tests claim of every model, unless the table below says otherwise.
enum class Claim {
  flight,                  // slack, it follows its recurrence to rounding
  central_restitution,     // a fast hit through the centre of mass rebounds with e
  off_centre_restitution,  // so does one of a spinning body
  slow_restitution,        // so does one at 0.05 m/s
  step_momentum,           // a step's impulses, at the pose of its solve, change the momentum
  mirror_symmetry,         // the mirrored case moves in the mirror
};

/// A claim that a model does not keep, and why. It is asserted both ways: a model that starts to
/// keep it fails the test until its row is taken out.
struct Exception {
  std::string engine;
  std::string model;
  Claim claim;
  std::string reason;
};

[[nodiscard]] const std::vector<Exception>& exceptions();

/// Fails unless `reached` <= `allowed`; for a model in the table, unless it is not.
void expect_claim(const std::string& engine, const std::string& model, Claim claim, double reached,
                  double allowed);

}  // namespace tautline::test
