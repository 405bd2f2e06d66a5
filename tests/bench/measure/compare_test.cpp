#include "bench/measure/compare.hpp"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <limits>

#include <set>

#include "bench/measure/horizon.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/measure/metric_list.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// The exact solution as a run, `delay` [s] late, `shift` [m] to the right.
Trajectory as_run(const Case& the_case, const Solution& solution, double delay, double shift) {
  Trajectory run;
  run.step = 1e-3;
  const double end = solution.end_time();
  for (double time = 0.0; time < end; time += run.step) {
    State state = solution.at(std::max(0.0, time - delay));
    state.position.x() += shift;
    run.points.push_back({time, state});
  }
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    Eigen::Index row = 0;
    for (const std::size_t index : event.cables) {
      const Cable& cable = the_case.cables[index];
      run.impacts.push_back({event.time + delay, index, event.impulses[row++],
                             gap_rate(cable, event.before), gap_rate(cable, event.after), 0,
                             event.before, event.after});
    }
  }
  run.largest_energy = energy(the_case, the_case.initial);
  return run;
}

const std::size_t early = static_cast<std::size_t>(Window::early);
const std::size_t horizon_window = static_cast<std::size_t>(Window::horizon);
const std::size_t whole = static_cast<std::size_t>(Window::whole);

class StandardCase : public testing::Test {
 protected:
  Case the_case = shipped_cases().front();
  Solution solution = solve(the_case);
  Settling settled = settling(the_case, solution);
};

TEST_F(StandardCase, TheExactSolutionHasNoErrorAgainstItself) {
  const Metrics metrics = compare(the_case, solution, settled, solution.end_time(),
                                  as_run(the_case, solution, 0.0, 0.0));
  for (std::size_t window = 0; window < windows.size(); ++window) {
    EXPECT_EQ(metrics.deviation[window].position, 0.0);
    EXPECT_EQ(metrics.deviation[window].angle, 0.0);
    EXPECT_EQ(metrics.deviation[window].velocity, 0.0);
    EXPECT_EQ(metrics.impacts[window].matched, metrics.impacts[window].exact);
    EXPECT_EQ(metrics.impacts[window].found, metrics.impacts[window].exact);
    EXPECT_EQ(metrics.impacts[window].first_time_error, 0.0);
  }
  EXPECT_EQ(metrics.impacts[whole].exact, 79U);  // engines of all kinds agree on it
  EXPECT_EQ(metrics.later_impacts, 0U);
  ASSERT_TRUE(metrics.restitution);
  EXPECT_NEAR(metrics.restitution->mean, 0.9, 1e-14);
}

TEST_F(StandardCase, AShiftIsThePositionErrorAndNothingElse) {
  const Metrics metrics =
      compare(the_case, solution, settled, 4.0, as_run(the_case, solution, 0.0, 0.125));
  EXPECT_NEAR(metrics.deviation[horizon_window].position, 0.125, 1e-15);
  EXPECT_EQ(metrics.deviation[horizon_window].velocity, 0.0);
  EXPECT_EQ(metrics.deviation[horizon_window].until, 4.0);
  EXPECT_LT(metrics.deviation[early].until, 4.0);
}

TEST_F(StandardCase, ADelayIsTheTimeErrorOfEveryMatchedImpact) {
  constexpr double delay = 1e-4;
  const Metrics metrics =
      compare(the_case, solution, settled, 6.0, as_run(the_case, solution, delay, 0.0));
  const ImpactMatch& impacts = metrics.impacts[horizon_window];
  EXPECT_EQ(impacts.matched, impacts.exact);
  EXPECT_NEAR(impacts.first_time_error.value(), delay, 1e-12);
  EXPECT_NEAR(impacts.worst_time_error.value(), delay, 1e-12);
  // the position moves by at most speed times delay; the body is never faster than 0.6 here
  EXPECT_LT(metrics.deviation[horizon_window].position, 0.6 * delay);
  EXPECT_GT(metrics.deviation[horizon_window].velocity, 0.0);
}

