#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/callgrind.hpp"

// The cost of the solver in instructions, which callgrind counts: the same at any load, and nearly
// so for one compiler and mathematical library.

namespace tautline {
namespace {

/// [instructions per impact], with all that comes between two: the shipped cases swing on taut
/// cables for most of their time. 20,000 when it was set, with Eigen's assertions; compilers differ
/// by a tenth.
constexpr double most_per_impact = 23'000.0;

/// [-], of the instructions of a solution without bounds: 1.61 when it was set.
constexpr double most_with_bounds = 1.75;

TEST(Counts, ASolutionTakesItsInstructionsAndItsBoundsThreeQuartersMore) {
  const auto cost = [](const std::string& what) {
    return test::counted(TAUTLINE_SOLVE_SHIPPED, what, " impacts");
  };
  const test::Counted load = cost("load");
  if (load.instructions < 0.0) {
    GTEST_SKIP() << "valgrind is not here, or does not know this processor";
  }
  const test::Counted plain = cost("plain");
  const test::Counted bounds = cost("bounds");
  ASSERT_GT(plain.things, 0.0);
  ASSERT_GT(plain.instructions, load.instructions);
  const double solving = plain.instructions - load.instructions;
  const double with_bounds = (bounds.instructions - load.instructions) / solving;
  std::printf("%.0f instructions per impact, %.2f times as many with bounds\n",
              solving / plain.things, with_bounds);
  EXPECT_LE(solving / plain.things, most_per_impact);
  EXPECT_GT(with_bounds, 1.0);
  EXPECT_LE(with_bounds, most_with_bounds);
}

}  // namespace
}  // namespace tautline
