#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// The gap rates of `cables` [m/s].
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicCableVector<Real> gap_rates(const TheCase& the_case,
                                               const StateOf<TheCase>& state, CableSet cables) {
  BasicCableVector<Real> result(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result[row++] = gap_rate(the_case.cables[index], state);
  }
  return result;
}

/// The multipliers z of smallest size with J M^-1 J^T z = right over `cables`.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicCableVector<Real> multipliers(const TheCase& the_case,
                                                 const StateOf<TheCase>& state, CableSet cables,
                                                 const BasicCableVector<Real>& right);

/// The state with the gap rates of `cables` removed, M-orthogonally (Eq. 18).
template <class TheCase>
[[nodiscard]] StateOf<TheCase> with_zero_rates(const TheCase& the_case,
                                               const StateOf<TheCase>& state, CableSet cables);

/// The state with the gaps of `cables` closed, M-orthogonally, by Newton's method. The gaps are
/// small against the lengths. Cables whose sine with the others is below `least_sine` are left out:
/// to close them, too, the body would have to go far.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] StateOf<TheCase> with_zero_gaps(
    const TheCase& the_case, StateOf<TheCase> state, CableSet cables,
    const std::type_identity_t<Real>& least_sine = Real(0));

/// The state in which `cables` are taut and the momentum along them is that of `state`: the nearest
/// pose in the metric of M, then the velocity without the rates (Eq. 18). Momentum, not velocity,
/// is what bounces of small height keep: like a skater who moves out, the body slows down by the
/// gaps times the curvature.
template <class TheCase>
[[nodiscard]] StateOf<TheCase> projected(const TheCase& the_case, const StateOf<TheCase>& state,
                                         CableSet cables);

/// `taut_start` takes up no more than this: of a gap as a part of the cable's length, of a rate as
/// a part of the speed of its attachment [-]. Numbers typed with three digits are as good.
inline constexpr double most_taken_up = 1e-3;

/// A start on taut cables, or why there is none.
struct TautStart {
  std::optional<State> start;         // present exactly when `problems` is empty
  std::vector<std::string> problems;  // sentences
  double moved;                       // [m], the centre, from the initial state to this
  double turned;                      // [rad], the body
  double slowed;                      // [m/s], the change of the centre's velocity
  double spun;                        // [rad/s], of the spin
};

/// The initial state of `the_case` with `cables` taut, of which a start that is typed with a few
/// digits misses the gaps: closed by the least move of the body (in the metric of M, Eq. 18). Rates
/// up to `most_taken_up` are removed likewise; faster ones stay, so that such a cable is hit at
/// once, or let go. Where all gaps are zero up to rounding the pose is kept to the last bit, and so
/// is the velocity. Requires a case without problems but for overstretched `cables`.
[[nodiscard]] TautStart taut_start(const Case& the_case, CableSet cables);

}  // namespace tautline
