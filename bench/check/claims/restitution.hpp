#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// How hits rebound.
[[nodiscard]] Measure measure_central_restitution(const Subject& subject);
[[nodiscard]] Measure measure_off_centre_restitution(const Subject& subject);
[[nodiscard]] Measure measure_slow_restitution(const Subject& subject);

}  // namespace tautline::bench
