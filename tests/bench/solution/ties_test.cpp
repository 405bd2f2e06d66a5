// What is said of ties, and what --digits prints.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/solution/many_digits.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"
#include "tests/analytic/support.hpp"

namespace tautline::bench {
namespace {

constexpr std::uint64_t tilts = 15;  // a seed

std::string summary_of(const Case& the_case) {
  const Solution solution = solve(the_case);
  return solution_text(the_case, solution, settling(the_case, solution),
                       Uncertainty(the_case, solution));
}

/// What --digits prints.
std::string digits_of(const Case& the_case, int digits, const std::vector<double>& at = {}) {
  return many_digits_text(the_case, {}, solve(the_case),
                          {.digits = digits, .decimal = false, .all_events = false, .at = at},
                          unlimited);
}

/// A point that starts at the bottom of its circle with this speed [m/s]; gravity 1, length 2.
Case swing_up(double speed) {
  Case result;
  result.name = "swing";
  result.duration = 30.0;
  result.body = {1.0, 0.0};
  result.cables = {{{0.0, 0.0}, {0.0, 0.0}, 2.0, 0.5}};
  result.initial.position = {0.0, -2.0};
  result.initial.velocity = {speed, 0.0};
  return result;
}

// v^2 = 2 g L: the tension, 3 m g cos(angle), touches zero where the body turns, at the quarter of
// its period 4 sqrt(L / g) K(1 / sqrt 2)
TEST(Ties, ATensionThatTouchesZeroIsOneForEveryPrecision) {
  const Case the_case = swing_up(2.0);
  const double touch = 10.4882302172 / 4.0;
  const Solution solution = solve(the_case);
  const Uncertainty uncertainty(the_case, solution);
  ASSERT_EQ(uncertainty.unsure().size(), 1U);
  const Unsure& open = uncertainty.unsure().front();
  ASSERT_TRUE(open.tie);
  EXPECT_EQ(open.tie->kind, EventKind::slack);
  EXPECT_EQ(open.tie->cables, CableSet::of(0));
  EXPECT_NEAR(open.from, touch, 1e-6);
  EXPECT_TRUE(uncertainty.at(2.6)) << "before it all is sure";
  for (std::size_t index = 1; index < uncertainty.events().size(); ++index) {
    EXPECT_FALSE(uncertainty.events()[index]) << "an event that the motion need not have";
  }
  const std::string words =
      "At t = 2.62206 the tension of cable 0 touches zero. Rounding decides whether it goes slack "
      "(a "
      "tie).";
  EXPECT_NE(summary_of(the_case).find(words), std::string::npos) << summary_of(the_case);
  for (const int digits : {4, 8, 12, 16}) {
    const std::string text = digits_of(the_case, digits);
    EXPECT_NE(text.find(words), std::string::npos) << digits << "\n" << text;
    EXPECT_EQ(text.find("  slack"), std::string::npos) << digits << "\n" << text;
  }
}

TEST(Ties, AlsoAtTheTopOfACircleAndFromRestAtTheAnchorsHeight) {
  Case top = swing_up(std::sqrt(10.0));  // v^2 = 5 g L
  Case level = swing_up(0.0);
  level.initial.position = {2.0, 0.0};
  for (const Case& the_case : {top, level}) {
    const Solution solution = solve(the_case);
    const Uncertainty uncertainty(the_case, solution);
    ASSERT_TRUE(uncertainty.horizon());
    EXPECT_TRUE(uncertainty.unsure().front().tie);
    EXPECT_GT(*uncertainty.horizon(), 1.0) << "the start is none";
  }
}

TEST(Ties, AMotionBesideATieIsSure) {
  for (const double speed : {2.0 * (1.0 - 1e-7), 1.9999, 3.0, 3.3}) {
    const Case the_case = swing_up(speed);
    const Solution solution = solve(the_case);
    EXPECT_FALSE(Uncertainty(the_case, solution).horizon()) << speed;
  }
}

/// A box on two equal cables side by side, which starts at the bottom of its circles at this speed
/// [m/s] and does not turn, turned as a whole by `tilt` [rad].
Case parallelogram(double speed, double gravity, double tilt = 0.0) {
  const Eigen::Rotation2Dd turned(tilt);
  Case result;
  result.name = "parallelogram";
  result.duration = 4.0;
  result.body = {1.0, 0.1};
  for (const double side : {-0.5, 0.5}) {
    result.cables.push_back({turned * Vec2(side, 0.0), Vec2(side, 0.0), 1.0, 0.0});
  }
  result.gravity = turned * Vec2(0.0, -gravity);
  result.initial = {turned * Vec2(0.0, -1.0), tilt, turned * Vec2(speed, 0.0), 0.0};
  return result;
}

// level with the anchors both cables and the bar between their ends are one line; the box may turn
// over there
TEST(Ties, TheDeadPointOfAParallelogramIsOneForEveryPrecision) {
  for (const double gravity : {0.0, 1.0}) {
    for (const double speed : {1.5, 2.0, 4.0, 7.3}) {
      const Case the_case = parallelogram(speed, gravity);
      const Solution solution = solve(the_case);
      const Uncertainty uncertainty(the_case, solution);
      const std::string name = fmt::format("{} m/s, gravity {}", speed, gravity);
      ASSERT_TRUE(uncertainty.horizon()) << name;
      const auto& tie = uncertainty.unsure().front().tie;
      ASSERT_TRUE(tie) << name << " " << *uncertainty.horizon();
      EXPECT_EQ(tie->kind, EventKind::taut) << name;
      EXPECT_EQ(tie->cables, CableSet::of(0) | CableSet::of(1)) << name;
      const double dead = *uncertainty.horizon();
      EXPECT_NEAR(solution.at(dead).position.y(), 0.0, 1e-3) << name;
      for (const double part : {0.2, 0.5, 0.9, 0.99, 0.999}) {
        const State state = solution.at(part * dead);
        const auto errors = uncertainty.at(part * dead);
        ASSERT_TRUE(errors) << name;
        EXPECT_LE(std::abs(state.angle), errors->angle) << name << " " << part;
        EXPECT_LE(std::abs(state.spin), errors->spin) << name << " " << part;
      }
      for (std::size_t index = 1; index < uncertainty.events().size(); ++index) {
        EXPECT_FALSE(uncertainty.events()[index]) << name << ": an event it need not have";
      }
    }
  }
  const std::string words =
      "At t = 0.392699 the taut cables 0 and 1 are at a dead point, where the body can go on in "
      "more "
      "than one way. Rounding decides which way it takes (a tie).";
  Case the_case = parallelogram(4.0, 0.0);  // at pi/8 s
  the_case.duration = 0.5;
  EXPECT_NE(summary_of(the_case).find(words), std::string::npos) << summary_of(the_case);
  for (const int digits : {4, 8, 12}) {
    const std::string text = digits_of(the_case, digits);
    EXPECT_NE(text.find(words), std::string::npos) << text;
  }
  the_case = parallelogram(1.5, 1.0);
  the_case.duration = 1.5;
  const std::string text = digits_of(the_case, 8);
  EXPECT_NE(text.find("0 and 1 are at a dead point"), std::string::npos) << text;
}

TEST(Ties, ADeadPointOfATiltedParallelogramIsNotPassedSurely) {
  tautline::test::Random random(tilts);
  for (int draw = 0; draw < 40; ++draw) {
    const double tilt = random.uniform(-3.0, 3.0);
    const double speed = random.uniform(1.5, 8.0);
    const Case the_case = parallelogram(speed, draw % 2, tilt);
    const Solution solution = solve(the_case);
    const Uncertainty uncertainty(the_case, solution);
    ASSERT_TRUE(uncertainty.horizon()) << tilt << " " << speed;
    const Vec2 bottom = Eigen::Rotation2Dd(tilt) * Vec2(0.0, -1.0);
    const double risen =  // [-], of the length: 1 at the dead point
        1.0 - solution.at(*uncertainty.horizon()).position.dot(bottom);
    EXPECT_NEAR(risen, 1.0, 1e-2) << tilt << " " << speed;
  }
}

// what the duration ends before it is no more sure to swing on for ever
TEST(Ties, AMotionThatPassesADeadPointAfterTheRunIsNotForGood) {
  Case the_case = parallelogram(0.3, 0.0);  // dead at pi / 0.6 s
  for (const double duration : {0.3, 5.0, 6.0}) {
    the_case.duration = duration;
    const auto lock = settling(the_case, solve(the_case)).lock;
    EXPECT_FALSE(lock && lock->permanent) << duration;
    EXPECT_EQ(summary_of(the_case).find("stay taut from"), std::string::npos)
        << summary_of(the_case);
  }
  the_case.duration = 0.3;
  EXPECT_NE(digits_of(the_case, 8).find("was not determined: no full period"), std::string::npos)
      << digits_of(the_case, 8);
}

TEST(Ties, AStartAtADeadPointIsOne) {
  for (const double gravity : {0.0, 1.0}) {
    Case the_case = parallelogram(0.0, gravity);
    the_case.initial = {Vec2(1.0, 0.0), 0.0, Vec2(0.0, -2.0), 0.0};
    SolveOptions few;
    few.max_events = 100;  // it chatters between the two ways
    const Solution solution = solve(the_case, few);
    const Uncertainty uncertainty(the_case, solution, few);
    ASSERT_TRUE(uncertainty.horizon()) << gravity;
    EXPECT_EQ(*uncertainty.horizon(), 0.0) << gravity;
    ASSERT_TRUE(uncertainty.unsure().front().tie) << gravity;
    EXPECT_EQ(uncertainty.unsure().front().tie->kind, EventKind::taut) << gravity;
    const std::string text =
        many_digits_text(the_case, few, solution,
                         {.digits = 8, .decimal = false, .all_events = false, .at = {}}, unlimited);
    EXPECT_NE(text.find("At t = 0 the taut cables 0 and 1 are at a dead point"), std::string::npos)
        << text;
  }
}

TEST(Ties, ABoxThatTurnsBackBeforeADeadPointIsSure) {
  const Case the_case = parallelogram(1.4, 1.0);  // rises to 0.98 of the length
  EXPECT_FALSE(Uncertainty(the_case, solve(the_case)).horizon());
}

TEST(ManyDigits, SamplesHaveTensionsGapsAndEnergy) {
  Case hanging = parallelogram(0.0, 1.0);
  hanging.initial.position.y() = -0.75;
  const std::string text = digits_of(hanging, 20, {0.5, 3.0});
  for (const char* words : {"Tension at rest: 0.5 on cable 0, 0.5 on cable 1.", "gap 0 ",
                            "gap rate 1", "tension 0", "energy"}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
}

// the doubles of 45 degrees are 7e-17 m off the circle
TEST(ManyDigits, OfAStartThatIsOffItsCircleByARounding) {
  Case the_case = swing_up(0.0);
  the_case.initial.position = {2.0 * std::sqrt(0.5), -2.0 * std::sqrt(0.5)};
  const std::string text = digits_of(the_case, 25, {1.0});
  EXPECT_NE(text.find("computed in 9"), std::string::npos) << text;  // 96 digits, not 800
}

TEST(RightDigits, ANumberThatMayBeZeroIsTheZerosThatAreRight) {
  EXPECT_EQ(right_general(1e-17, 1e-16, 17), "0.000000000000000");
  EXPECT_EQ(right_general(-2e-9, 3e-9, 17), "0.0000000");
  EXPECT_EQ(right_general(0.0, 0.0, 17), "0");
  EXPECT_EQ(right_general(0.2, 0.4, 17), dash);
  EXPECT_EQ(right_general(1e-17, -1.0, 17), dash);
  EXPECT_EQ(number_in_words(1e-17, 1e-16, 6), "0 to within 2e-16");
}

TEST(ManyDigits, SamplesHaveEveryDigitThatIsAskedFor) {
  Case fall;  // exact: y = -1/4 - t^2 / 2 up to the impact
  fall.name = "fall";
  fall.duration = 2.0;
  fall.body = {1.0, 0.0};
  fall.cables = {{{0.0, 0.0}, {0.0, 0.0}, 3.0, 0.5}};
  fall.initial.position = {0.0, -0.25};
  fall.initial.velocity = {0.1, 0.0};
  const std::string text = digits_of(fall, 30, {1.0, 0.5});
  EXPECT_NE(text.find("sample at"), std::string::npos) << text;
  // the double nearest to 0.1, halved: all of its digits
  EXPECT_NE(text.find("0.0500000000000000027755575615629"), std::string::npos) << text;
  EXPECT_NE(text.find("-0.375"), std::string::npos) << text;
}

}  // namespace
}  // namespace tautline::bench
