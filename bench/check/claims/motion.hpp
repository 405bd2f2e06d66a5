#pragma once

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// What a run as a whole must keep: energy, and the length of its cables.
[[nodiscard]] Measure measure_energy(const Subject& subject);
[[nodiscard]] Measure measure_overstretch(const Subject& subject);
[[nodiscard]] Measure measure_taut_growth(const Subject& subject);

}  // namespace tautline::bench
