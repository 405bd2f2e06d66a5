#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support.hpp"
#include "tautline/detail/first_contact.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

TEST(Endings, ReachedDurationIsTheDurationExactly) {
  Case the_case = table_case("1110121100");
  the_case.duration = 0.3;  // not a sum of the flights before it
  const Solution solution = solve(the_case);
  EXPECT_EQ(solution.ending(), Ending::reached_duration);
  EXPECT_EQ(solution.end_time(), 0.3);
  EXPECT_TRUE(solution.accumulations().empty());
}

TEST(Endings, AngleLimitEndsTheElasticCaseAtARightAngle) {
  const Case the_case = breakwater(table_row("1110121100"), "elastic", ChapterLimits::on);
  const Solution solution = solve(the_case);
  ASSERT_EQ(solution.ending(), Ending::angle_limit) << to_string(solution.ending());
  constexpr double known = 10.42331;  // five decimals, computed with 60-digit arithmetic
  expect_within("error of the time", std::abs(solution.end_time() - known), 0.5e-5);
  const double angle = std::abs(solution.at(solution.end_time()).angle);
  expect_within("error of the angle", std::abs(angle - 0.5 * std::numbers::pi), 1e-15);
}

TEST(Endings, CeilingEndsAnAscent) {
  // level, upwards with 2 from 0.1: the attachments reach 1.2 at 2 - sqrt(1.8)
  Breakwater p;
  p.initial = {Vec2(0.0, 0.1), 0.0, Vec2(0.0, 2.0), 0.0};
  const Solution solution = solve(breakwater(p, "ascent", ChapterLimits::on));
  ASSERT_EQ(solution.ending(), Ending::ceiling) << to_string(solution.ending());
  expect_within("error of the time", std::abs(solution.end_time() - (2.0 - std::sqrt(1.8))), 1e-15);
}

TEST(Endings, CeilingIsNotMetByAnAscentThatStaysBelow) {
  Breakwater p;  // the summit is 1e-9 below 1.2
  p.initial = {Vec2(0.0, 0.1), 0.0, Vec2(0.0, std::sqrt(2.2 - 2e-9)), 0.0};
  p.duration = 2.0;
  const Solution solution = solve(breakwater(p, "ascent", ChapterLimits::on));
  EXPECT_EQ(solution.ending(), Ending::reached_duration) << to_string(solution.ending());
}

TEST(Endings, EventLimitSaysSo) {
  SolveOptions options;
  options.max_events = 7;
  const Solution solution = solve(table_case("1110121100"), options);
  EXPECT_EQ(solution.ending(), Ending::event_limit);
  EXPECT_EQ(solution.events().size(), 7U);
  EXPECT_EQ(solution.end_time(), solution.events().back().time);
  EXPECT_EQ(difference(solution.at(solution.end_time()), solution.events().back().after), 0.0);
}

TEST(Endings, WithoutRestitutionACableIsTautFromItsFirstImpactOn) {
  Breakwater p = table_row("1910121100");
  p.e = 0.0;
  const Case the_case = breakwater(p, "inelastic");
  const Solution solution = solve(the_case);
  EXPECT_EQ(solution.ending(), Ending::reached_duration) << to_string(solution.ending());
  ASSERT_GE(solution.events().size(), 3U);
  EXPECT_EQ(solution.events()[0].kind, EventKind::impact);
  EXPECT_EQ(solution.events()[1].kind, EventKind::taut);
  EXPECT_NEAR(solution.events()[1].time, 0.05819747296988460, 1e-15);
  const State held = solution.events()[1].after;
  EXPECT_NEAR(gap_rate(the_case.cables[0], held), 0.0, 1e-15);
  for (double time = 0.06; time < solution.events()[2].time; time += 0.01) {
    EXPECT_NEAR(gap(the_case.cables[0], solution.at(time)), 0.0, 1e-15) << time;
  }
}