TEST_F(StandardCase, MissedAndInventedImpactsAreSeen) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  run.impacts.erase(run.impacts.begin() + 3);
  RecordedImpact invented = run.impacts[5];
  invented.cable = 1 - invented.cable;
  run.impacts.insert(run.impacts.begin() + 6, invented);
  const Metrics metrics = compare(the_case, solution, settled, solution.end_time(), run);
  EXPECT_EQ(metrics.impacts[whole].exact, 79U);
  EXPECT_EQ(metrics.impacts[whole].found, 79U);
  EXPECT_LE(metrics.impacts[whole].matched, 78U);
}

TEST_F(StandardCase, WhatARunDoesNotReachItMisses) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  std::erase_if(run.points, [](const Point& point) { return point.time > 0.2; });
  std::erase_if(run.impacts, [](const RecordedImpact& impact) { return impact.time > 0.2; });
  const Metrics metrics = compare(the_case, solution, settled, 6.0, run);
  EXPECT_EQ(metrics.deviation[horizon_window].until, 6.0);
  EXPECT_NEAR(metrics.deviation[horizon_window].covered, 0.2, 2e-3);
  EXPECT_EQ(metrics.impacts[whole].exact, 79U);
  EXPECT_EQ(metrics.impacts[whole].matched, 1U);
}

TEST_F(StandardCase, AWindowWithoutSamplesIsNotCovered) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  std::erase_if(run.points,
                [](const Point& point) { return point.time > 0.0 && point.time < 5.0; });
  const Metrics metrics = compare(the_case, solution, settled, 6.0, run);
  EXPECT_EQ(metrics.deviation[early].covered, 0.0);
  EXPECT_GT(metrics.deviation[horizon_window].covered, 5.0);
}

TEST_F(StandardCase, ImpactsAfterTheEndAndOfSeveralStepsAreCountedApart) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  run.impacts[2].steps = 5;
  run.impacts[2].rate_after = 7.0;  // would be a restitution far above 1
  RecordedImpact late = run.impacts[0];
  late.time = 15.0;
  run.impacts.push_back(late);
  const Metrics metrics = compare(the_case, solution, settled, solution.end_time(), run);
  EXPECT_EQ(metrics.long_impacts, 1U);
  EXPECT_EQ(metrics.later_impacts, 1U);
  ASSERT_TRUE(metrics.restitution);
  EXPECT_EQ(metrics.restitution->count, 78U);
  EXPECT_NEAR(metrics.restitution->largest, 0.9, 1e-12);
  EXPECT_EQ(metrics.last_impacts.front().found, 15.0) << "a run that still bounces has not settled";
}

TEST_F(StandardCase, LastFastImpactsAreThoseOfTheRun) {
  const Metrics same =
      compare(the_case, solution, settled, solution.end_time(), as_run(the_case, solution, 0, 0));
  // computed with 60 digits, where two digits of the first are lost to rounding
  ASSERT_EQ(same.last_impacts.size(), 2U);
  EXPECT_EQ(same.last_impacts[0].speed, 1e-2);
  EXPECT_NEAR(same.last_impacts[1].exact.value(), 8.114010, 1e-5);
  constexpr double delay = 1e-3;
  const Metrics late = compare(the_case, solution, settled, solution.end_time(),
                               as_run(the_case, solution, delay, 0.0));
  for (std::size_t index = 0; index < 2; ++index) {
    EXPECT_EQ(same.last_impacts[index].found, same.last_impacts[index].exact);
    EXPECT_NEAR(late.last_impacts[index].found.value(), *late.last_impacts[index].exact + delay,
                1e-12);
  }
}

TEST_F(StandardCase, LastImpactsBeyondTheHorizonAreNotHeldAgainstEachOther) {
  const Trajectory run = as_run(the_case, solution, 0, 0);
  const double lock = settled.lock->time;
  for (const auto& [horizon, told] : {std::pair(lock, true), std::pair(lock - 1e-9, false)}) {
    for (const LastImpactMatch& last :
         compare(the_case, solution, settled, horizon, run).last_impacts) {
      EXPECT_EQ(last.exact.has_value(), told) << horizon;
      EXPECT_EQ(last.found.has_value(), told) << horizon;
    }
  }
}

