#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

/// The bouncing ball falls 0.5 to the end of its cable: first impact at time 1 with speed 1.
constexpr double first_fall = 1.0;

class BouncingBall : public ::testing::TestWithParam<double> {};

TEST_P(BouncingBall, BouncesInAGeometricSeries) {
  const double e = GetParam();
  const Solution solution = solve(bouncing_ball(e));
  double time = first_fall;
  double speed = first_fall;
  double worst_time = 0.0;
  double worst_speed = 0.0;
  int impacts = 0;
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    ++impacts;
    worst_time = std::max(worst_time, std::abs(event.time - time));
    worst_speed = std::max({worst_speed, std::abs(event.before.velocity.y() + speed) / speed,
                            std::abs(event.after.velocity.y() - e * speed) / speed});
    speed *= e;
    time += 2.0 * speed;
  }
  ASSERT_GT(impacts, 0);
  constexpr double of_the_time = 1e-14;   // rounding of a sum of some hundred flights
  constexpr double of_the_speed = 1e-11;  // relative, down to bounces of 1e-6: 1e-16 / 1e-6 each
  expect_within("time of an impact", worst_time, of_the_time * time);
  expect_within("relative speed of an impact", worst_speed, of_the_speed);
}

TEST_P(BouncingBall, AccumulatesAtTheLimitOfTheSeries) {
  const double e = GetParam();
  Case ball = bouncing_ball(e);
  const double limit = (1.0 + e) / (1.0 - e) * first_fall;
  ball.duration = limit + 1.0;
  const Solution solution = solve(ball);
  ASSERT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  ASSERT_EQ(solution.accumulations().size(), 1U);
  const Accumulation& end = solution.accumulations().front();
  const State rest = solution.at(ball.duration);
  expect_within("time of the accumulation", std::abs(end.time - limit), 1e-14 * limit);
  // rounding, and the promise
  EXPECT_LE(std::abs(end.time - limit), end.uncertainty + 1e-14 * limit);
  EXPECT_EQ(end.cables, CableSet::of(0));
  EXPECT_EQ(rest.velocity.norm(), 0.0) << "the ball hangs at rest";
  EXPECT_LE(rest.position.norm(), 1e-15) << "at the end of its cable";
}

INSTANTIATE_TEST_SUITE_P(Restitutions, BouncingBall, ::testing::Values(0.1, 0.3, 0.5, 0.7, 0.9));

TEST(BouncingBallLimits, WithoutRestitutionItHangsAtTheFirstImpact) {
  const Solution solution = solve(bouncing_ball(0.0));
  EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  ASSERT_EQ(solution.events().size(), 2U);
  EXPECT_EQ(solution.events()[1].kind, EventKind::taut);
  EXPECT_NEAR(solution.events()[1].time, first_fall, 1e-15);
  EXPECT_EQ(solution.end_time(), bouncing_ball(0.0).duration) << "it is known for all times";
}

TEST(BouncingBallLimits, WithFullRestitutionItNeverTires) {
  Case ball = bouncing_ball(1.0);
  ball.duration = 1000.0;
  const Solution solution = solve(ball);
  EXPECT_EQ(solution.ending(), Ending::reached_duration) << to_string(solution.ending());
  double worst = 0.0;
  double time = first_fall;
  for (const Event& event : solution.events()) {
    worst = std::max(worst, std::abs(event.time - time));
    time += 2.0 * first_fall;
  }
  EXPECT_EQ(solution.events().size(), 500U);         // at 1, 3, 5, ..., 999
  expect_within("time of an impact", worst, 1e-10);  // 500 flights, speed errors add up: n^2 1e-16
}

TEST(CentralImpact, LeavesTheSpinUnchanged) {
  Case ball = bouncing_ball(0.5);
  ball.initial.spin = 0.7;
  ball.initial.velocity = Vec2(0.3, 0.0);
  const Solution solution = solve(ball);
  ASSERT_FALSE(solution.events().empty());
  for (const Event& event : solution.events()) {
    EXPECT_EQ(event.after.spin, 0.7) << "at " << event.time;
  }
}

TEST(CentralImpact, TurnsOnlyTheVelocityAlongTheCable) {
  // the cable's line passes through the centre though its end does not: straight up from the top
  Case the_case;
  the_case.body = {2.0, 0.3};
  the_case.cables = {{Vec2(0.0, 2.0), Vec2(0.0, 0.5), 1.5, 0.6}};
  the_case.initial = {Vec2(0.0, 0.5), 0.0, Vec2(0.0, -1.0), 0.0};
  the_case.duration = 0.9;
  const Solution solution = solve(the_case);
  ASSERT_FALSE(solution.events().empty());
  const Event& first = solution.events().front();
  // falls 0.5 with g = 1 from speed 1: arrives with sqrt(2) at sqrt(2) - 1
  EXPECT_NEAR(first.time, std::sqrt(2.0) - 1.0, 1e-15);
  EXPECT_NEAR(first.after.velocity.y(), 0.6 * std::sqrt(2.0), 1e-15);
  EXPECT_EQ(first.after.velocity.x(), 0.0);
  EXPECT_EQ(first.after.spin, 0.0);
  EXPECT_NEAR(first.impulses[0], 2.0 * 1.6 * std::sqrt(2.0), 1e-14);
}

TEST(ZeroGravity, PointMassCrossesItsDiskInEqualChords) {
  // a billiard in a disk: every chord of an elastic point mass is equally long
  Case the_case;
  the_case.body = {1.0, 0.0};
  the_case.gravity.setZero();
  the_case.cables = {{Vec2(0.0, 0.0), Vec2(0.0, 0.0), 1.0, 1.0}};
  the_case.initial = {Vec2(0.6, 0.0), 0.0, Vec2(0.0, 1.0), 0.0};
  the_case.duration = 99.0;
  const Solution solution = solve(the_case);
  double worst = 0.0;
  double time = 0.8;  // half a chord, at distance 0.6 from the centre
  for (const Event& event : solution.events()) {
    worst = std::max(worst, std::abs(event.time - time));
    time += 1.6;
  }
  EXPECT_EQ(solution.events().size(), 62U);          // at 0.8, 2.4, ..., 98.4
  expect_within("time of an impact", worst, 1e-12);  // 62 chords, errors of angle add up
}

}  // namespace
}  // namespace tautline::test
