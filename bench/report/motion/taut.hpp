#pragma once

#include <vector>

#include "bench/report/motion/path.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// A run's cable is at its length where its recorded gap is below this part of the length [-]: held
/// cables are within 1e-5 of it in all engines but the softest, and a free one passes this in a
/// step.
inline constexpr double taut_part = 1e-4;

/// A run's cable is taut where it is at its length for so long [s], a frame of a screen. A shorter
/// touch is an impact.
inline constexpr double shortest_hold = 1.0 / 60.0;

/// For every cable of a run, when it is taut, as the recorded points tell.
[[nodiscard]] std::vector<TautColumns> taut_columns(const Case& the_case, const Trajectory& run);

/// The same of the exact motion, as its taut and slack events tell.
[[nodiscard]] std::vector<TautColumns> taut_columns(const Case& the_case, const Solution& solution);

}  // namespace tautline::bench