TEST_F(StandardCase, ARunThatStoppedBeforeHasNoSettlingTime) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  const auto cut = [&](double time) {
    std::erase_if(run.points, [=](const Point& point) { return point.time > time; });
    std::erase_if(run.impacts, [=](const RecordedImpact& impact) { return impact.time > time; });
    run.stop = Simulation::Stop{time, "impacts accumulate"};
    return compare(the_case, solution, settled, solution.end_time(), run);
  };
  const Metrics at_the_lock = cut(8.129);
  EXPECT_EQ(at_the_lock.last_impacts[1].found, at_the_lock.last_impacts[1].exact);
  EXPECT_FALSE(at_the_lock.swing) << "nothing of the swing was seen";
  const Metrics before = cut(5.0);
  EXPECT_FALSE(before.last_impacts[0].found);
  EXPECT_TRUE(before.last_impacts[0].exact);
}

TEST_F(StandardCase, ImpulsesAndEnergyLossesAreHeldAgainstTheExactOnes) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  const Metrics exact = compare(the_case, solution, settled, 6.0, run);
  EXPECT_LT(exact.impulse_error.value(), 1e-9);
  EXPECT_LT(exact.energy_loss_error.value(), 1e-14);
  constexpr double stronger = 1.02;
  constexpr double more = 0.01;  // [m/s], of the speed after
  RecordedImpact& impact = run.impacts.at(2);
  const double lost = energy(the_case, impact.before) - energy(the_case, impact.after);
  impact.impulse *= stronger;
  impact.after.velocity *= 1.0 + more;
  const double now = energy(the_case, impact.before) - energy(the_case, impact.after);
  const Metrics spoilt = compare(the_case, solution, settled, 6.0, run);
  EXPECT_NEAR(spoilt.impulse_error.value(), 2.0, 1e-9);
  EXPECT_NEAR(spoilt.energy_loss_error.value(), std::abs(now - lost), 1e-14);
  impact.steps = 3;  // a push over several steps loses energy along its way
  EXPECT_LT(compare(the_case, solution, settled, 6.0, run).energy_loss_error.value(), 1e-14);
  run.impacts.clear();
  EXPECT_FALSE(compare(the_case, solution, settled, 6.0, run).impulse_error);
}

TEST_F(StandardCase, WhatSeveralCablesShareIsNoErrorOfOneOfThem) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  RecordedImpact shared = run.impacts.at(2);
  run.impacts.at(2).impulse *= 2.0;
  shared.cable = 1 - shared.cable;
  run.impacts.insert(run.impacts.begin() + 3, shared);
  EXPECT_LT(compare(the_case, solution, settled, 6.0, run).impulse_error.value(), 1e-9);
}

TEST(MetricList, WhatIsNotFiniteWasNotMeasured) {
  Metrics metrics;
  metrics.overstretch = std::numeric_limits<double>::infinity();
  metrics.energy_gain = std::numeric_limits<double>::quiet_NaN();
  metrics.energy_error = 0.5;
  const MetricValues values = values_of(metrics);
  EXPECT_FALSE(values.at(place_of("overstretch").value()));
  EXPECT_FALSE(values.at(place_of("energy_gain").value()));
  EXPECT_EQ(values.at(place_of("energy_error").value()), 0.5);
}

TEST_F(StandardCase, SwingIsMeasuredOverTheLastPeriod) {
  Trajectory run = as_run(the_case, solution, 0.0, 0.0);
  const SwingMatch exact = compare(the_case, solution, settled, 6.0, run).swing.value();
  EXPECT_NEAR(exact.until - exact.from, 3.2727, 1e-4);
  EXPECT_NEAR(exact.energy.found, exact.energy.exact, 1e-14);
  EXPECT_NEAR(exact.energy.exact, 0.019679140, 1e-8);
  // between samples 1e-3 apart the largest angle is missed by less than 0.65 (1.9 * 5e-4)^2 / 2
  EXPECT_NEAR(exact.amplitude.found, exact.amplitude.exact, 3e-7);
  constexpr double lift = 0.01;  // the energy rises by mass times gravity times this
  for (Point& point : run.points) {
    point.state.position.y() += lift;
    point.state.angle *= 2.0;
  }
  const SwingMatch lifted = compare(the_case, solution, settled, 6.0, run).swing.value();
  EXPECT_NEAR(lifted.energy.found, exact.energy.found + lift, 1e-14);
  EXPECT_NEAR(lifted.amplitude.found, 2.0 * exact.amplitude.found, 1e-14);
  std::erase_if(run.points, [](const Point& point) { return point.time > 11.0; });
  EXPECT_FALSE(compare(the_case, solution, settled, 6.0, run).swing) << "less than a period";
}

