#include "flight/turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support.hpp"
#include "tautline/geometry.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t turn_seed = 20261125;
constexpr int angles = 200'000;

/// Of sine and cosine [-]: the argument is right to rounding, and so is each number.
constexpr double absolute = 4e-16;

/// Of the versine of a turn up to a radian, however small [-].
constexpr double relative = 6e-16;

/// Of sine, cosine and the angle of a vector against those of a long double, of their size [-].
constexpr double three_roundings = 3 * 2.3e-16;

/// Of a root [-], which sets the length of a step.
constexpr double of_a_root = 1e-9;

/// Angles of all sizes, and those next to the quarters of a turn.
double some_angle(Random& random) {
  const double sign = random.chance(0.5) ? 1.0 : -1.0;
  if (random.chance(0.3)) {
    const double quarters = std::floor(random.uniform(0.0, farthest_turn / 2.0));
    return sign * (quarters * std::numbers::pi / 2.0 + random.log_uniform(1e-16, 1.0));
  }
  return sign * random.log_uniform(1e-12, farthest_turn);
}

TEST(Turn, DirectionsAreRightUpToTheFarthestTurn) {
  Random random(turn_seed);
  double worst = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double angle = some_angle(random);
    const auto [cosine, sine] = direction(angle);
    const long double exact = angle;
    worst = std::max({worst, static_cast<double>(std::abs(cosine - std::cos(exact))),
                      static_cast<double>(std::abs(sine - std::sin(exact)))});
  }
  expect_within("error of a sine or cosine", worst, absolute);
}

TEST(Turn, SmallTurnsKeepTheirDigits) {
  Random random(turn_seed);
  double worst = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double angle = random.log_uniform(1e-12, 1.0);
    const auto [sine, versine] = turn(angle);
    const long double half = std::sin(static_cast<long double>(angle) / 2);
    const long double exact = 2 * half * half;
    const long double exact_sine = std::sin(static_cast<long double>(angle));
    worst = std::max({worst, static_cast<double>(std::abs(versine / exact - 1)),
                      static_cast<double>(std::abs(sine / exact_sine - 1))});
  }
  expect_within("error of sine and versine, of their size", worst, relative);
}

TEST(Turn, LargeTurnsAreRightAndJoinTheSmallOnes) {
  Random random(turn_seed);
  double worst = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double angle = k % 2 == 0 ? random.uniform(0.9, 1.1) : some_angle(random);
    const auto [sine, versine] = turn(angle);
    const long double exact = angle;
    worst = std::max({worst, static_cast<double>(std::abs(versine - (1 - std::cos(exact)))),
                      static_cast<double>(std::abs(sine - std::sin(exact)))});
  }
  expect_within("error of sine and versine", worst, absolute);
}

TEST(Elementary, SineAndCosineAreRightAtEveryAngle) {
  Random random(turn_seed);
  double worst = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double angle = k % 2 == 0 ? some_angle(random) : random.log_uniform(1e-300, 1e308);
    const long double exact = angle;
    worst = std::max({worst, static_cast<double>(std::abs(sin(angle) / std::sin(exact) - 1)),
                      static_cast<double>(std::abs(cos(angle) / std::cos(exact) - 1))});
    ASSERT_EQ(sin(-angle), -sin(angle)) << angle;
    ASSERT_EQ(cos(-angle), cos(angle)) << angle;
  }
  expect_within("error of a sine or cosine, of its size", worst, three_roundings);
  EXPECT_EQ(sin(5e-324), 5e-324);
  EXPECT_EQ(cos(0.0), 1.0);
  for (const double none : {infinity<double>(), -infinity<double>(), not_a_number<double>()}) {
    EXPECT_TRUE(isnan(sin(none)) && isnan(cos(none)));
  }
}

TEST(Elementary, HeadingsAreTheSameSinesAndCosines) {
  for (const double angle : {0.3, 2.0, -7e4, 3e5, 1e19}) {
    EXPECT_EQ(heading(angle).cosine, cos(angle));
    EXPECT_EQ(heading(angle).sine, sin(angle));
  }
}

TEST(Elementary, TheAngleOfAVectorIsRight) {
  Random random(turn_seed);
  double worst = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double size = random.log_uniform(1e-150, 1e300);
    const double x = size * random.uniform(-1.0, 1.0);
    const double y =
        k % 2 == 0 ? size * random.uniform(-1.0, 1.0) : x * random.log_uniform(1e-9, 1e7);
    const long double exact = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    worst = std::max(worst, static_cast<double>(std::abs(atan2(y, x) / exact - 1)));
  }
  expect_within("error of an angle, of its size", worst, three_roundings);
  for (const double y : {0.0, -0.0, 1.0, -1.0}) {
    for (const double x : {0.0, -0.0, 1.0, -1.0}) {
      EXPECT_DOUBLE_EQ(atan2(y, x), std::atan2(y, x)) << y << ", " << x;
      EXPECT_EQ(std::signbit(atan2(y, x)), std::signbit(std::atan2(y, x))) << y << ", " << x;
    }
  }
}

TEST(Elementary, RootsAreRightEnoughForALengthOfAStep) {
  Random random(turn_seed);
  double worst = 0.0;
  for (int k = 0; k < angles; ++k) {
    const double value = random.log_uniform(1e-300, 1e300);
    const double degree = 1.0 + k % 64;
    worst = std::max(worst, std::abs(root(value, degree) / std::pow(value, 1.0 / degree) - 1.0));
  }
  expect_within("error of a root, of its size", worst, of_a_root);
  EXPECT_EQ(root(0.0, 3.0), 0.0);
  EXPECT_EQ(root(infinity<double>(), 28.0), infinity<double>());
  EXPECT_NEAR(root(5e-324, 28.0), std::pow(5e-324, 1.0 / 28.0), of_a_root);
  EXPECT_TRUE(isnan(root(not_a_number<double>(), 2.0)));
}

}  // namespace
}  // namespace tautline::test
