#pragma once

#include <optional>
#include <vector>

#include "bench/measure/impact_match.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// How far the matched impacts of a run are from the exact ones, at worst; of those of one cable
/// alone, as what several share is one velocity jump.
struct ImpactErrors {
  std::optional<double> impulse;      // [%] of the exact impulse of the cable
  std::optional<double> energy_loss;  // [J], of impacts of a single step
};

/// Over `pairs` of the impacts of `solution` and `run` that close faster than `count_speed` [m/s],
/// as `match_impacts` gave them for `exact`, up to `end` [s]; none without a pair.
template <class TheCase>
[[nodiscard]] ImpactErrors impact_errors(const TheCase& the_case,
                                         const BasicSolution<TheCase>& solution,
                                         const BasicTrajectory<TheCase>& run, double count_speed,
                                         const std::vector<CountedImpact>& exact,
                                         const ImpactPairs& pairs, double end);

}  // namespace tautline::bench