TEST(Endings, ABodyThatHangsAtRestIsAtRestAtOnce) {
  Breakwater p;
  p.initial = {};
  const Solution solution = solve(breakwater(p, "at rest"));
  EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  EXPECT_EQ(solution.end_time(), p.duration);
  ASSERT_EQ(solution.events().size(), 1U);
  EXPECT_EQ(solution.events().front().kind, EventKind::taut);
  EXPECT_EQ(solution.events().front().cables.size(), 2U);
  EXPECT_LE(difference(solution.at(p.duration), p.initial), 1e-15);
}

TEST(Endings, AClosingCableAtZeroGapIsHitAtTheStart) {
  Case ball = bouncing_ball(0.5);
  ball.initial.position.y() = 0.0;
  ball.initial.velocity.y() = -1.0;
  const Solution solution = solve(ball);
  ASSERT_GE(solution.events().size(), 2U);
  EXPECT_EQ(solution.events()[0].time, 0.0);
  EXPECT_DOUBLE_EQ(solution.events()[0].after.velocity.y(), 0.5);
  EXPECT_NEAR(solution.events()[1].time, 1.0, 1e-15);
  EXPECT_DOUBLE_EQ(solution.at(0.0).velocity.y(), 0.5) << "at an event, the state after it";
}

TEST(Endings, AStretchedCableThatMovesAwayIsNotHit) {
  Case ball = bouncing_ball(0.5);
  ball.initial.position.y() = 0.0;
  ball.initial.velocity.y() = 1.0;
  const Solution solution = solve(ball);
  ASSERT_FALSE(solution.events().empty());
  EXPECT_NEAR(solution.events().front().time, 2.0, 1e-15);
}

TEST(Endings, WithoutGravityABodyAtRestStaysWhereItIs) {
  Case ball = bouncing_ball(0.5);
  ball.gravity.setZero();
  const Solution slack = solve(ball);
  EXPECT_EQ(slack.ending(), Ending::reached_duration) << to_string(slack.ending());
  EXPECT_TRUE(slack.events().empty());
  ball.initial.position.y() = 0.0;
  const Solution stretched = solve(ball);
  EXPECT_LE(stretched.events().size(), 1U);
  EXPECT_EQ(difference(stretched.at(stretched.end_time()), ball.initial), 0.0);
}

TEST(Endings, WithoutGravityASpinningBodyOnACentralCableGoesOnSpinning) {
  Case ball = bouncing_ball(0.5);
  ball.gravity.setZero();
  ball.initial.position.y() = 0.0;
  ball.initial.spin = 3.0;
  const Solution solution = solve(ball);
  EXPECT_LE(solution.events().size(), 1U);
  EXPECT_EQ(solution.at(solution.end_time()).spin, 3.0);
  EXPECT_EQ(solution.at(solution.end_time()).position.norm(), 0.0);
}

TEST(Endings, WithoutRestitutionACableThatGravityOpensIsHitOnce) {
  // thrown up and sideways against the end of the cable above its anchor: it loses the speed along
  // the cable and falls away at once. Many throws, so that the rate left is of either sign.
  for (int throw_number = 0; throw_number < 200; ++throw_number) {
    Case ball = bouncing_ball(0.0);
    ball.cables.front().anchor = Vec2(0.0, -1.0);
    ball.cables.front().attachment = Vec2(0.1, 0.05);
    ball.initial = {Vec2(0.0, 0.5), 0.0, Vec2(0.001 * throw_number, 1.5), 0.1};
    ball.duration = 1.5;
    const Solution solution = solve(ball);
    EXPECT_EQ(solution.ending(), Ending::reached_duration) << "throw " << throw_number;
    EXPECT_EQ(solution.events().size(), 1U) << "throw " << throw_number;
  }
}

