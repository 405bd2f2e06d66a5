#pragma once

#include <cstddef>

#include "bench/measure/reference.hpp"
#include "bench/report/report.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

// What a page needs to draw a motion again: few samples, and all that happens between them. A whole
// trajectory has a hundred thousand samples; a report of thousands of runs cannot hold them.

/// Of one run's impacts, or of one case's events, a report has at most so many, the fastest.
inline constexpr std::size_t most_impacts = 300;

/// `samples` samples of `run` and one at every impact that the report has. There the energy is the
/// one after the impact; the place is the same on both sides.
[[nodiscard]] Path run_path(const Case& the_case, const Trajectory& run, std::size_t samples,
                            double count_speed);

/// The impacts that the report has: those that close faster than `count_speed` [m/s], the fastest
/// `most_impacts` of them.
[[nodiscard]] ImpactColumns run_impacts(const Case& the_case, const Trajectory& run,
                                        double count_speed);

/// The exact motion, with a sample at every event that the report has.
[[nodiscard]] Path exact_path(const ReferenceCase& reference);

/// Its events; of very many the fastest impacts, and all that are none.
[[nodiscard]] EventColumns exact_events(const ReferenceCase& reference);

}  // namespace tautline::bench
