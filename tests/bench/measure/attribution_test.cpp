#include "bench/measure/attribution/attribution.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/measure/planted_run.hpp"

namespace tautline::bench {
namespace {

using test::bounced;
using test::exact_rate;
using test::Planted;
using test::planted_run;
using test::planted_step;
using test::PlantedFlight;

struct Outcome {
  Attribution attribution;
  double share = 0.0;  // [-], of the wanted cause
};

std::string described(const Attribution& attribution) {
  std::string text = fmt::format("{} m at {} s, {}\n", attribution.deviation, attribution.until,
                                 attribution.reason);
  for (std::size_t index = 0; attribution.parts && index < causes.size(); ++index) {
    text += fmt::format("{}: {}\n", to_string(causes[index]), (*attribution.parts)[index]);
  }
  return text;
}

/// Attributes the planted run and checks that its parts are the whole.
Outcome outcome(const Case& the_case, const Trajectory& run, Cause wanted, double end) {
  const Solution solution = solve(the_case);
  Outcome result;
  result.attribution = attribute(the_case, solution, end, run);
  const Attribution& found = result.attribution;
  EXPECT_TRUE(found.parts) << found.reason;
  if (!found.parts) {
    return result;
  }
  double all = 0.0;
  double sum = found.remainder;
  for (const double part : *found.parts) {
    all += std::abs(part);
    sum += part;
  }
  const auto sample = static_cast<std::size_t>(std::lround(found.until / run.step));
  const double deviation =
      (run.points[sample].state.position - solution.at(found.until).position).norm();
  EXPECT_EQ(found.deviation, deviation);
  EXPECT_NEAR(sum, deviation, 1e-12 * deviation);
  EXPECT_LE(std::abs(found.remainder), 0.05 * deviation) << described(found);
  result.share = std::abs((*found.parts)[static_cast<std::size_t>(wanted)]) / all;
  return result;
}

/// Cases of different kinds, each with an end after some impacts and before it accumulates.
struct Named {
  const char* name;
  double end;  // [s]
};

class PlantedCause : public testing::TestWithParam<Named> {
 protected:
  void SetUp() override {
    for (const Case& shipped : shipped_cases()) {
      if (shipped.name == GetParam().name) {
        the_case = shipped;
      }
    }
    ASSERT_FALSE(the_case.cables.empty());
    the_case.duration = GetParam().end;
  }

  [[nodiscard]] PlantedFlight exact_flight() const { return {the_case.gravity}; }

  void expect(Cause cause, const Planted& planted, const PlantedFlight& flight) const {
    const Trajectory run = planted_run(the_case, GetParam().end, planted, flight);
    ASSERT_GT(run.impacts.size(), 1U);
    const Outcome found = outcome(the_case, run, cause, GetParam().end);
    EXPECT_GE(found.share, 0.9) << described(found.attribution);
    EXPECT_GE(found.attribution.impacts, 1U);
  }

