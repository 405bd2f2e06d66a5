#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/measure/metrics.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/system_geometry.hpp"

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
template <class TheCase>
[[nodiscard]] std::vector<CountedImpact> counted_impacts(const TheCase& the_case,
                                                         const BasicSolution<TheCase>& solution,
                                                         double count_speed) {
  std::vector<CountedImpact> result;
  for (const BasicEvent<TheCase>& event : solution.events()) {
    for (const std::size_t index : event.cables) {
      if (event.kind == EventKind::impact &&
          -gap_rate(the_case.cables[index], event.before) > count_speed) {
        result.push_back({event.time, index});
      }
    }
  }
  return result;
}

/// The impacts of `run` that close faster than `count_speed` [m/s], in rising time.
template <class TheCase>
[[nodiscard]] std::vector<const BasicRecordedImpact<TheCase>*> counted(
    const BasicTrajectory<TheCase>& run, double count_speed) {
  std::vector<const BasicRecordedImpact<TheCase>*> result;
  for (const BasicRecordedImpact<TheCase>& impact : run.impacts) {
    if (-impact.rate_before > count_speed) {
      result.push_back(&impact);
    }
  }
  return result;
}

/// The same, reduced to what matching needs.
template <class TheCase>
[[nodiscard]] std::vector<CountedImpact> counted_impacts(const BasicTrajectory<TheCase>& run,
                                                         double count_speed) {
  return listed(counted(run, count_speed), [](const BasicRecordedImpact<TheCase>* impact) {
    return CountedImpact{impact->time, impact->cable};
  });
}

/// The impacts up to `end` [s]. Both of a pair belong to the window of the exact one: what the run
/// has a moment after the window is not missed. So no more are matched than there are on either
/// side.
[[nodiscard]] ImpactMatch impacts_until(double end, const std::vector<CountedImpact>& exact,
                                        const std::vector<CountedImpact>& found,
                                        const ImpactPairs& pairs);

}  // namespace tautline::bench
