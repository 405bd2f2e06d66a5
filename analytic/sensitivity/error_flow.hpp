#pragma once

#include "arc_rounding.hpp"
#include "spread.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// d state / dt at the end of `dt` [s] of `arc`, where the state is `last`.
[[nodiscard]] StateVector rate_at(const Arc& arc, double dt, const State& last,
                                  const Vec2& gravity);

/// `spread` after `dt` [s] of `arc`, to the state `last`, with what rounding adds. `basis` are the
/// independent ones of its taut cables.
[[nodiscard]] Spread along(const Spread& spread, const Case& the_case, const Sizes& sizes,
                           const Arc& arc, CableSet basis, double dt, const State& last);

}  // namespace tautline