  Case the_case;
};

TEST_P(PlantedCause, NothingPlantedIsNothing) {
  const Trajectory run = planted_run(the_case, GetParam().end, {}, exact_flight());
  const Outcome found = outcome(the_case, run, Cause::amplification, GetParam().end);
  EXPECT_LT(found.attribution.deviation, 1e-10);
}

TEST_P(PlantedCause, SemiImplicitFlight) {
  expect(Cause::flight_bias, {}, {the_case.gravity, 0.5 * planted_step * the_case.gravity});
}

TEST_P(PlantedCause, ExplicitFlight) {
  expect(Cause::flight_bias, {}, {the_case.gravity, -0.5 * planted_step * the_case.gravity});
}

TEST_P(PlantedCause, FlightUnderWrongGravity) {
  expect(Cause::flight_bias, {}, {1.001 * the_case.gravity});
}

TEST_P(PlantedCause, LateImpact) {
  expect(Cause::event_lag, {.delay = 0.4 * planted_step}, exact_flight());
}

TEST_P(PlantedCause, EarlyImpact) {
  expect(Cause::event_lag, {.delay = -0.7 * planted_step}, exact_flight());
}

TEST_P(PlantedCause, RateOfALaterPose) {
  expect(Cause::late_rate,
         {.rate =
              [](const Case& own, std::size_t cable, const State& at_contact, const State&) {
                return exact_rate(own, cable, fly(at_contact, own.gravity, planted_step));
              }},
         exact_flight());
}

TEST_P(PlantedCause, RateAfterGravity) {
  expect(Cause::late_rate,
         {.rate =
              [](const Case& own, std::size_t cable, const State& at_contact, const State&) {
                State kicked = at_contact;
                kicked.velocity += planted_step * own.gravity;
                return exact_rate(own, cable, kicked);
              }},
         exact_flight());
}

TEST_P(PlantedCause, SlowImpactsDoNotRebound) {
  // from the second impact on, so that faster ones are before it
  double threshold = 0.0;
  static_cast<void>(planted_run(
      the_case, GetParam().end,
      {.rate =
           [&](const Case& own, std::size_t cable, const State& at_contact, const State&) {
             const double speed = -gap_rate(own.cables[cable], at_contact);
             threshold = threshold == 0.0 ? speed : std::min(threshold, speed);
             return exact_rate(own, cable, at_contact);
           }},
      exact_flight()));
  threshold *= 1.01;
  expect(
      Cause::threshold,
      {.rate =
           [threshold](const Case& own, std::size_t cable, const State& at_contact, const State&) {
             const double speed = -gap_rate(own.cables[cable], at_contact);
             return speed < threshold ? 0.0 : exact_rate(own, cable, at_contact);
           }},
      exact_flight());
}

TEST_P(PlantedCause, OverstretchPushedOutOnTopOfTheBounce) {
  expect(
      Cause::position_correction,
      // all of the overstretch in one step, so that what the delay does by itself is small beside
      // it
      {.delay = 0.08 * planted_step,
       .rate =
           [](const Case& own, std::size_t cable, const State& at_contact, const State& at_jump) {
             constexpr double part = 1.0;
             return exact_rate(own, cable, at_contact) -
                    part * gap(own.cables[cable], at_jump) / planted_step;
           }},
      exact_flight());
}

TEST_P(PlantedCause, UsualPartOfTheOverstretchIsTheLargestBesideTheLag) {
  const Trajectory run = planted_run(
      the_case, GetParam().end,
      {.delay = 0.5 * planted_step,
       .rate =
           [](const Case& own, std::size_t cable, const State& at_contact, const State& at_jump) {
             constexpr double usual = 0.2;
             return exact_rate(own, cable, at_contact) -
                    usual * gap(own.cables[cable], at_jump) / planted_step;
           }},
      exact_flight());
  const Outcome found = outcome(the_case, run, Cause::position_correction, GetParam().end);
  ASSERT_TRUE(found.attribution.parts);
  const auto size = [&found](Cause cause) {
    return std::abs((*found.attribution.parts)[static_cast<std::size_t>(cause)]);
  };
  for (const Cause cause : causes) {
    if (cause != Cause::event_lag && cause != Cause::position_correction) {
      EXPECT_GT(size(Cause::position_correction), size(cause))
          << to_string(cause) << described(found.attribution);
    }
  }
}

TEST_P(PlantedCause, ImpulseOfAWrongSize) {
  expect(Cause::solver_residual,
         {.rate =
              [](const Case& own, std::size_t cable, const State& at_contact, const State&) {
                const double rate = gap_rate(own.cables[cable], at_contact);
                return rate + 1.01 * (exact_rate(own, cable, at_contact) - rate);
              }},
         exact_flight());
}

TEST_P(PlantedCause, ImpulseOffTheCable) {
  expect(Cause::solver_residual,
         {.spoil = [](State& after, std::size_t) { after.velocity += Vec2(2e-3, -1e-3); }},
         exact_flight());
}

TEST_P(PlantedCause, RoundingThatGrows) {
  expect(Cause::amplification,
         {.spoil =
              [](State& after, std::size_t count) {
                if (count == 0) {
                  after.velocity.x() += 1e-10;
                }
              }},
         exact_flight());
}

INSTANTIATE_TEST_SUITE_P(Cases, PlantedCause,
                         testing::Values(Named{"breakwater/1910121100", 3.0},
                                         Named{"breakwater/1110121100", 5.0},
                                         Named{"breakwater/2921121100", 3.0}));

/// What one wrong impulse becomes by `until` [s], found by hand: the exact motion restarted from
/// either state behind the impact at `start` [s].
struct ByHand {
  Vec2 carried;        // [m], e
  double first_order;  // [m], the larger of |A d| and |B d|
};

ByHand by_hand(Case the_case, double start, double until, const State& exact, const State& wrong) {
  the_case.duration = until - start;
  const auto place = [&](const State& from) {
    the_case.initial = from;
    return solve(the_case).at(the_case.duration).position;
  };
  // d moves the velocity and the spin alone; central differences along it
  const auto derivative = [&](const State& at) {
    constexpr double near = 1e-6;
    const auto moved = [&](double scale) {
      State state = at;
      state.velocity += scale * (wrong.velocity - exact.velocity);
      state.spin += scale * (wrong.spin - exact.spin);
      return state;
    };
    return Vec2((place(moved(near)) - place(moved(-near))) / (2.0 * near));
  };
  return {place(wrong) - place(exact),
          std::max(derivative(exact).norm(), derivative(wrong).norm())};
}

/// The exact motion of a case that locks, sampled, its clock fast by `drift` [-] on taut cables.
Trajectory sampled_run(const Case& the_case, double drift) {
  const Solution solution = solve(the_case);
  const double lock = settling(the_case, solution).lock.value().time;
  Trajectory run;
  run.step = planted_step;
  const auto last = static_cast<std::size_t>(0.99 * solution.end_time() / planted_step);
  for (std::size_t index = 0; index <= last; ++index) {
    const double time = static_cast<double>(index) * planted_step;
    run.points.push_back({time, solution.at(time + drift * std::max(0.0, time - lock))});
  }
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      const std::size_t cable = event.cables.indices().front();
      run.impacts.push_back({event.time, cable, 1.0, gap_rate(the_case.cables[cable], event.before),
                             gap_rate(the_case.cables[cable], event.after), 0, event.before,
                             event.after});
    }
  }
  return run;
}

