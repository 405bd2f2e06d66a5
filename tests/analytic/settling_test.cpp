#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>
#include <random>

#include "support.hpp"
#include "swing_table.hpp"
#include "tautline/detail/ledger.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

class Settling : public ::testing::TestWithParam<SwingRow> {};

/// Solves a case of Table 5.1 until long after it has locked.
Solution settled(const Case& the_case, ImpactLaw law) {
  SolveOptions options;
  options.law = law;
  return solve(the_case, options);
}

/// How far a run's lock and swing are from the known ones, each at its largest.
struct Deviations {
  double energy = 0.0, time = 0.0, amplitude = 0.0;

  void add(const Case& the_case, ImpactLaw law, const SwingRow& row) {
    const auto found = settling(the_case, settled(the_case, law));
    ASSERT_TRUE(found.lock.has_value());
    EXPECT_EQ(found.lock->cables.size(), 2U);
    EXPECT_TRUE(found.lock->permanent);
    ASSERT_TRUE(found.lock->swing.has_value());
    const Energies& known = law == ImpactLaw::sequential ? row.sequential : row.simultaneous;
    energy = std::max(energy, std::abs(found.lock->swing->energy - known.energy));
    time = std::max(time, std::abs(found.lock->time - known.lock));
    amplitude = std::max(amplitude, std::abs(found.lock->swing->amplitude - row.amplitude));
  }
};

TEST_P(Settling, LocksIntoTheKnownSwing) {
  const SwingRow& row = GetParam();
  Case the_case = table_case(row.number);
  the_case.duration = 40.0;
  Deviations deviations;
  for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::sequential}) {
    deviations.add(the_case, law, row);
  }
  expect_within("error of the swing energy", deviations.energy, row.scatter_of_energy);
  expect_within("error of the time of the lock", deviations.time, row.scatter_of_time);
  expect_within("error of the amplitude", deviations.amplitude, row.scatter_of_amplitude);
}

TEST_P(Settling, StartsOneRoundingApartStayWithinTheScatter) {
  const SwingRow& row = GetParam();
  std::mt19937 random(20261121);
  std::uniform_int_distribution<int> side(-1, 1);
  Deviations deviations;
  constexpr int copies = 20;
  for (int copy = 0; copy < copies; ++copy) {
    Case the_case = table_case(row.number);
    the_case.duration = 40.0;
    State& start = the_case.initial;
    for (double* value : {&start.position.x(), &start.position.y(), &start.angle,
                          &start.velocity.x(), &start.velocity.y(), &start.spin}) {
      *value *= 1.0 + side(random) * std::numeric_limits<double>::epsilon();
    }
    deviations.add(the_case, ImpactLaw::simultaneous, row);
  }
  expect_within("scatter of the swing energy", deviations.energy, row.scatter_of_energy);
  expect_within("scatter of the time of the lock", deviations.time, row.scatter_of_time);
  expect_within("scatter of the amplitude", deviations.amplitude, row.scatter_of_amplitude);
}

INSTANTIATE_TEST_SUITE_P(Table51, Settling, ::testing::ValuesIn(swing_table),
                         [](const auto& param) {
                           return "Case" + std::string(param.param.number);
                         });

TEST(Settling, ThePointMassComesToRest) {
  Case the_case = table_case("1900461100");
  the_case.duration = 40.0;
  const Solution solution = solve(the_case);
  EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
  const auto found = settling(the_case, solution);
  ASSERT_TRUE(found.lock.has_value());
  EXPECT_TRUE(found.lock->rests);
  EXPECT_TRUE(found.lock->permanent);
  EXPECT_FALSE(found.lock->swing.has_value());
  // starts one rounding apart come to rest from 29.0 to 29.6, the exact decimals at 29.2015
  EXPECT_NEAR(found.lock->time, 29.2015, 0.4);
  expect_within("distance from the origin at the end", solution.at(40.0).position.norm(), 1e-15);
}

TEST(Settling, AnElasticBodyNeverSettles) {
  Case the_case = table_case("1110121100");
  the_case.duration = 40.0;
  const Solution solution = solve(the_case);
  EXPECT_TRUE(solution.accumulations().empty());
  const auto found = settling(the_case, solution);
  EXPECT_FALSE(found.lock.has_value());
  ASSERT_TRUE(found.last_impacts[0].time.has_value());
  EXPECT_GT(*found.last_impacts[0].time, 39.0);
}

