#pragma once

#include <optional>
#include <type_traits>

#include "tautline/case.hpp"
#include "tautline/hold.hpp"
#include "tautline/swing.hpp"

namespace tautline {

/// The swing for ever of a body that the cables `pulling` hold in `state`, where it is certain that
/// it follows: two cables pull at a rigid body all the way between its turning points, no other
/// closes, two turning points are reached within `left` [s], not counting a start at rest, and the
/// angle rises or falls all the way between them. None: it may follow or not, and steps of the
/// motion find out.
///
/// No step is made: on two cables the body's way is a curve, and its kinetic energy a function of
/// the place on it (analytic/README.md section 6, "A swing told ahead").
[[nodiscard]] std::optional<Swing> swing_ahead(const Case& the_case, const State& state,
                                               CableSet pulling, double left);

/// The same of the motion `held`, if any; in double alone.
template <class Real>
[[nodiscard]] std::optional<BasicSwing<Real>> told_swing(const BasicCase<Real>& the_case,
                                                         const BasicState<Real>& state,
                                                         const std::optional<BasicHold<Real>>& held,
                                                         const Real& left) {
  if constexpr (std::is_same_v<Real, double>) {
    return held ? swing_ahead(the_case, state, held->pulling, left) : std::nullopt;
  } else {
    return std::nullopt;
  }
}

}  // namespace tautline