Case shipped(const std::string& name) {
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name == name) {
      return the_case;
    }
  }
  throw std::invalid_argument(name);
}

TEST(Attribution, TautStretchesThatDrift) {
  Case the_case = shipped("breakwater/1510121100");
  for (const double end : {3.0, 4.0, 5.0}) {
    the_case.duration = end;
    const Outcome found =
        outcome(the_case, sampled_run(the_case, 1e-3), Cause::taut_drift, 0.99 * end);
    EXPECT_GE(found.share, 0.9) << described(found.attribution);
    EXPECT_GT(found.attribution.until, 2.0) << "the lock is at 1.53";
    EXPECT_GT(found.attribution.deviation, 1e-6);
  }
}

/// One wrong impulse: `change` [m/s] at the first impact of a case, so large that `weight` of what
/// it becomes is explained by a derivative.
struct WrongImpulse {
  const char* name;
  double end;  // [s]
  Vec2 change;
  double weight;  // [-]
};

TEST(Attribution, OfAWrongImpulseIsItsCauseToFirstOrderAndAmplificationBeyond) {
  for (const auto& [name, end, change, known] :
       {WrongImpulse{"breakwater/1910121100", 3.0, {0.42, 0.56}, 1.0},
        WrongImpulse{"breakwater/1110121100", 5.0, {0.42, 0.56}, 0.960},
        WrongImpulse{"breakwater/2921121100", 3.0, {-0.129, 0.077}, 0.910}}) {
    Case the_case = shipped(name);
    the_case.duration = end;
    const auto spoil = [&wrong = change](State& after, std::size_t count) {
      if (count == 0) {
        after.velocity += wrong;
      }
    };
    const Trajectory run = planted_run(the_case, end, {.spoil = spoil}, {the_case.gravity});
    const Attribution found = outcome(the_case, run, Cause::solver_residual, end).attribution;
    ASSERT_TRUE(found.parts);
    const RecordedImpact& first = run.impacts.front();
    State exact = first.after;
    exact.velocity -= change;
    const ByHand hand = by_hand(the_case, first.time, found.until, exact, first.after);
    ASSERT_NEAR(hand.carried.norm(), found.deviation, 1e-9);
    const double weight = std::min(1.0, hand.first_order / hand.carried.norm());
    EXPECT_NEAR(weight, known, 2e-3) << name;
    const auto share = [&found](Cause cause) {
      return (*found.parts)[static_cast<std::size_t>(cause)] / found.deviation;
    };
    constexpr double differences = 1e-3;  // one-sided and central differences are so far apart
    EXPECT_NEAR(share(Cause::solver_residual), weight, differences) << described(found);
    EXPECT_NEAR(share(Cause::amplification), 1.0 - weight, differences) << described(found);
  }
}

