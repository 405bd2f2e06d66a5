#pragma once

#include <memory>
#include <string>

#include "bench/run/protocol/children.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// A run that the child steps. Steps of the usual length are asked for ahead, and none past the
/// last of them: a message costs more than many steps.
[[nodiscard]] std::unique_ptr<Simulation> start_by_steps(Children& children, const Case& the_case,
                                                         const ChildModel& model,
                                                         const RunSettings& settings);

/// A run in which the event driver finds every event, and the child flies and solves.
[[nodiscard]] std::unique_ptr<Simulation> start_by_events(Children& children, const Case& the_case,
                                                          const ChildModel& model,
                                                          const std::string& precision,
                                                          const RunSettings& settings);

/// Throws ProtocolError if the angle jumps by about a turn or more in a move of `dt` [s] for which
/// the spins before and after give no reason: engines keep angles that know no turns.
void refuse_wrapped(const State& before, const State& after, double dt);

}  // namespace tautline::bench
