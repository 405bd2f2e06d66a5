#pragma once

#include <Eigen/Core>
#include <optional>

#include "tautline/case.hpp"

namespace tautline {

/// The impulses of one impact and the state after it.
struct Impact {
  CableVector impulses;  // [N s], >= 0, one per cable of the set, in rising index order
  State after;
};

/// Newton's impact law for all of `cables`, each at zero gap and closing or resting (Eq. 14):
/// 0 <= impulse, perpendicular to, rate after + restitution * rate before >= 0.
/// Never gains energy (analytic/README.md section 4). A rate > 0 before is a caller's mistake;
/// one within rounding of zero is taken as it is, or left out where that leaves no solution.
[[nodiscard]] Impact newton_impact(const Case& the_case, const State& before, CableSet cables);

/// Solves the linear complementarity problem 0 <= z, perpendicular to, m z + q >= 0 for a matrix
/// m = J M^-1 J^T of a planar body: symmetric positive semidefinite with rank <= 3, up to 8 by 8.
/// m z is unique; among the solutions z of a redundant set, one with at most three entries > 0.
/// None if the problem has no solution.
[[nodiscard]] std::optional<CableVector> solve_lcp(const CableMatrix& m, const CableVector& q);

/// The tensions [N] that hold `cables`, all at zero gap and resting, and what they leave (Eq. 16):
/// 0 <= tension, perpendicular to, gap acceleration >= 0.
struct Tensions {
  CableVector tension;       // [N], one per cable of the set
  CableVector acceleration;  // [m/s^2], of each gap under these tensions
};
/// None where no tension can hold the cables: the pose is admissible, no motion through it is.
[[nodiscard]] std::optional<Tensions> resting_tensions(const Case& the_case, const State& state,
                                                       CableSet cables);

}  // namespace tautline
