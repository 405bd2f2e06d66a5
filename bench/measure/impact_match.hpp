#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "bench/measure/metrics.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// An impact of either side, reduced to what matching needs.
struct CountedImpact {
  double time;        // [s]
  std::size_t cable;  //
};

/// Pairs of indices into `exact` and `found`: on one cable, each the other's nearest in time. One
/// to one by construction and free of any width to tune.
using ImpactPairs = std::vector<std::pair<std::size_t, std::size_t>>;
[[nodiscard]] ImpactPairs match_impacts(const std::vector<CountedImpact>& exact,
                                        const std::vector<CountedImpact>& found);

/// The impacts of a solution whose fastest cable closes faster than `count_speed`, one entry a
/// cable.
[[nodiscard]] std::vector<CountedImpact> counted_impacts(const Case& the_case,
                                                         const Solution& solution,
                                                         double count_speed);

/// The impacts of `run` that close faster than `count_speed` [m/s], in rising time.
[[nodiscard]] std::vector<const RecordedImpact*> counted(const Trajectory& run, double count_speed);

/// The same, reduced to what matching needs.
[[nodiscard]] std::vector<CountedImpact> counted_impacts(const Trajectory& run, double count_speed);

/// The impacts up to `end` [s]. Both of a pair belong to the window of the exact one: what the run
/// has a moment after the window is not missed. So no more are matched than there are on either
/// side.
[[nodiscard]] ImpactMatch impacts_until(double end, const std::vector<CountedImpact>& exact,
                                        const std::vector<CountedImpact>& found,
                                        const ImpactPairs& pairs);

}  // namespace tautline::bench
