#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// Whether states have the precision that the engine declares: at the start, and after every step.
[[nodiscard]] Measure measure_state_echo(const Subject& subject);
[[nodiscard]] Measure measure_precision(const Subject& subject);

}  // namespace tautline::bench
