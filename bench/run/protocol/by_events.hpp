#pragma once

#include <memory>
#include <string>

#include "bench/run/protocol/children.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// A run in which the event driver finds every event, and the child flies and solves.
[[nodiscard]] std::unique_ptr<Simulation> start_by_events(Children& children, const Case& the_case,
                                                          const ChildModel& model,
                                                          const std::string& precision,
                                                          const RunSettings& settings);

}  // namespace tautline::bench
