#pragma once

#include <memory>

#include "bench/run/protocol/children.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// A run that the child steps. Steps of the usual length are asked for ahead, and none past the
/// last of them: a message costs more than many steps.
[[nodiscard]] std::unique_ptr<Simulation> start_by_steps(Children& children, const Case& the_case,
                                                         const ChildModel& model,
                                                         const RunSettings& settings);

}  // namespace tautline::bench
