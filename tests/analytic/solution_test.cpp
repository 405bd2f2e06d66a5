#include "tautline/solution.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "support.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

TEST(Solution, GivesTheStateAfterAtAnEventAndTheOneBeforeJustAhead) {
  for (const TableRow& row : table_5_1()) {
    const Solution solution = solve(breakwater(row.parameters, std::string(row.number)));
    const std::vector<Event>& events = solution.events();
    for (std::size_t k = 0; k < events.size(); ++k) {
      // cables may be found taut at the instant of their last impact: two events at one time
      const bool first = k == 0 || events[k - 1].time < events[k].time;
      const bool last = k + 1 == events.size() || events[k + 1].time > events[k].time;
      const double time = events[k].time;
      if (last) {
        EXPECT_EQ(difference(solution.at(time), events[k].after), 0.0) << row.number << " " << time;
      }
      if (first) {
        const State ahead = solution.at(std::nextafter(time, 0.0));
        constexpr double one_step_of_time = 1e-13;  // an ulp of t <= 32, times speeds up to 10
        EXPECT_LE(difference(ahead, events[k].before), one_step_of_time)
            << row.number << " " << time;
      }
    }
  }
}

TEST(Solution, HasArcsWithoutHoles) {
  for (const Case& the_case : shipped_cases()) {
    const Solution solution = solve(the_case);
    EXPECT_EQ(solution.arcs().front().start, 0.0);
    for (std::size_t k = 1; k < solution.arcs().size(); ++k) {
      EXPECT_EQ(solution.arcs()[k].start, solution.arcs()[k - 1].end) << the_case.name;
    }
    EXPECT_EQ(solution.arcs_until(solution.end_time()).back().end, solution.end_time());
    EXPECT_LE(solution.end_time(), the_case.duration) << the_case.name;
  }
}

TEST(Solution, NeverOverstretchesACableOfAShippedCase) {
  double worst = 0.0;
  for (const Case& the_case : shipped_cases()) {
    const Solution solution = solve(the_case);
    constexpr int samples = 2000;
    for (int k = 0; k <= samples; ++k) {
      const State state =
          solution.at(std::min(1.0, static_cast<double>(k) / samples) * solution.end_time());
      for (const Cable& cable : the_case.cables) {
        worst = std::max(worst, -gap(cable, state) / cable.length);
      }
    }
  }
  constexpr double rounding = 1e-14;  // positions add up some ten roundings between two impacts
  expect_within("overstretch by length", worst, rounding);
}

TEST(Solution, ThrowsOutsideItsTimes) {
  const Solution solution = solve(bouncing_ball());
  EXPECT_THROW((void)solution.at(-1e-300), std::out_of_range);
  EXPECT_THROW((void)solution.at(std::nextafter(solution.end_time(), 100.0)), std::out_of_range);
  EXPECT_THROW((void)solution.at(std::nan("")), std::out_of_range);
  EXPECT_NO_THROW((void)solution.at(0.0));
  EXPECT_NO_THROW((void)solution.at(solution.end_time()));
}

TEST(Solution, NeedsAnArc) {
  EXPECT_THROW(Solution(Case(), {}, {}, Ending::rest, {}), std::invalid_argument);
}

TEST(Solution, IsTheSameToTheLastBitEveryTime) {
  for (const Case& the_case : shipped_cases()) {
    const Solution one = solve(the_case);
    const Solution two = solve(the_case);
    ASSERT_EQ(one.events().size(), two.events().size()) << the_case.name;
    for (std::size_t k = 0; k < one.events().size(); ++k) {
      EXPECT_EQ(one.events()[k].time, two.events()[k].time) << the_case.name;
      EXPECT_EQ(difference(one.events()[k].after, two.events()[k].after), 0.0) << the_case.name;
    }
    EXPECT_EQ(one.end_time(), two.end_time()) << the_case.name;
  }
}

TEST(Solution, DoesNotDependOnTheUnits) {
  // the standard case in SI: S = 12 m, g = 9.81 m/s^2, 4.5 t. Powers of two would not round.
  const Case plain = table_case("1910121100");
  Case scaled = plain;
  constexpr double length = 12.0;
  constexpr double gravity = 9.81;
  constexpr double mass = 4500.0;
  const double time = std::sqrt(length / gravity);
  scaled.body = {mass, mass * length * length * plain.body.inertia};
  scaled.gravity *= gravity;
  for (Cable& cable : scaled.cables) {
    cable.anchor *= length;
    cable.attachment *= length;
    cable.length *= length;
  }
  scaled.initial.position *= length;
  scaled.initial.velocity *= length / time;
  scaled.initial.spin /= time;
  scaled.duration *= time;
  const Solution expected = solve(plain);
  const Solution got = solve(scaled);
  double worst = 0.0;
  constexpr double until = 6.0;  // rounding grows by 600 until here
  for (std::size_t k = 0; expected.events()[k].time <= until; ++k) {
    ASSERT_LT(k, got.events().size());
    State after = got.events()[k].after;
    after.position /= length;
    after.velocity *= time / length;
    after.spin *= time;
    EXPECT_EQ(got.events()[k].cables, expected.events()[k].cables) << "event " << k;
    worst = std::max({worst, std::abs(got.events()[k].time / time - expected.events()[k].time),
                      difference(after, expected.events()[k].after)});
  }
  expect_within("difference in nondimensional units", worst, 1e-11);
}

TEST(Solution, OfTheMirroredCaseIsTheMirrorImage) {
  const Case plain = table_case("1910121100");
  Case mirrored = plain;
  for (Cable& cable : mirrored.cables) {
    cable.anchor.x() *= -1.0;
    cable.attachment.x() *= -1.0;
  }
  mirrored.initial.position.x() *= -1.0;
  mirrored.initial.velocity.x() *= -1.0;
  const Solution expected = solve(plain);
  const Solution got = solve(mirrored);
  ASSERT_EQ(got.events().size(), expected.events().size());
  for (std::size_t k = 0; k < got.events().size(); ++k) {
    EXPECT_EQ(got.events()[k].time, expected.events()[k].time) << "event " << k;
    EXPECT_EQ(got.events()[k].after.spin, -expected.events()[k].after.spin) << "event " << k;
  }
}

TEST(Names, AreThoseUsedInFiles) {
  EXPECT_EQ(to_string(EventKind::impact), "impact");
  EXPECT_EQ(to_string(EventKind::taut), "taut");
  EXPECT_EQ(to_string(EventKind::slack), "slack");
  EXPECT_EQ(to_string(Ending::reached_duration), "reached_duration");
  EXPECT_EQ(to_string(Ending::rest), "rest");
  EXPECT_EQ(to_string(Ending::singular), "singular");
  EXPECT_EQ(to_string(Ending::angle_limit), "angle_limit");
  EXPECT_EQ(to_string(Ending::ceiling), "ceiling");
  EXPECT_EQ(to_string(Ending::event_limit), "event_limit");
  EXPECT_EQ(to_string(Ending::overflow), "overflow");
}

}  // namespace
}  // namespace tautline::test
