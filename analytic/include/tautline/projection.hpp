#pragma once

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// The gap rates of `cables` [m/s].
template <class Real>
[[nodiscard]] BasicCableVector<Real> gap_rates(const BasicCase<Real>& the_case,
                                               const BasicState<Real>& state, CableSet cables) {
  BasicCableVector<Real> result(static_cast<Eigen::Index>(cables.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    result[row++] = gap_rate(the_case.cables[index], state);
  }
  return result;
}

/// The multipliers z of smallest size with J M^-1 J^T z = right over `cables`.
template <class Real>
[[nodiscard]] BasicCableVector<Real> multipliers(const BasicCase<Real>& the_case,
                                                 const BasicState<Real>& state, CableSet cables,
                                                 const BasicCableVector<Real>& right);

/// The state with the gap rates of `cables` removed, M-orthogonally (Eq. 18).
template <class Real>
[[nodiscard]] BasicState<Real> with_zero_rates(const BasicCase<Real>& the_case,
                                               const BasicState<Real>& state, CableSet cables);

/// The state with the gaps of `cables` closed, M-orthogonally, by Newton's method. The gaps are
/// small against the lengths. Cables whose sine with the others is below `least_sine` are left out:
/// to close them, too, the body would have to go far.
template <class Real>
[[nodiscard]] BasicState<Real> with_zero_gaps(
    const BasicCase<Real>& the_case, BasicState<Real> state, CableSet cables,
    const std::type_identity_t<Real>& least_sine = Real(0));

/// The state in which `cables` are taut and the momentum along them is that of `state`: the nearest
/// pose in the metric of M, then the velocity without the rates (Eq. 18). Momentum, not velocity,
/// is what bounces of small height keep: like a skater who moves out, the body slows down by the
/// gaps times the curvature.
template <class Real>
[[nodiscard]] BasicState<Real> projected(const BasicCase<Real>& the_case,
                                         const BasicState<Real>& state, CableSet cables);

}  // namespace tautline
