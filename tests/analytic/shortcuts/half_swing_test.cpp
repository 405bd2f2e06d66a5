#include <gtest/gtest.h>

#include <algorithm>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

// A swing is integrated for half a period, and goes to and fro on it from then on.

namespace tautline::test {
namespace {

/// A motion started anew from a state on the cables is that swing, up to what a start that is a
/// rounding off makes of a part of a period [-], in m, rad, and their rates.
constexpr double as_if_anew = 2e-12;

/// From where on a solution has been followed by equations alone, a state of it is started anew for
/// less than half a period, in which no turn is used again: the largest difference.
double farthest_from_the_equations(const Case& the_case, const Solution& solution,
                                   const Swing& swing, double from, int samples) {
  double worst = 0.0;
  for (int sample = 0; sample < samples; ++sample) {
    const double start = from + sample * 0.137 * swing.period;
    const double later = 0.45 * swing.period;
    if (start + later > solution.end_time()) {
      break;
    }
    Case again = the_case;
    again.initial = solution.at(start);
    again.duration = later;
    const Solution anew = solve(again);
    EXPECT_EQ(anew.ending(), Ending::reached_duration);
    EXPECT_EQ(anew.arcs().back().taut, solution.arcs().back().taut) << "at " << start;
    for (const double part : {0.25, 0.5, 1.0}) {
      worst = std::max(worst, difference(anew.at(part * later), solution.at(start + part * later)));
    }
  }
  return worst;
}

TEST(HalfSwing, SwingsOnAsTheEquationsOfMotionDo) {
  for (const char* const number : {"1910121100", "1510121100", "2910121100", "1710121100"}) {
    Case the_case = table_case(number);
    the_case.duration = 60.0;
    const Solution solution = solve(the_case);
    const auto lock = settling(the_case, solution).lock;
    ASSERT_TRUE(lock && lock->swing) << number;
    const double worst =
        farthest_from_the_equations(the_case, solution, *lock->swing, lock->time + 0.1, 90);
    expect_within(std::string("distance from a motion started anew, ") + number, worst, as_if_anew);
  }
}

TEST(HalfSwing, ComesRoundAfterHundredsOfPeriods) {
  Case the_case = table_case("1510121100");
  the_case.duration = 1500.0;
  const Solution solution = solve(the_case);
  const auto lock = settling(the_case, solution).lock;
  ASSERT_TRUE(lock && lock->swing);
  // of a period by itself, whose error of a rounding of some arcs' lengths adds up over 450 of them
  const double period = lock->swing->period;
  const double at = lock->time + 2.0 * period;
  const int periods = static_cast<int>((1490.0 - at) / period);
  ASSERT_GT(periods, 400);
  const double worst = difference(solution.at(at), solution.at(at + periods * period));
  // the period is a difference of instants near 5 s, right to 1e-15 s, times periods and
  // accelerations
  expect_within("difference after hundreds of periods", worst, 4e-12);
  expect_within("distance from a motion started anew near the end",
                farthest_from_the_equations(the_case, solution, *lock->swing, 1400.0, 20),
                as_if_anew);
}

// energy and angles of the motion that has gone on, sampled over a period
TEST(HalfSwing, IsTheSwingThatTheWholeMotionShows) {
  for (const char* const number : {"1910121100", "1510121100", "2910121100", "1710121100"}) {
    Case the_case = table_case(number);
    the_case.duration = 40.0;
    const Solution part = solve(the_case, {.until_locked = true});
    ASSERT_EQ(part.ending(), Ending::locked) << number;
    ASSERT_TRUE(part.swing()) << number;
    const Solution whole = solve(the_case);
    EXPECT_FALSE(whole.swing()) << "it has gone on to the end";
    constexpr int samples = 20'000;
    double energy = 0.0;
    double least = 10.0;
    double largest = -10.0;
    const double turned = part.arcs()
                              .back()
                              .after(part.end_time() - part.arcs().back().start, the_case.gravity)
                              .angle;
    double nearest = 10.0;
    for (int sample = 0; sample < samples; ++sample) {
      const State state = whole.at(part.end_time() + sample * part.swing()->period / samples);
      energy = std::max(energy, kinetic_energy(the_case.body, state));
      least = std::min(least, state.angle);
      largest = std::max(largest, state.angle);
      if (sample > samples / 20 && sample < samples - samples / 20) {
        nearest = std::min(nearest, std::abs(state.angle - turned));
      }
    }
    EXPECT_GT(nearest, 0.01 * (largest - least)) << number << " comes back before its period ends";
    // between samples a cosine of 1 falls by pi^2 / samples^2 / 2, in twice the phase for the
    // energy
    EXPECT_NEAR(part.swing()->energy / energy, 1.0, 1e-7) << number;
    const double range = part.swing()->largest - part.swing()->least;
    EXPECT_NEAR((largest - part.swing()->largest) / range, 0.0, 1e-7) << number;
    EXPECT_NEAR((least - part.swing()->least) / range, 0.0, 1e-7) << number;
    EXPECT_DOUBLE_EQ(part.swing()->amplitude, range / 2.0) << number;
  }
}

}  // namespace
}  // namespace tautline::test