TEST(Settling, FastImpactsEndBeforeSlowOnes) {
  const Case the_case = table_case("1910121100");
  const auto found = settling(the_case, solve(the_case));
  ASSERT_EQ(found.last_impacts.size(), 2U);
  EXPECT_EQ(found.last_impacts[0].speed, 0.01);
  EXPECT_EQ(found.last_impacts[1].speed, 0.001);
  EXPECT_LT(*found.last_impacts[0].time, *found.last_impacts[1].time);
  EXPECT_NEAR(*found.last_impacts[1].time, 8.114010, 2e-5);  // reference in 60 digits
}

TEST(Settling, WithoutImpactsThereIsNoLastOne) {
  Case ball = bouncing_ball();
  ball.duration = 0.1;
  const auto found = settling(ball, solve(ball));
  EXPECT_FALSE(found.last_impacts[0].time.has_value());
  EXPECT_FALSE(found.lock.has_value());
}

// by the end it has turned further than a case may begin, and more is not known of its swing
TEST(Settling, OfABallThatTurnsTooFastToSolveOnSaysNoSwing) {
  for (const double spin : {-1e20, 1e20}) {
    Case ball;
    ball.body = {5.0, 0.05};
    ball.gravity = Vec2(0.0, -9.81);
    ball.cables = {{Vec2(0.0, 0.0), Vec2(0.0, 0.0), 1.0, 0.0}};
    ball.initial = {Vec2(0.0, -0.9), 0.0, Vec2(6.3, 0.0), spin};
    ball.duration = 4.0;
    const auto found = settling(ball, solve(ball));
    EXPECT_FALSE(found.lock && found.lock->swing) << spin;
    EXPECT_FALSE(found.lock && found.lock->permanent) << spin;
    ball.initial.spin = std::copysign(1.0, spin);
    EXPECT_TRUE(settling(ball, solve(ball)).last_impacts[0].time.has_value()) << spin;
  }
}

TEST(Ledger, ClosesInEveryCaseOfTable51) {
  double worst = 0.0;
  for (const TableRow& row : table_5_1()) {
    Case the_case = breakwater(row.parameters, std::string(row.number));
    the_case.duration = 100.0;
    const Solution solution = solve(the_case);
    EXPECT_EQ(solution.end_time(), 100.0) << row.number;
    const EnergyLedger ledger = energy_ledger(the_case, solution);
    EXPECT_GE(ledger.impacts, row.parameters.e < 1.0 ? 1e-3 : -1e-13) << row.number;
    EXPECT_GE(ledger.completions, 0.0) << row.number;
    worst = std::max(worst, std::abs(ledger.residual));
  }
  expect_within("energy unaccounted for", worst, 1e-12);
}

TEST(Swing, KeepsItsCablesTautOverAThousandTimes) {
  Case the_case = table_case("1910121100");
  the_case.duration = 1000.0;
  const Solution solution = solve(the_case);
  EXPECT_EQ(solution.ending(), Ending::reached_duration);
  double drift = 0.0;
  double rate = 0.0;
  const double start = 9.0;  // after the lock
  const double energy_then = energy(the_case, solution.at(start));
  double energy_change = 0.0;
  constexpr int samples = 20'000;
  for (int k = 0; k <= samples; ++k) {
    const State state = solution.at(start + (1000.0 - start) * k / samples);
    for (const Cable& cable : the_case.cables) {
      drift = std::max(drift, std::abs(gap(cable, state)));
      rate = std::max(rate, std::abs(gap_rate(cable, state)));
    }
    energy_change = std::max(energy_change, std::abs(energy(the_case, state) - energy_then));
  }
  expect_within("drift of a taut cable", drift, 1e-13);
  expect_within("rate of a taut cable", rate, 1e-13);
  expect_within("change of the swing's energy", energy_change, 1e-13);
}

TEST(Swing, HasTheKnownPeriods) {
  const Case the_case = table_case("1910121100");
  const auto period = [&](double angle) {
    const auto found = swing(the_case, on_linkage(the_case, angle));
    return found ? found->period : 0.0;
  };
  // linear: omega^2 = k / m, k = b + a/h + a^2 h / (1-a)^2, m = (b - a h / (1-a))^2 + Ic
  const double a = 0.1;
  const double h = std::sqrt(1.5 * 1.5 - 0.9 * 0.9);
  const double k = a / h + a * a * h / 0.81;
  const double m = std::pow(a * h / 0.9, 2) + 0.01;
  const double linear = 2.0 * std::numbers::pi / std::sqrt(k / m);
  EXPECT_NEAR(linear, 3.342624, 0.5e-6);
  expect_within("linear period", std::abs(period(1e-5) - linear), 1e-9);
  expect_within("period at 0.65 rad", std::abs(period(0.65) - 3.27271739), 0.5e-8);
  expect_within("period at 1.5 rad", std::abs(period(1.5) - 3.45272097), 0.5e-8);
}

