#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/callgrind.hpp"

// The cost of the solver in instructions, which callgrind counts: the same at any load, and nearly
// so for one compiler and mathematical library.

namespace tautline {
namespace {

/// [instructions per impact], with all that comes between two: the shipped cases swing on taut
/// cables for some of their time. 9,230 when it was set, with Eigen's assertions; compilers differ
/// by a tenth.
constexpr double most_per_impact = 10'600.0;

/// [instructions per impact], what the bounds of a solution take besides, with the search for
/// tensions that touch zero: 10,750 when it was set.
constexpr double most_of_bounds = 12'400.0;

/// [-], an impact in space against one of the same motion in the plane, both of systems. 2.0 when
/// it was set.
constexpr double most_in_space = 3.0;

test::Counted cost(const std::string& what) {
  return test::counted(TAUTLINE_SOLVE_SHIPPED, what, " impacts");
}

TEST(Counts, AnImpactInSpaceTakesUpToThreeTimesOneInThePlane) {
  const test::Counted load = cost("systems");
  if (load.instructions < 0.0) {
    GTEST_SKIP() << "valgrind is not here, or does not know this processor";
  }
  const test::Counted plane = cost("plane");
  const test::Counted space = cost("space");
  ASSERT_GT(plane.things, 0.0);
  ASSERT_EQ(plane.things, space.things);
  const double in_plane = (plane.instructions - load.instructions) / plane.things;
  const double in_space = (space.instructions - load.instructions) / space.things;
  std::printf("%.0f instructions per impact in the plane, %.0f in space\n", in_plane, in_space);
  EXPECT_LE(in_space, most_in_space * in_plane);
}

TEST(Counts, ASolutionAndItsBoundsTakeTheirInstructions) {
  const test::Counted load = cost("load");
  if (load.instructions < 0.0) {
    GTEST_SKIP() << "valgrind is not here, or does not know this processor";
  }
  const test::Counted plain = cost("plain");
  const test::Counted bounds = cost("bounds");
  ASSERT_GT(plain.things, 0.0);
  ASSERT_GT(plain.instructions, load.instructions);
  const double solving = plain.instructions - load.instructions;
  const double bounding = bounds.instructions - plain.instructions;
  std::printf("%.0f instructions per impact, %.0f more with bounds\n", solving / plain.things,
              bounding / plain.things);
  EXPECT_LE(solving / plain.things, most_per_impact);
  EXPECT_GT(bounding, 0.0);
  EXPECT_LE(bounding / plain.things, most_of_bounds);
}

}  // namespace
}  // namespace tautline
