#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// Whether the impulses that a model reports are those that changed the motion.
[[nodiscard]] Measure measure_step_momentum(const Subject& subject);

}  // namespace tautline::bench
