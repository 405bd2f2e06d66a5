#pragma once

#include <array>
#include <optional>

#include "tautline/case.hpp"
#include "tautline/first_contact.hpp"
#include "tautline/series.hpp"

namespace tautline {

/// What becomes of the cables at zero gap and zero rate, and the motion that follows.
template <class Real>
struct BasicHold {
  CableSet pulling;    // held by a tension > 0; their rows are independent
  CableSet following;  // redundant: stay at zero gap without a tension of their own
  TautSeries<Real> motion;
  Real reach;  // [s] within which the series are right to rounding
  /// Leading coefficients that are zero: of the gap of a cable that leaves, of the tension of one
  /// that pulls.
  std::array<std::size_t, max_cables> zeros{};

  [[nodiscard]] CableSet taut() const { return pulling | following; }
};
using Hold = BasicHold<double>;

/// The motion from `state` of which `resting` are the cables at zero gap and zero rate: the one in
/// which every tension and every gap is >= 0 for a while (analytic/README.md section 6). `touching`
/// adds those at zero gap that open. None where no tension can hold the cables.
template <class Real>
[[nodiscard]] std::optional<BasicHold<Real>> hold(const BasicCase<Real>& the_case,
                                                  const BasicState<Real>& state,
                                                  const BasicTouching<Real>& touching,
                                                  CableSet resting);

/// The same motion where its series end: the cables that pulled go on pulling. None where rounding
/// says otherwise.
template <class Real>
[[nodiscard]] std::optional<BasicHold<Real>> continued(const BasicCase<Real>& the_case,
                                                       const BasicState<Real>& state,
                                                       const BasicTouching<Real>& touching,
                                                       const BasicHold<Real>& held);

/// The first instant up to min(hold.reach, horizon) at which a slack cable becomes taut, or at
/// which a tension falls to zero, then with no cable; or that bound itself, with none.
template <class Real>
[[nodiscard]] BasicFirstContact<Real> first_change(const BasicCase<Real>& the_case,
                                                   const BasicHold<Real>& held,
                                                   const std::type_identity_t<Real>& horizon);

}  // namespace tautline
