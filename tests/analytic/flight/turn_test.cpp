#include "flight/turn.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t turn_seed = 20261125;
constexpr int angles = 200'000;

/// Of sine and cosine [-]: the argument is right to rounding, and so is each number.
constexpr double absolute = 4e-16;

/// Of the versine of a turn up to a radian, however small [-].
constexpr double relative = 6e-16;

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
  const double beyond = 10.0 * farthest_turn;
  EXPECT_EQ(turn(beyond).sine, std::sin(beyond));
}

}  // namespace
}  // namespace tautline::test