// a step of a small swing is longer than half of it, and may hold both turning points
TEST(Swing, HasTheSamePeriodHoweverSmall) {
  for (const char* const number : {"1910121100", "1911121100", "1930121100"}) {
    const Case the_case = table_case(number);
    const auto known = swing(the_case, on_linkage(the_case, 1e-4));
    ASSERT_TRUE(known) << number;
    for (const double angle : {1e-5, 1e-6, 1e-7, 3e-8, 1e-8, 3e-9, 1e-9}) {
      const auto found = swing(the_case, on_linkage(the_case, angle));
      ASSERT_TRUE(found) << number << " " << angle;
      // it grows with the square of the angle, and a rounding of 1e-16 is a part of 1e-9
      EXPECT_NEAR(found->period / known->period, 1.0, 1e-6) << number << " " << angle;
    }
  }
}

TEST(Swing, MeasuresItsAmplitudeAndEnergy) {
  const Case the_case = table_case("1910121100");
  for (const double angle : {1e-6, 1e-3, 0.3, 1.2}) {
    const State start = on_linkage(the_case, angle);
    const auto found = swing(the_case, start);
    ASSERT_TRUE(found.has_value()) << angle;
    constexpr double rounding = 1e-14;  // [rad], of some hundred steps
    EXPECT_NEAR(found->amplitude, angle, rounding);
    EXPECT_NEAR(found->largest, angle, rounding);
    EXPECT_NEAR(found->energy, energy(the_case, start), 1e-15);  // the equilibrium is the origin
  }
}

/// Without the impacts that rounding alone brings, where a swing turns just as another cable
/// closes.
std::size_t events_to_tell(const Case& the_case, const Solution& solution) {
  constexpr double told = 1e-6;  // [m/s], of closing
  return static_cast<std::size_t>(
      std::count_if(solution.events().begin(), solution.events().end(), [&](const Event& event) {
        return event.kind != EventKind::impact ||
               gap_rates(the_case, event.before, event.cables).minCoeff() < -told;
      }));
}

/// Whether `the_case`, solved until its lock, is found to lock; it then says what the whole motion
/// says.
bool locks_alike(const Case& the_case) {
  SolveOptions options;
  options.until_locked = true;
  const Solution part = solve(the_case, options);
  const Solution whole = solve(the_case);
  EXPECT_EQ(events_to_tell(the_case, part), events_to_tell(the_case, whole))
      << "an event after a lock for good";
  if (part.ending() != Ending::locked) {
    EXPECT_EQ(part.ending(), whole.ending());
    EXPECT_EQ(part.end_time(), whole.end_time());
    return false;
  }
  const auto found = settling(the_case, part);
  const auto known = settling(the_case, whole);
  EXPECT_LE(part.end_time(), whole.end_time());
  EXPECT_EQ(found.last_impacts.front().time, known.last_impacts.front().time);
  EXPECT_EQ(found.last_impacts.back().time, known.last_impacts.back().time);
  if (part.events().size() != whole.events().size()) {
    return false;
  }
  if (!found.lock && !known.lock) {
    return false;  // an impact has stopped the body, on a cable that is taut: no accumulation
  }
  if (!found.lock || !known.lock || !found.lock->swing || !known.lock->swing) {
    ADD_FAILURE() << "no lock where there is one";
    return false;
  }
  EXPECT_EQ(found.lock->time, known.lock->time);
  EXPECT_EQ(found.lock->cables, known.lock->cables);
  constexpr double rounding = 1e-12;  // of some hundred steps, of lengths and times near one
  EXPECT_NEAR(found.lock->swing->energy, known.lock->swing->energy, rounding);
  EXPECT_NEAR(found.lock->swing->period, known.lock->swing->period, 1e3 * rounding);
  EXPECT_NEAR(found.lock->swing->amplitude, known.lock->swing->amplitude, rounding);
  return true;
}