TEST(Attribution, OfARunInWhichNothingReboundsIsThatAndNoThreshold) {
  Case the_case = shipped("breakwater/1910121100");
  the_case.duration = 3.0;
  const auto rate = [](const Case& own, std::size_t cable, const State& at_contact, const State&) {
    return 0.02 * exact_rate(own, cable, at_contact);  // what stops takes the taut motion with it
  };
  const Trajectory run = planted_run(the_case, 3.0, {.rate = rate}, {the_case.gravity});
  const auto [found, share] = outcome(the_case, run, Cause::restitution_ignored, 3.0);
  EXPECT_GE(share, 0.9) << described(found);
}

TEST(Attribution, SaysWhyThereAreNoParts) {
  const Case the_case = shipped("breakwater/1910121100");
  const Solution solution = solve(the_case);
  const Trajectory good = sampled_run(the_case, 0.0);
  const auto reason = [&](const Trajectory& run) {
    const Attribution found = attribute(the_case, solution, 3.0, run);
    EXPECT_FALSE(found.parts);
    EXPECT_EQ(found.deviation, 0.0);
    return found.reason;
  };
  Trajectory run = good;
  run.diverged = true;
  EXPECT_EQ(reason(run), "the run diverged");
  run = good;
  run.stride = 2;
  EXPECT_EQ(reason(run), "the run has more steps than are kept");
  run = good;
  run.impacts.clear();
  EXPECT_EQ(reason(run), "the run has no impact, the exact motion has");
  run = good;
  run.points.resize(1);
  run.stop = Simulation::Stop{0.0, "at once"};
  EXPECT_EQ(reason(run), "the run has no sample but its start");
}

TEST(Attribution, OfARunThatStoppedEndsThere) {
  const Case the_case = shipped("breakwater/1910121100");
  Trajectory run = sampled_run(the_case, 0.0);
  run.points.resize(1501);
  run.stop = Simulation::Stop{1.5, "a cable is taut"};
  const Attribution found = attribute(the_case, solve(the_case), 3.0, run);
  EXPECT_EQ(found.until, 1.5);
  EXPECT_NEAR(found.covered, 0.5, 1e-12) << "of the 3 s that are asked for";
  EXPECT_EQ(found.reason, "the run ends there");
}

}  // namespace
}  // namespace tautline::bench
