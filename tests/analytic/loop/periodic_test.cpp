#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <numbers>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

// Motions that repeat: one period is kept, and stands for all that follow.

namespace tautline::test {
namespace {

/// Periods and amplitudes against closed forms: a hundred roundings [-].
constexpr double closed_form = 2e-14;

/// More arcs than two periods of a usual motion have, and far fewer than a thousand periods.
constexpr std::size_t few_arcs = 200;

/// A point mass on a string that hangs at the origin.
Case on_string(double length, double gravity, const Vec2& position, const Vec2& velocity,
               double duration) {
  Case result;
  result.name = "string";
  result.body = {1.0, 0.0};
  result.cables = {{{0.0, 0.0}, {0.0, 0.0}, length, 0.5, 0.0, {}}};
  result.gravity = {0.0, -gravity};
  result.initial.position = position;
  result.initial.velocity = velocity;
  result.duration = duration;
  return result;
}

/// Goes round, from the lowest point at `speed` [m/s].
struct Rotation {
  double length;
  double gravity;
  double speed;

  [[nodiscard]] double modulus() const { return 2.0 * std::sqrt(gravity * length) / speed; }
  [[nodiscard]] double period() const {
    return 4.0 * length / speed * boost::math::ellint_1(modulus());
  }
  /// From Jacobi's functions, in the time since the last whole period.
  [[nodiscard]] Vec2 position(double time) const {
    const double rest = std::remainder(time, period());
    const double u = 0.5 * speed * rest / length;
    double cn = 0.0;
    double dn = 0.0;
    const double sn = boost::math::jacobi_elliptic(modulus(), u, &cn, &dn);
    return {2.0 * length * sn * cn, length * (2.0 * sn * sn - 1.0)};
  }
};

TEST(Periodic, FullCirclesAreKeptAsOneTurn) {
  const Rotation circle{3.0, 2.0, 6.0};
  const Case the_case = on_string(3.0, 2.0, {0.0, -3.0}, {6.0, 0.0}, 1000.0);
  const Solution solution = solve(the_case);
  EXPECT_EQ(solution.ending(), Ending::reached_duration);
  EXPECT_EQ(solution.end_time(), the_case.duration);
  EXPECT_LT(solution.arcs().size(), few_arcs);
  ASSERT_TRUE(solution.repetition());
  expect_within("period of full circles", std::abs(solution.repetition()->period - circle.period()),
                closed_form * circle.period());
  const Uncertainty uncertainty(the_case, solution);
  EXPECT_TRUE(uncertainty.unsure().empty());
  double worst = 0.0;
  for (int sample = 0; sample <= 1000; ++sample) {
    const double time = sample;
    const auto bounds = uncertainty.at(time);
    ASSERT_TRUE(bounds) << "at " << time;
    // the closed form is off by a rounding of the period in each turn
    const double closed = 2e-15 * time * circle.speed;
    const Vec2 off = (solution.at(time).position - circle.position(time)).cwiseAbs();
    worst = std::max(worst, off.maxCoeff());
    EXPECT_LE(off.x(), bounds->position.x() + closed + 1e-14) << "at " << time;
    EXPECT_LE(off.y(), bounds->position.y() + closed + 1e-14) << "at " << time;
    EXPECT_LE(bounds->position.maxCoeff(), 1e-10) << "at " << time;
  }
  expect_within("distance from Jacobi's functions over 1000 s", worst, 1e-11);
}

TEST(Periodic, CirclesAreTautForGoodWithAndWithoutGravity) {
  for (const Case& the_case : {on_string(3.0, 2.0, {0.0, -3.0}, {6.0, 0.0}, 100.0),
                               on_string(1.0, 0.0, {1.0, 0.0}, {0.0, 2.0}, 10.0)}) {
    const auto lock = settling(the_case, solve(the_case)).lock;
    ASSERT_TRUE(lock && lock->swing);
    EXPECT_TRUE(lock->permanent);
    EXPECT_TRUE(lock->swing->goes_round);
    const double period =
        the_case.gravity.isZero(0) ? std::numbers::pi : Rotation{3.0, 2.0, 6.0}.period();
    EXPECT_NEAR(lock->swing->period, period, closed_form * period);
  }
}

TEST(Periodic, ACircleThatLosesItsTensionIsNotTautForGood) {
  // at the top v^2 = 4 g L - 3 g L < g L
  const Case the_case = on_string(1.0, 1.0, {0.0, -1.0}, {std::sqrt(4.5), 0.0}, 50.0);
  const Solution solution = solve(the_case);
  EXPECT_TRUE(std::any_of(solution.events().begin(), solution.events().end(),
                          [](const Event& event) { return event.kind == EventKind::slack; }));
}

TEST(Periodic, APendulumOfADayTakesNoMoreThanOneOfAMinute) {
  const double angle = 1.2;
  const Vec2 start{std::sin(angle), -std::cos(angle)};
  const double modulus = std::sin(angle / 2.0);
  const double frequency = std::sqrt(9.81);
  const double period = 4.0 / frequency * boost::math::ellint_1(modulus);
  for (const double duration : {60.0, 86'400.0, 1e6}) {
    const Case the_case = on_string(1.0, 9.81, start, {0.0, 0.0}, duration);
    const Solution solution = solve(the_case);
    EXPECT_EQ(solution.ending(), Ending::reached_duration);
    EXPECT_LT(solution.arcs().size(), few_arcs);
    const Uncertainty uncertainty(the_case, solution);
    for (const double part : {0.1, 0.5, 1.0}) {
      const double time = part * duration;
      const auto bounds = uncertainty.at(time);
      ASSERT_TRUE(bounds) << time;
      double cn = 0.0;
      double dn = 0.0;
      const double u = frequency * std::remainder(time, period);
      const double sn = boost::math::jacobi_elliptic(modulus, u, &cn, &dn);
      const double sine = modulus * cn / dn;  // of half of the angle
      (void)sn;
      const double x = 2.0 * sine * std::sqrt(1.0 - sine * sine);
      const double closed = 4e-16 * time * frequency + 1e-14;
      EXPECT_LE(std::abs(solution.at(time).position.x() - x), bounds->position.x() + closed)
          << time;
      EXPECT_LE(bounds->position.norm(), 1e-13 + 2e-14 * time) << time;  // linear in time
    }
  }
}

TEST(Periodic, TheAmplitudeIsThatOfWhatTurns) {
  const Case pendulum = on_string(1.0, 9.81, {0.6, -0.8}, {0.0, 0.0}, 6.0);
  const auto swings = settling(pendulum, solve(pendulum)).lock.value().swing.value();
  EXPECT_EQ(swings.angle, SwingAngle::cable);
  EXPECT_NEAR(swings.amplitude, std::acos(0.8), closed_form);
  EXPECT_NEAR(swings.least, -std::acos(0.8), closed_form);
  Case hung = pendulum;  // at its centre, with a spin of its own
  hung.body.inertia = 0.3;
  hung.initial.spin = 0.7;
  const auto spins = settling(hung, solve(hung)).lock.value().swing.value();
  EXPECT_EQ(spins.angle, SwingAngle::cable);
  EXPECT_NEAR(spins.amplitude, std::acos(0.8), closed_form);
  Case parallelogram = pendulum;
  parallelogram.body.inertia = 0.1;
  parallelogram.cables = {{{-0.5, 0.0}, {-0.5, 0.0}, 1.0, 0.0, 0.0, {}},
                          {{0.5, 0.0}, {0.5, 0.0}, 1.0, 0.0, 0.0, {}}};
  const auto sways = settling(parallelogram, solve(parallelogram)).lock.value().swing.value();
  EXPECT_EQ(sways.angle, SwingAngle::cable);
  EXPECT_NEAR(sways.amplitude, std::acos(0.8), 1e-9);
  const Case breakwater = table_case("1910121100");
  const auto lock = settling(breakwater, solve(breakwater)).lock;
  EXPECT_EQ(lock.value().swing.value().angle, SwingAngle::body);
}

TEST(Periodic, ABodyThatSpinsTurnsOnThroughThePeriods) {
  Case the_case = on_string(3.0, 2.0, {0.0, -3.0}, {6.0, 0.0}, 1000.0);
  the_case.body.inertia = 0.5;
  the_case.initial.spin = 0.7;
  const Solution solution = solve(the_case);
  ASSERT_TRUE(solution.repetition());
  for (const double time : {1.0, 10.0, 300.0, 1000.0}) {
    EXPECT_NEAR(solution.at(time).angle, 0.7 * time, 1e-11) << time;
  }
}

TEST(Periodic, IsFoundInTheArcThatEndsWithTheDuration) {
  Case the_case;
  the_case.name = "ends-in-its-swing";
  the_case.duration = 5.0;
  the_case.gravity = {0.0, -1.0};
  the_case.body = {2.276871265489663, 1.4390789260046972};
  the_case.cables = {{{0.5081233157350125, 1.9609016574776275},
                      {0.2304537503901678, -0.32621442882344914},
                      2.2168632865829427,
                      0.3,
                      0.0,
                      {}},
                     {{-0.46371512240869883, 0.640726752584929},
                      {-0.3668720780482504, 0.3994959454163888},
                      0.31958717897109823,
                      0.9,
                      0.0,
                      {}}};
  the_case.initial = {
      {-0.047495433689686894, 0.02135239236424863}, 0.23817954660256124, {0.0, 0.0}, 0.0};
  for (const bool ahead : {false, true}) {
    const Solution solution = solve(the_case, {.until_locked = true, .swing_ahead = ahead});
    EXPECT_EQ(solution.ending(), Ending::locked) << ahead;
    ASSERT_TRUE(solution.swing()) << ahead;
    EXPECT_NEAR(solution.swing()->period, 4.744919345539640, 1e-9) << ahead;
  }
}

TEST(Periodic, WhatIsSureUpToATimeStaysSoHoweverLongTheRun) {
  for (const double duration : {20.0, 5000.0, 10'000.0, 1e5}) {
    Case the_case = table_case("1510121100");
    the_case.duration = duration;
    const Solution solution = solve(the_case);
    const auto bounds = Uncertainty(the_case, solution).at(15.0);
    ASSERT_TRUE(bounds) << duration;
    EXPECT_LE(bounds->position.norm(), 1e-9) << duration;
  }
}

TEST(Periodic, UnrollsItsArcsToAnyTime) {
  const Case the_case = on_string(3.0, 2.0, {0.0, -3.0}, {6.0, 0.0}, 100.0);
  const Solution solution = solve(the_case);
  const auto arcs = solution.arcs_until(50.0);
  EXPECT_EQ(arcs.back().end, 50.0);
  for (std::size_t k = 1; k < arcs.size(); ++k) {
    ASSERT_EQ(arcs[k].start, arcs[k - 1].end);
    const State there = solution.at(0.5 * (arcs[k].start + arcs[k].end));
    EXPECT_LE(
        difference(arcs[k].after(0.5 * (arcs[k].end - arcs[k].start), the_case.gravity), there),
        1e-12);
  }
}

}  // namespace
}  // namespace tautline::test
