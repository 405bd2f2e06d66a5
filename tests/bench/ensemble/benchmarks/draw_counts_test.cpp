#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/callgrind.hpp"

// What a draw of an ensemble costs, its exact motion and all beside it, in instructions, which
// callgrind counts.

namespace tautline::bench {
namespace {

/// [instructions per draw] of the standard case, whose motions to 20 s have some 900 impacts:
/// 130,000 with Eigen's assertions and normal numbers of 64 bits; compilers differ by a tenth.
/// Normal numbers by integers alone take 120,000 more, statistics that are looked up by their names
/// at every impact 300,000, and so do rates of every impact.
constexpr double most_beside_the_motion = 160'000.0;

/// [instructions per draw], of that motion: 4,050,000 when it was set. Where the swing at its end
/// is followed instead of told ahead it takes 930,000 more.
constexpr double most_of_the_motion = 4'500'000.0;

TEST(Counts, ADrawAndItsMotionTakeTheirInstructions) {
  const auto counted = [](const std::string& what) {
    return test::counted(TAUTLINE_SOLVE_DRAWS, what, " draws");
  };
  const test::Counted nothing = counted("nothing");
  if (nothing.instructions < 0.0) {
    GTEST_SKIP() << "valgrind is not here, or does not know this processor";
  }
  const test::Counted motions = counted("motions");
  const test::Counted cases = counted("cases");
  const test::Counted draws = counted("draws");
  ASSERT_GT(draws.things, 0.0);
  ASSERT_EQ(draws.things, motions.things);
  // both make the cases of the draws: that is no part of the motions
  const double motion = (motions.instructions - cases.instructions) / draws.things;
  const double all = (draws.instructions - nothing.instructions) / draws.things;
  std::printf("%.0f instructions for a motion, %.0f for the rest of a draw\n", motion,
              all - motion);
  EXPECT_GT(motion, 0.0);
  EXPECT_LE(motion, most_of_the_motion);
  EXPECT_GT(all, motion) << "both solve the draws side by side";
  EXPECT_LE(all - motion, most_beside_the_motion);
}

}  // namespace
}  // namespace tautline::bench
