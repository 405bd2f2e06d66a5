// Restitution that depends on the speed of the impact.

#include <gtest/gtest.h>

#include <cmath>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

Cable measured() {
  Cable cable;
  cable.restitution_table = {{0.5, 0.875}, {1.0, 0.75}, {3.0, 0.25}};
  return cable;
}

TEST(Restitution, IsTheCablesOwnWithoutTableAndCaptureSpeed) {
  Cable cable;
  cable.restitution = 0.7;
  EXPECT_FALSE(depends_on_speed(cable));
  for (const double rate : {-1e20, -1.0, 0.0, 2.0}) {
    EXPECT_EQ(restitution(cable, rate), 0.7);
    EXPECT_EQ(restitution_up_to(cable, std::abs(rate)), 0.7);
  }
}

TEST(Restitution, IsLinearBetweenThePointsAndConstantBeyond) {
  const Cable cable = measured();
  EXPECT_TRUE(depends_on_speed(cable));
  const std::vector<std::pair<double, double>> expected = {
      {0.0, 0.875}, {0.5, 0.875}, {0.75, 0.8125}, {1.0, 0.75},
      {2.0, 0.5},   {3.0, 0.25},  {1e20, 0.25}};
  for (const auto& [speed, value] : expected) {
    EXPECT_EQ(restitution(cable, -speed), value) << "at " << speed;
    EXPECT_EQ(restitution(cable, speed), value) << "at " << speed;
  }
}

TEST(Restitution, IsZeroBelowTheCaptureSpeedOnly) {
  Cable cable = measured();
  cable.capture_speed = 0.75;
  EXPECT_EQ(restitution(cable, -0.7499), 0.0);
  EXPECT_EQ(restitution(cable, -0.75), 0.8125);
}

TEST(Restitution, IsNeverAboveItsBoundUpToASpeed) {
  Random random(7);
  for (int sample = 0; sample < 2000; ++sample) {
    Cable cable;
    cable.restitution = random.uniform(0.0, 1.0);
    cable.capture_speed = random.chance(0.5) ? random.uniform(0.0, 2.0) : 0.0;
    double speed = 0.0;
    for (int points = static_cast<int>(random.uniform(0.0, 5.0)); points > 0; --points) {
      speed += random.uniform(0.01, 1.0);
      cable.restitution_table.push_back({speed, random.uniform(0.0, 1.0)});
    }
    const double top = random.uniform(0.0, 4.0);
    const double bound = restitution_up_to(cable, top);
    double reached = 0.0;
    constexpr int parts = 1000;
    for (int part = 0; part <= parts; ++part) {
      const double value = restitution(cable, top * part / parts);
      EXPECT_LE(value, bound + 1e-15);  // interpolation rounds
      reached = std::max(reached, value);
    }
    // and the bound is reached, but for the grid: slopes are below 1 / 0.01
    EXPECT_GE(reached, bound - 100.0 * top / parts);
  }
}

/// Gravity 1, a fall of 1/2: every impact of speed v follows one of speed e(v) v after 2 e(v) v.
TEST(DroppedBall, BouncesAsItsTableSays) {
  Case ball = bouncing_ball();
  ball.cables.front().restitution_table = {{0.25, 0.5}, {1.25, 1.0}};  // e = 3/8 + v/2
  ball.duration = 10.0;
  const Solution solution = solve(ball);
  double speed = 1.0;
  double time = 1.0;
  ASSERT_GE(solution.events().size(), 4U);
  for (std::size_t index = 0; index < 4; ++index) {
    const Event& event = solution.events()[index];
    const double e = std::max(0.5, 0.375 + 0.5 * speed);
    constexpr double rounding = 1e-14;
    EXPECT_NEAR(event.time, time, rounding) << index;
    EXPECT_NEAR(event.before.velocity.y(), -speed, rounding) << index;
    EXPECT_NEAR(event.after.velocity.y(), e * speed, rounding) << index;
    speed *= e;
    time += 2.0 * speed;
  }
}

TEST(DroppedBall, StopsBouncingAtItsCaptureSpeed) {
  Case ball = bouncing_ball();  // e = 1/2: impacts of speed 1, 1/2, 1/4, ...
  ball.cables.front().capture_speed = 0.2;
  ball.duration = 10.0;
  const Solution solution = solve(ball);
  std::size_t impacts = 0;
  const Event* last = nullptr;
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      ++impacts;
      last = &event;
    }
  }
  // the fourth, of speed 1/8, ends it: at 1 + 1 + 1/2 + 1/4
  ASSERT_EQ(impacts, 4U);
  EXPECT_NEAR(last->time, 2.75, 1e-14);
  EXPECT_NEAR(last->after.velocity.y(), 0.0, 1e-15);
  EXPECT_EQ(solution.ending(), Ending::rest);
  EXPECT_TRUE(solution.accumulations().empty());
}

TEST(AllLaws, UseTheRestitutionOfEachCablesOwnSpeed) {
  // cables at right angles do not feel each other: each rebounds by its own e(v)
  Case the_case;
  the_case.body = {1.0, 0.0};
  the_case.cables.assign(2, measured());
  the_case.cables[0].anchor = Vec2(0.0, 1.0);
  the_case.cables[1].anchor = Vec2(1.0, 0.0);
  the_case.cables[1].capture_speed = 0.25;
  the_case.initial.velocity = Vec2(-0.125, -2.0);
  for (const ImpactLaw law : impact_laws) {
    const State after =
        resolve_impact(law, the_case, the_case.initial, CableSet::of(0) | CableSet::of(1)).after;
    EXPECT_NEAR(after.velocity.y(), 1.0, 1e-14) << to_string(law);
    EXPECT_NEAR(after.velocity.x(), 0.0, 1e-14) << to_string(law);
  }
}

}  // namespace
}  // namespace tautline::test
