#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// Whether a hit moves and turns the body that was declared.
[[nodiscard]] Measure measure_mass(const Subject& subject);
[[nodiscard]] Measure measure_inertia(const Subject& subject);
[[nodiscard]] Measure measure_arm(const Subject& subject);
[[nodiscard]] Measure measure_angular_momentum(const Subject& subject);

}  // namespace tautline::bench
