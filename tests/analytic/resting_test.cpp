#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t resting_seed = 47;
constexpr int resting_samples = 2000;

TEST(Geometry, GapRateIsTheDerivativeOfTheGap) {
  Random random(resting_seed);
  double worst = 0.0;
  constexpr double dt = 1e-5;
  for (int sample = 0; sample < resting_samples; ++sample) {
    const Case the_case = random_case(random, {1, 0.1, 0.0});
    const Cable& cable = the_case.cables.front();
    if ((attachment_point(the_case.initial, cable) - cable.anchor).norm() < 0.3) {
      continue;  // curvature there grows like 1 / distance, and the difference quotient fails
    }
    const State later = fly(the_case.initial, the_case.gravity, dt);
    const State earlier = fly(the_case.initial, the_case.gravity, -dt);
    const double rate = (gap(cable, later) - gap(cable, earlier)) / (2.0 * dt);
    const double acceleration = (gap_rate(cable, later) - gap_rate(cable, earlier)) / (2.0 * dt);
    worst =
        std::max({worst, std::abs(rate - gap_rate(cable, the_case.initial)),
                  std::abs(acceleration - free_gap_acceleration(the_case, 0, the_case.initial))});
  }
  constexpr double difference_quotient = 1e-6;  // dt^2 / 6 times derivatives up to 1e4
  expect_within("rate and acceleration", worst, difference_quotient);
}

TEST(Geometry, GapGradientTimesVelocityIsTheGapRate) {
  Random random(resting_seed);
  double worst = 0.0;
  for (int sample = 0; sample < resting_samples; ++sample) {
    const Case the_case = random_case(random, {1, 0.1, 0.0});
    const Cable& cable = the_case.cables.front();
    const State& q = the_case.initial;
    const Eigen::Vector3d velocity(q.velocity.x(), q.velocity.y(), q.spin);
    worst = std::max(worst, std::abs(gap_gradient(cable, q).dot(velocity) - gap_rate(cable, q)));
  }
  expect_within("gradient times velocity", worst, 1e-14);
}

TEST(RestingTensions, OfTheBreakwaterAtRestShareItsWeight) {
  for (const TableRow& row : table_5_1()) {
    const Case the_case = breakwater(row.parameters, std::string(row.number));
    const CableSet both = CableSet::of(0) | CableSet::of(1);
    const auto held = resting_tensions(the_case, State{}, both);
    ASSERT_TRUE(held.has_value()) << row.number;
    // r / (2 h): the vertical parts of two equal tensions are the weight
    const double h = the_case.cables[0].anchor.y() - row.parameters.b;
    const double expected = row.parameters.r / (2.0 * h);
    EXPECT_NEAR(held->tension[0], expected, 1e-13) << row.number;
    EXPECT_NEAR(held->tension[1], expected, 1e-13) << row.number;
  }
}

TEST(RestingTensions, OfAHangingPendulumAreWeightAndCentripetalForce) {
  Case ball = bouncing_ball();
  ball.initial = {Vec2(0.0, 0.0), 0.0, Vec2(0.6, 0.0), 0.0};
  const auto held = resting_tensions(ball, ball.initial, CableSet::of(0));
  ASSERT_TRUE(held.has_value());
  EXPECT_NEAR(held->tension[0], 1.0 + 0.36 / 2.0, 1e-15);
  EXPECT_NEAR(held->acceleration[0], 0.0, 1e-15);
}

TEST(RestingTensions, VanishWhereTheBodyFallsAwayFromTheCable) {
  Case ball = bouncing_ball();
  ball.initial.position = Vec2(0.0, 4.0);  // above the anchor, at the end of the cable
  const auto held = resting_tensions(ball, ball.initial, CableSet::of(0));
  ASSERT_TRUE(held.has_value());
  EXPECT_EQ(held->tension[0], 0.0);
  EXPECT_NEAR(held->acceleration[0], 1.0, 1e-15);
}

}  // namespace
}  // namespace tautline::test
