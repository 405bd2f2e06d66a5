#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// What an engine does with a body that no cable pulls.
[[nodiscard]] Measure measure_flight(const Subject& subject);

}  // namespace tautline::bench
