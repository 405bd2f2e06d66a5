#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "slow_bounces.hpp"
#include "support.hpp"
#include "tautline/detail/accumulation.hpp"

// When bounces are tried as the end of an accumulation, and when again.

namespace tautline::test {
namespace {

constexpr double untried = std::numeric_limits<double>::infinity();
constexpr double one_gap_rounding = 2.2e-16;  // [m], of a gap
constexpr double resting_rate = 1e-15;        // [m/s]

/// Of a body under gravity on cables of 1 m, by the default limits.
auto dealt_with(double kept, double rebound, double tried) {
  const Scales<double> scale(9.81, 0.5, 1.0, 1.0, 0.0, CompletionLimits{}.margin);
  return next_attempt(kept, one_gap_rounding, resting_rate, rebound, tried, CompletionLimits{},
                      scale);
}

constexpr double fast_rebound = 1e-2;  // [m/s]
constexpr double slow_rebound = 5e-7;  // not low: 1e-14 m, many roundings of the gap
constexpr double low_rebound = 1e-8;   // 5e-18 m

TEST(NextAttempt, FastBouncesAreNotDueAndForgetWhatWasTried) {
  EXPECT_FALSE(dealt_with(0.9, fast_rebound, untried).is_due);
  EXPECT_FALSE(dealt_with(0.9, fast_rebound, slow_rebound).is_due);
  EXPECT_EQ(dealt_with(0.9, fast_rebound, slow_rebound).tried, untried);
}

TEST(NextAttempt, SlowBouncesAreTriedAgainAtHalfTheirSpeed) {
  EXPECT_TRUE(dealt_with(0.9, slow_rebound, untried).is_due);
  EXPECT_FALSE(dealt_with(0.9, 0.51 * slow_rebound, slow_rebound).is_due);
  EXPECT_EQ(dealt_with(0.9, 0.51 * slow_rebound, slow_rebound).tried, slow_rebound);
  EXPECT_TRUE(dealt_with(0.9, 0.5 * slow_rebound, slow_rebound).is_due);
}

TEST(NextAttempt, LowBouncesAreTriedAgainAfterFour) {
  const double e = 0.9;
  EXPECT_TRUE(dealt_with(e, low_rebound, untried).is_due);
  EXPECT_FALSE(dealt_with(e, e * e * e * low_rebound, low_rebound).is_due);
  EXPECT_TRUE(dealt_with(e, 0.999 * e * e * e * e * low_rebound, low_rebound).is_due);
  EXPECT_TRUE(dealt_with(1.0, low_rebound, low_rebound).is_due)
      << "an elastic one would not be at half of it";
  EXPECT_FALSE(dealt_with(0.5, 0.51 * low_rebound, low_rebound).is_due);
  EXPECT_TRUE(dealt_with(0.5, 0.5 * low_rebound, low_rebound).is_due) << "after one";
  EXPECT_TRUE(dealt_with(0.0, 0.5 * low_rebound, low_rebound).is_due);
}

TEST(NextAttempt, FasterBouncesThanAtTheLastAttemptAreOthers) {
  for (const double speed : {slow_rebound, low_rebound}) {
    EXPECT_TRUE(dealt_with(0.9, 1.001 * speed, speed).is_due);
    EXPECT_EQ(dealt_with(0.9, 1.001 * speed, speed).tried, untried);
  }
}

TEST(NextAttempt, RestingClosingOrNaNIsDue) {
  for (const double rebound : {resting_rate, 0.0, -fast_rebound, std::nan("")}) {
    EXPECT_TRUE(dealt_with(0.9, rebound, low_rebound).is_due) << rebound;
  }
}

}  // namespace
}  // namespace tautline::test
