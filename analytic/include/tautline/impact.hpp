#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string_view>
#include <type_traits>

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// How an impact on several cables at once is resolved (analytic/README.md section 4). One cable
/// alone has one law; these differ where several hit at once, or one hits while others are taut.
/// Every cable's restitution is that of its own closing rate before the impact, in `sequential`
/// before each of its hits.
enum class ImpactLaw {
  simultaneous,  // Moreau's form of Newton's law: one LCP for all cables; velocity-level time
                 // stepping converges to it
  poisson,       // compression of all cables, then each gives back restitution times its impulse;
                 // with one restitution the same as simultaneous
  sequential,    // one cable after the other, the fastest closing first, the lowest index on ties
  energetic,     // Stronge's: each gives back restitution squared of its work of compression; the
                 // cables are linear springs, equally stiff, that act while the pose stands still
};

/// All of them.
inline constexpr std::array impact_laws = {ImpactLaw::simultaneous, ImpactLaw::poisson,
                                           ImpactLaw::sequential, ImpactLaw::energetic};

/// The name used in files and commands: "simultaneous", and so on.
[[nodiscard]] std::string_view to_string(ImpactLaw law);

/// The impulses of one impact and the state after it.
template <class TheCase>
struct BasicImpact {
  using Real = RealOf<TheCase>;

  BasicCableVector<Real> impulses;  // [N s], >= 0, one per cable of the set, rising index order
  StateOf<TheCase> after;           // the same pose, the velocities after the impact
  int steps = 0;                    // of the springs within it, under the energetic law [-]
};
using Impact = BasicImpact<Case>;

/// Newton's impact law for all of `cables`, each at zero gap and closing or resting (Eq. 14):
/// 0 <= impulse, perpendicular to, rate after + restitution * rate before >= 0.
/// Never gains energy (analytic/README.md section 4). A rate > 0 before is a caller's mistake;
/// one within rounding of zero is taken as it is, or left out where that leaves no solution.
template <class TheCase>
[[nodiscard]] BasicImpact<TheCase> newton_impact(const TheCase& the_case,
                                                 const StateOf<TheCase>& before, CableSet cables);

/// The same for any law; simultaneous is `newton_impact`. No law gains energy, and none leaves a
/// cable closing but for rounding. Where `sequential` or `energetic` come to no end (elastic cables
/// that leave the body nowhere to go) they give up after a fixed number of steps, and what still
/// closes is stopped without restitution. Impulses are NaN where numbers overflow.
template <class TheCase>
[[nodiscard]] BasicImpact<TheCase> resolve_impact(ImpactLaw law, const TheCase& the_case,
                                                  const StateOf<TheCase>& before, CableSet cables);

/// Solves the linear complementarity problem 0 <= z, perpendicular to, m z + q >= 0 for a matrix
/// m = J M^-1 J^T: symmetric positive semidefinite with a rank of at most `rank`, three of a planar
/// body, up to 8 by 8. m z is unique; among the solutions z of a redundant set, one with at most
/// `rank` entries > 0. None if the problem has no solution, not even for a q that differs by
/// `rounding`.
template <class Real>
[[nodiscard]] std::optional<BasicCableVector<Real>> solve_lcp(
    const BasicCableMatrix<Real>& m, const std::type_identity_t<BasicCableVector<Real>>& q,
    const std::type_identity_t<Real>& rounding = Real(0), int rank = 3);

/// By how much the rates of dependent cables may contradict each other, from rounding alone [m/s].
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] Real impact_rounding(const TheCase& the_case, const StateOf<TheCase>& state) {
  return 4500 * epsilon<Real>() * speed_scale(the_case, state);  // 1e-12 of the speed in double
}

/// True where the rows of `cables` in the constraint Jacobian are independent, beyond rounding.
template <class TheCase>
[[nodiscard]] bool independent(const TheCase& the_case, const StateOf<TheCase>& state,
                               CableSet cables);

/// The tensions [N] that hold `cables`, all at zero gap and resting, and what they leave (Eq. 16):
/// 0 <= tension, perpendicular to, gap acceleration >= 0.
template <class Real>
struct BasicTensions {
  BasicCableVector<Real> tension;             // [N], one per cable of the set
  BasicCableVector<Real> acceleration;        // [m/s^2], of each gap under these tensions
  BasicCableVector<Real> tension_error;       // [N], by which rounding may have changed the tension
  BasicCableVector<Real> acceleration_error;  // [m/s^2], and the acceleration
};
using Tensions = BasicTensions<double>;
/// None where no tension can hold the cables: the pose is admissible, no motion through it is.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] std::optional<BasicTensions<Real>> resting_tensions(const TheCase& the_case,
                                                                  const StateOf<TheCase>& state,
                                                                  CableSet cables);

}  // namespace tautline
