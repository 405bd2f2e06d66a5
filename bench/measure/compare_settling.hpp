#pragma once

#include <optional>
#include <vector>

#include "bench/measure/compare.hpp"

namespace tautline::bench {

/// The last fast impacts of `run` next to those of `settling`, up to `end` [s].
[[nodiscard]] std::vector<LastImpactMatch> match_last_impacts(const Settling& settling,
                                                              const Trajectory& run, double end);

/// The swing of `run` next to the one that `settling` of `solution` ends in.
[[nodiscard]] std::optional<SwingMatch> match_swing(const Case& the_case, const Solution& solution,
                                                    const Settling& settling,
                                                    const Trajectory& run);

}  // namespace tautline::bench
