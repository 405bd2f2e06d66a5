#pragma once

#include <optional>
#include <vector>

#include "bench/measure/metrics.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// What the cables of a run pull with, beside the exact motion.
struct TensionMatch {
  /// [N], of the cable that is off most: of the run the mean over the second half of the rest. None
  /// where the exact motion does not end at rest, or statics do not determine the tensions.
  std::optional<ExactAndFound> at_rest;
  /// [N], the largest mean of a cable over a step, of the steps in which it is taut in the exact
  /// motion, and neither that motion changes nor the run has an impact some steps before or after.
  std::optional<ExactAndFound> largest;
};

/// The tensions of `run`, which its engine tells, up to `end` [s]; at rest also beyond.
template <class TheCase>
[[nodiscard]] TensionMatch match_tensions(const TheCase& the_case,
                                          const BasicSolution<TheCase>& solution,
                                          const BasicTrajectory<TheCase>& run, double end);

/// The largest mean tension of one cable over a step of `run` [N], of the steps in which no impact
/// acts; 0 if no cable pulls in them. None: its engine tells no tensions.
[[nodiscard]] std::optional<double> largest_tension(const Trajectory& run);

/// The impulse of the first impact up to `end` [s] that closes faster than `count_speed` [m/s]
/// [N s], of the exact motion and of the run on the same cable; none where several cables share
/// it, or either side has none.
template <class TheCase>
[[nodiscard]] std::optional<ExactAndFound> match_first_impulse(
    const TheCase& the_case, const BasicSolution<TheCase>& solution,
    const BasicTrajectory<TheCase>& run, double count_speed, double end);

}  // namespace tautline::bench