TEST(UntilLocked, SaysOfEveryShippedCaseWhatTheWholeMotionSays) {
  int locked = 0;
  for (Case the_case : shipped_cases()) {
    the_case.duration = std::max(the_case.duration, 40.0);
    SCOPED_TRACE(the_case.name);
    locked += locks_alike(the_case) ? 1 : 0;
  }
  EXPECT_GE(locked, 19) << "all of Table 5.1 but the elastic case and the point mass";
}

TEST(UntilLocked, SaysOfRandomSystemsWhatTheWholeMotionSays) {
  Random random(20261123);
  int locked = 0;
  for (int sample = 0; sample < 300; ++sample) {
    Case the_case = random_case(random, {1 + static_cast<std::size_t>(sample % 3), 0.0, 0.5});
    the_case.duration = 60.0;
    SCOPED_TRACE(sample);
    locked += locks_alike(the_case) ? 1 : 0;
  }
  std::cout << "  " << locked << " of 300 systems lock\n";
  EXPECT_GE(locked, 30);
}

TEST(CriticalSwing, HasTheKnownAngleAndEnergy) {
  struct Known {
    const char* number;
    double angle, energy;
  };
  for (const Known& known : {Known{"1910121100", 1.689219374433, 0.102381206615},
                             Known{"1933121100", 0.566196535588, 0.111552138024}}) {
    const auto found = critical_swing(table_case(known.number), State{});
    ASSERT_TRUE(found.has_value()) << known.number;
    constexpr double ten_digits = 0.5e-10;
    expect_within("angle of release", std::abs(found->angle - known.angle), ten_digits);
    expect_within("energy of release", std::abs(found->energy - known.energy), ten_digits);
  }
}

TEST(CriticalSwing, NeedsTwoTautCables) {
  EXPECT_FALSE(critical_swing(bouncing_ball(), State{}).has_value());
  EXPECT_FALSE(critical_swing(table_case("1900461100"), State{}).has_value());
  State lifted;
  lifted.position.y() = 0.1;
  EXPECT_FALSE(critical_swing(table_case("1910121100"), lifted).has_value());
}

TEST(Rest, OfASquareOnFourCablesIsExact) {
  for (const Vec2& gravity : {Vec2(0.0, -1.0), Vec2(0.0, -9.81), Vec2(0.3, -0.7)}) {
    for (const double e : {0.0, 0.5, 1.0}) {
      Case square;
      square.body = {1.0, 2.0 / 3.0 * 0.01};
      square.gravity = gravity;
      square.duration = 50.0;
      for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
          const Vec2 anchor(1.2 * x, y);
          const Vec2 attachment(0.1 * x, 0.1 * y);
          square.cables.push_back({anchor, attachment, (anchor - attachment).norm(), e});
        }
      }
      for (const ImpactLaw law : impact_laws) {
        SolveOptions options;
        options.law = law;
        const Solution solution = solve(square, options);
        EXPECT_EQ(solution.ending(), Ending::rest) << to_string(solution.ending());
        for (const double time : {0.0, 1e-3, 7.3, 50.0}) {
          EXPECT_EQ(difference(solution.at(time), State{}), 0.0) << "t = " << time;
        }
      }
    }
  }
}

TEST(Release, OfTheBoxLosesItsLeftCableWhereItMust) {
  Case box = table_case("1933121100");
  box.initial = on_linkage(box, 0.7);
  box.duration = 1.0;
  const Solution solution = solve(box);
  ASSERT_GE(solution.events().size(), 3U);
  const Event& taut = solution.events()[0];
  EXPECT_EQ(taut.kind, EventKind::taut);
  EXPECT_EQ(taut.time, 0.0);
  EXPECT_NEAR(energy(box, taut.after), 0.16306, 0.5e-5);
  const Event& slack = solution.events()[1];
  EXPECT_EQ(slack.kind, EventKind::slack);
  EXPECT_EQ(slack.cables, CableSet::of(0));
  expect_within("time of the release", std::abs(slack.time - 0.3674072758), 0.5e-10);
  expect_within("angle there", std::abs(slack.before.angle - 0.57475423), 0.5e-8);
  expect_within("spin there", std::abs(slack.before.spin + 0.70273813), 0.5e-8);
  const Event& impact = solution.events()[2];
  EXPECT_EQ(impact.kind, EventKind::impact);
  EXPECT_TRUE(impact.cables.contains(0));
  expect_within("time of the next impact", std::abs(impact.time - 0.8183714), 0.5e-7);
  expect_within("speed of that impact", std::abs(gap_rate(box.cables[0], impact.before) + 0.1281),
                0.5e-4);
}

}  // namespace
}  // namespace tautline::test
