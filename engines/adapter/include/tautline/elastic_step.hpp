#pragma once

#include <vector>

#include "tautline/system.hpp"
#include "tautline/system_loads.hpp"

// Elastic cables in fixed steps: the law (E1) of analytic/README.md, section 13, as the state at
// the start of a step has it. A scheme that moves the bodies with their new velocities is then
// stable while the frequency of a cable times the step is below 2, less with damping.

namespace tautline {

/// `state` with the zones that its poses and velocities give the elastic cables of `system`. Zones
/// that it already has are those of the step before: a cable that was stretched then keeps its
/// damping.
[[nodiscard]] SpatialSystemState with_zones_of_step(const SpatialSystem& system,
                                                    SpatialSystemState state);

/// The impulse of each cable in a step of `dt` [s] from `state` [N s]: of those that pull or
/// resist their tension at its start times `dt`, of the others 0.
[[nodiscard]] std::vector<double> elastic_impulses(const SpatialSystem& system,
                                                   const SpatialSystemState& state, double dt);

/// The forces [N] of the cables of `state` that pull or resist on each body, and their moments
/// about its centre [N m], in world axes. One for each body, in their order.
[[nodiscard]] std::vector<BodyLoad> elastic_loads(const SpatialSystem& system,
                                                  const SpatialSystemState& state);

}  // namespace tautline
