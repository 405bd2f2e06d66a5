#pragma once

#include <optional>

#include "tautline/case.hpp"
#include "tautline/detail/swing.hpp"

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

/// The same of other kinds of cases, where no way to tell it is known.
template <class TheCase>
[[nodiscard]] std::optional<BasicSwing<RealOf<TheCase>>> swing_ahead(const TheCase&,
                                                                     const StateOf<TheCase>&,
                                                                     CableSet,
                                                                     const RealOf<TheCase>&) {
  return std::nullopt;
}

}  // namespace tautline
