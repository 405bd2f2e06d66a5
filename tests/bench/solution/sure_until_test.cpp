// No run is judged by an exact number that is not sure to a tenth of what is visible.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "bench/measure/horizon.hpp"
#include "bench/measure/reference.hpp"
#include "bench/solution/digits/in_digits.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

constexpr double visible_distance = 1e-3;  // [m], as a run is judged by
constexpr double sure_part = 0.1;          // [-]

/// The standard case this far from the origin [m]: its coordinates are rounded there, so that its
/// doubles are wrong before an engine's run is.
Case far_away(double distance) {
  Case result = shipped_cases().front();
  result.duration = 8.5;  // [s], past the horizon
  const Vec2 shift(distance, distance);
  result.initial.position += shift;
  for (Cable& cable : result.cables) {
    cable.anchor += shift;
  }
  return result;
}

TEST(SureUntil, NoRunIsJudgedByAPositionThatIsNotSureToATenthOfWhatIsVisible) {
  for (const double distance : {0.0, 1e5}) {
    const Case the_case = far_away(distance);
    const std::vector<ReferenceCase> references = solve_cases({the_case}, ImpactLaw::simultaneous);
    const ReferenceCase& reference = references.front();
    const tautline::Digits precision(50);
    const BasicSolution<Multi> truth = solve(in_digits(the_case));
    const auto error = [&](double time) {
      const BasicVec2<Multi> apart =
          in_digits(reference.solution.at(time)).position - truth.at(Multi(time)).position;
      return static_cast<double>(apart.norm());
    };
    double worst = 0.0;
    double worst_judged = 0.0;
    const double by_growth = predictability_horizon(the_case, reference.solution);
    constexpr int samples = 2000;
    for (int sample = 0; sample <= samples; ++sample) {
      const double time = by_growth * sample / samples;
      worst = std::max(worst, error(time));
      worst_judged = time <= reference.horizon ? std::max(worst_judged, error(time)) : worst_judged;
    }
    EXPECT_LE(worst_judged, sure_part * visible_distance) << distance << " m away";
    EXPECT_GT(reference.horizon, 5.0) << distance << " m away: what is sure is judged";
    if (distance > 0.0) {
      EXPECT_GT(worst, sure_part * visible_distance)
          << "growth alone would judge by what is wrong, to t = " << by_growth;
    }
  }
}

}  // namespace
}  // namespace tautline::bench
