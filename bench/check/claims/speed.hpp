#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// Whether a body that nothing pulls keeps its speed and its spin, however fast or slow it is.
[[nodiscard]] Measure measure_fast_flight(const Subject& subject);
[[nodiscard]] Measure measure_slow_flight(const Subject& subject);

}  // namespace tautline::bench
