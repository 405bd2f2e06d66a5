#pragma once

#include <optional>
#include <vector>

#include "bench/measure/metrics.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// The last fast impacts of `run` next to those of `settling`, up to `end` [s]. Neither where the
/// exact motion locks beyond its `horizon` [s]: both are one draw of many, and their distributions
/// are to be compared.
/// `settling` is a `Settling` or a `SystemSettling`.
template <class TheSettling, class TheCase>
[[nodiscard]] std::vector<LastImpactMatch> match_last_impacts(const TheSettling& settling,
                                                              double horizon,
                                                              const BasicTrajectory<TheCase>& run,
                                                              double end) {
  std::vector<LastImpactMatch> result;
  for (const LastImpact& exact : settling.last_impacts) {
    LastImpactMatch match{exact.speed, {}, {}};
    if (settling.lock && settling.lock->time <= horizon) {
      match.exact = exact.time;
      if (reaches(run, exact.time.value_or(0.0))) {
        for (const BasicRecordedImpact<TheCase>& impact : run.impacts) {
          if (-impact.rate_before > exact.speed && impact.time <= end) {
            match.found = impact.time;
          }
        }
      }
    }
    result.push_back(match);
  }
  return result;
}

/// The swing that `solution` ends in, with its `lock`, if it has one and lasts for a period of it.
[[nodiscard]] std::optional<Swing> measured_swing(const Case& the_case, const Solution& solution,
                                                  const std::optional<Lock>& lock);

/// The swing of `run` next to the one that `settling` of `solution` ends in.
[[nodiscard]] std::optional<SwingMatch> match_swing(const Case& the_case, const Solution& solution,
                                                    const Settling& settling,
                                                    const Trajectory& run);

}  // namespace tautline::bench
