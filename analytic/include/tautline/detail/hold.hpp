#pragma once

#include <array>
#include <optional>

#include "tautline/case.hpp"
#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/series.hpp"

namespace tautline {

/// What becomes of the cables at zero gap and zero rate, and the motion that follows.
template <class TheCase>
struct BasicHold {
  using Real = RealOf<TheCase>;

  CableSet pulling;    // held by a tension > 0; their rows are independent
  CableSet following;  // redundant: stay at zero gap without a tension of their own
  SeriesOf<TheCase> motion;
  Real reach;  // [s] within which the series are right to rounding
  /// Leading coefficients that are zero: of the gap of a cable that leaves, of the tension of one
  /// that pulls.
  std::array<std::size_t, max_cables> zeros{};

  [[nodiscard]] CableSet taut() const { return pulling | following; }
};
using Hold = BasicHold<Case>;

/// The motion from `state` of which `resting` are the cables at zero gap and zero rate: the one in
/// which every tension and every gap is >= 0 for a while (analytic/README.md section 6). `touching`
/// adds those at zero gap that open. None where no tension can hold the cables.
template <class TheCase>
[[nodiscard]] std::optional<BasicHold<TheCase>> hold(const TheCase& the_case,
                                                     const StateOf<TheCase>& state,
                                                     const TouchingOf<TheCase>& touching,
                                                     CableSet resting);

/// The same motion where its series end: the cables that pulled go on pulling. None where rounding
/// says otherwise.
template <class TheCase>
[[nodiscard]] std::optional<BasicHold<TheCase>> continued(const TheCase& the_case,
                                                          const StateOf<TheCase>& state,
                                                          const TouchingOf<TheCase>& touching,
                                                          const BasicHold<TheCase>& held);

/// The first instant up to min(hold.reach, horizon) at which a slack cable becomes taut, or at
/// which a tension falls to zero, then with no cable; or that bound itself, with none.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicFirstContact<Real> first_change(const TheCase& the_case,
                                                   const BasicHold<TheCase>& held,
                                                   const std::type_identity_t<Real>& horizon);

}  // namespace tautline