TEST(Endings, ABodyCaughtBetweenCablesStopsWithinTheInstant) {
  // three taut cables pull a point mass three ways: it cannot move, and each impact hands the
  // motion to the next cable, a little slower
  Case caught;
  caught.body = {1.0, 0.0};
  for (const double direction : {0.3, 2.4, 4.5}) {  // [rad]
    caught.cables.push_back(
        {Vec2(std::cos(direction), std::sin(direction)), Vec2(0.0, 0.0), 1.0, 0.6});
  }
  caught.initial.velocity = Vec2(0.7, -0.4);
  const Solution solution = solve(caught);
  EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  constexpr double instant = 1e-12;  // the last bounces of some 1e-13 take as long
  EXPECT_LE(solution.events().back().time, instant);
  EXPECT_LE(difference(solution.at(solution.end_time()), State{}), 1e-15);
  EXPECT_EQ(solution.at(solution.end_time()).velocity.norm(), 0.0);
  RecordProperty("impacts", static_cast<int>(solution.events().size()));
}

/// Every number of a solution is finite, and it claims its duration only where it got there.
void expect_sound(const Case& the_case, const Solution& solution) {
  for (const Arc& arc : solution.arcs()) {
    EXPECT_TRUE(std::isfinite(energy(the_case, arc.initial))) << the_case.name << " " << arc.start;
    EXPECT_TRUE(std::isfinite(arc.end)) << the_case.name;
  }
  for (const Event& event : solution.events()) {
    EXPECT_TRUE(std::isfinite(energy(the_case, event.after))) << the_case.name << " " << event.time;
    EXPECT_TRUE(event.impulses.allFinite()) << the_case.name << " " << event.time;
  }
  const State end = solution.at(solution.end_time());
  EXPECT_TRUE(std::isfinite(energy(the_case, end))) << the_case.name;
  if (solution.ending() == Ending::reached_duration) {
    for (const Cable& cable : the_case.cables) {
      EXPECT_GE(gap(cable, end), -1e-9 * cable.length) << the_case.name << ": passed a contact";
    }
  }
}

TEST(Endings, AtTheLimitsOfEachNumberNothingOverflows) {
  const auto solved = [](const std::string& name, const auto& change) {
    Case the_case = table_case("1910121100");
    the_case.name = name;
    change(the_case);
    SolveOptions options;
    options.max_events = 200;
    options.max_steps = 200;
    const Solution solution = solve(the_case, options);
    expect_sound(the_case, solution);
    EXPECT_NE(solution.ending(), Ending::overflow) << name;
  };
  solved("velocity", [](Case& c) { c.initial.velocity.x() = largest_number; });
  solved("gravity", [](Case& c) { c.gravity.y() = -largest_number; });
  solved("spin", [](Case& c) {
    c.initial.spin = largest_number;
    c.duration = 10.0 / largest_number;  // a few turns
  });
  solved("heavy", [](Case& c) { c.body.mass = largest_number; });
  solved("light", [](Case& c) { c.body.mass = smallest_divisor; });
  solved("inertia", [](Case& c) { c.body.inertia = largest_number; });
  solved("duration", [](Case& c) { c.duration = largest_number; });
  solved("angle", [](Case& c) { c.initial.angle = largest_number; });
  solved("length", [](Case& c) {
    c.cables[0].length = largest_number;
    c.cables.resize(1);
  });
}

TEST(Endings, ASearchThatOverflowsIsUnknownAndNotWithoutContact) {
  // beyond what a case may have, so that it cannot come from `solve` at once
  Case ball = bouncing_ball(0.5);
  State fast = ball.initial;
  fast.velocity = Vec2(1e200, 0.0);
  const FirstContactSearch search = first_contact(ball, fast, {}, 1.0);
  ASSERT_TRUE(search.contact.has_value());
  EXPECT_TRUE(std::isnan(search.contact->dt)) << search.contact->dt;
}

TEST(Endings, AnImpactThatOverflowsIsNotANumberAndDoesNotThrow) {
  Case ball = bouncing_ball(0.5);
  ball.body.mass = 1e-320;  // 1 / mass overflows
  ball.initial.position.y() = 0.0;
  ball.initial.velocity.y() = -1.0;
  EXPECT_FALSE(newton_impact(ball, ball.initial, CableSet::of(0)).impulses.allFinite());
}

}  // namespace
}  // namespace tautline::test
