#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <map>

#include "hard_families.hpp"
#include "stopwatch.hpp"
#include "support.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

// Random systems from families that are hard for a double. TAUTLINE_HARD_SYSTEMS in the environment
// says how many of each family; the hundred of a usual run take seconds.

namespace tautline::test {
namespace {

int systems_of_a_family() {
  const char* const asked = std::getenv("TAUTLINE_HARD_SYSTEMS");
  return asked != nullptr ? std::atoi(asked) : 15;
}

constexpr double most_standard_cases = 7000.0;  // as long as so many take, in processor time

class HardFamilies : public ::testing::TestWithParam<HardFamily> {};

TEST_P(HardFamilies, EndInTimeAndTruthfully) {
  Random random(hard_seed);
  double slowest = 0.0;
  double gain = 0.0;
  double overstretch = 0.0;
  int refused = 0;
  std::map<std::string_view, int> endings;
  const int count = systems_of_a_family();
  for (int sample = 0; sample < count; ++sample) {
    SCOPED_TRACE("seed " + std::to_string(hard_seed) + " sample " + std::to_string(sample));
    const auto drawn = hard_system(random, GetParam(), sample);
    if (!drawn) {
      ++refused;
      continue;
    }
    const Case& the_case = drawn->the_case;
    SolveOptions options;
    options.law = drawn->law;
    const std::clock_t begin = std::clock();
    const Solution solution = solve(the_case, options);
    slowest = std::max(slowest, seconds_since(begin));
    ++endings[to_string(solution.ending())];
    for (const Event& event : solution.events()) {
      const double change = energy(the_case, event.after) - energy(the_case, event.before);
      gain = std::max(gain, change / rounding_of_energy(the_case, event.before));
      for (const Cable& cable : the_case.cables) {
        // far away lengths are given to 1e-10 m, and a wedge multiplies that by one over its sine
        constexpr double wedge = 1000.0;  // [-]
        const double moved =              // while time advances by a rounding
            epsilon<double>() * event.time * speed_scale(the_case, event.before);
        const double told = wedge * (rounding_of_gap(cable, event.after) + moved);
        overstretch = std::max(overstretch, (-gap(cable, event.after) - told) / cable.length);
      }
      ASSERT_TRUE(std::isfinite(change)) << "at " << event.time;
    }
  }
  for (const auto& [ending, times] : endings) {
    std::cout << "  " << ending << ": " << times << '\n';
  }
  EXPECT_LE(10 * refused, count);
  expect_within("slowest, of the standard case's time", slowest / time_of_standard_case(),
                most_standard_cases);
  expect_within("energy gained by an event [roundings]", gain, 1000.0);
  expect_within("overstretch after an event, beyond rounding, of the length", overstretch, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Random, HardFamilies, ::testing::ValuesIn(hard_families()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tautline::test