TEST(Settling, OfAMotionThatDoesNotLockIsNone) {
  const Case ball = bouncing_ball(1.0);
  const Solution solution = solve(ball);
  const Metrics metrics =
      compare(ball, solution, settling(ball, solution), 1.0, as_run(ball, solution, 0.0, 0.0));
  for (const LastImpactMatch& last : metrics.last_impacts) {
    EXPECT_FALSE(last.exact);
    EXPECT_FALSE(last.found);
  }
  EXPECT_FALSE(metrics.swing);
}

TEST(Matching, PairsMutualNearestOnOneCable) {
  const std::vector<CountedImpact> exact = {{1.0, 0}, {2.0, 1}, {3.0, 0}};
  const std::vector<CountedImpact> found = {{1.01, 0}, {1.02, 0}, {2.1, 0}, {3.05, 0}};
  const auto pairs = match_impacts(exact, found);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_EQ(pairs[0], std::pair(std::size_t{0}, std::size_t{0}));
  EXPECT_EQ(pairs[1], std::pair(std::size_t{2}, std::size_t{3}));
}

TEST(Matching, AnImpactAMomentAfterTheWindowIsFoundAsItIsMatched) {
  const std::vector<CountedImpact> exact = {{1.0, 0}, {2.0, 0}};
  const std::vector<CountedImpact> found = {{1.0, 0}, {2.0 + 1e-9, 0}, {2.5, 0}};
  const ImpactMatch match = impacts_until(2.0, exact, found, match_impacts(exact, found));
  EXPECT_EQ(match.exact, 2U);
  EXPECT_EQ(match.matched, 2U);
  EXPECT_EQ(match.found, 2U);
}

std::vector<CountedImpact> any_impacts() {
  std::vector<CountedImpact> impacts;
  int tick = 0;
  for (int index = *rc::gen::inRange(0, 30); index > 0; --index) {
    tick += *rc::gen::inRange(0, 5);
    impacts.push_back({0.1 * tick, *rc::gen::inRange<std::size_t>(0, 3)});
  }
  return impacts;
}

RC_GTEST_PROP(Matching, NeverMatchesMoreThanThereAreOnEitherSide, ()) {
  const auto exact = any_impacts();
  const auto found = any_impacts();
  const double end = 0.1 * *rc::gen::inRange(0, 100);
  const ImpactMatch match = impacts_until(end, exact, found, match_impacts(exact, found));
  RC_ASSERT(match.matched <= match.exact);
  RC_ASSERT(match.matched <= match.found);
}

RC_GTEST_PROP(Matching, IsOneToOneAndOnOneCable, ()) {
  const auto exact = any_impacts();
  const auto found = any_impacts();
  std::set<std::size_t> left;
  std::set<std::size_t> right;
  for (const auto& [i, j] : match_impacts(exact, found)) {
    RC_ASSERT(exact[i].cable == found[j].cable);
    RC_ASSERT(left.insert(i).second);
    RC_ASSERT(right.insert(j).second);
  }
}

TEST(Horizon, OfTheElasticCaseLiesWhereItsGrowthPutsIt) {
  // computed with 70 digits: 1e-12 has grown to 1e-2 by t = 15.89 and 1e-9 by t = 12.07, so 1e-12
  // reaches 1e-3 between the two
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name == "breakwater/1110121100") {
      const double horizon = predictability_horizon(the_case, solve(the_case));
      RecordProperty("horizon", std::to_string(horizon));
      EXPECT_GT(horizon, 12.07);
      EXPECT_LT(horizon, 15.89);
    }
  }
}

TEST(Horizon, OfAStableMotionIsItsEnd) {
  const Case ball = bouncing_ball(0.5);
  const Solution solution = solve(ball);
  EXPECT_EQ(predictability_horizon(ball, solution), solution.end_time());
}

}  // namespace
}  // namespace tautline::bench
