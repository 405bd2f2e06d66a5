#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <iostream>

#include "hard/stopwatch.hpp"
#include "support.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t system_seed = 20240607;
#ifdef TAUTLINE_SANITIZED
constexpr int systems_per_count = 40;  // sanitizers slow this down tenfold
#else
constexpr int systems_per_count = 1250;  // 10,000 over the eight numbers of cables
#endif

/// Bounces between two almost parallel elastic cables may be as many as one likes; this many is
/// enough to see that they are real.
constexpr std::size_t event_limit = 20'000;

constexpr std::array laws = {ImpactLaw::simultaneous, ImpactLaw::poisson, ImpactLaw::sequential,
                             ImpactLaw::energetic};

/// What became of many systems.
struct SystemTally {
  std::array<int, 10> endings{};  // by Ending
  double overstretch = 0.0;       // [-], of a cable's length
  double drift = 0.0;             // [-], of a taut cable's gap, of its length
  double energy_gain = 0.0;       // [-], of the case's energy scale
  double energy_drift = 0.0;      // [-], between events, of that scale
  double held_rate = 0.0;         // [m/s], of a taut cable
  double push = 0.0;              // [-], a tension below zero, of the weights in the system
  double slowest = 0.0;           // [s] of processor time for one system
};

/// Samples `solution` at even times.
void measure_samples(const Case& the_case, const Solution& solution, SystemTally& tally) {
  constexpr int samples = 400;
  for (int k = 0; k <= samples; ++k) {
    const double part = std::min(1.0, static_cast<double>(k) / samples);
    const State state = solution.at(part * solution.end_time());
    for (const Cable& cable : the_case.cables) {
      tally.overstretch = std::max(tally.overstretch, -gap(cable, state) / cable.length);
    }
  }
}

/// Checks that the cables an arc says are taut are held by tensions at its start.
void measure_taut_arcs(const Case& the_case, const Solution& solution, SystemTally& tally) {
  for (const Arc& arc : solution.arcs()) {
    if (arc.taut.empty()) {
      continue;
    }
    const State& state = arc.initial;
    for (const std::size_t index : arc.taut) {
      const Cable& cable = the_case.cables[index];
      tally.drift = std::max(tally.drift, std::abs(gap(cable, state)) / cable.length);
      tally.held_rate = std::max(tally.held_rate, std::abs(gap_rate(cable, state)));
    }
    if (!independent(the_case, state, arc.taut)) {
      continue;  // shared between redundant cables in one of many ways
    }
    CableVector free(static_cast<Eigen::Index>(arc.taut.size()));
    Eigen::Index row = 0;
    for (const std::size_t index : arc.taut) {
      free[row++] = -free_gap_acceleration(the_case, index, state);
    }
    const CableVector tension = multipliers(the_case, state, arc.taut, free);
    const double weight = the_case.body.mass + tension.cwiseAbs().maxCoeff();
    tally.push = std::max(tally.push, -tension.minCoeff() / weight);
  }
}

/// An ending must be what it says.
void expect_truthful(const Case& the_case, const Solution& solution, SystemTally& tally) {
  ++tally.endings[static_cast<std::size_t>(solution.ending())];
  switch (solution.ending()) {
    case Ending::reached_duration:
      EXPECT_EQ(solution.end_time(), the_case.duration);
      break;
    case Ending::unstable_rest:
    case Ending::rest: {
      EXPECT_EQ(solution.end_time(), the_case.duration);
      const Arc& last = solution.arcs().back();
      EXPECT_FALSE(last.taut.empty());
      const auto held = resting_tensions(the_case, last.initial, last.taut);
      ASSERT_TRUE(held.has_value());
      EXPECT_EQ(speed_scale(the_case, solution.at(the_case.duration)), 0.0);
      State resting = last.initial;  // a point mass may turn, which nothing notices
      resting.angle += resting.spin * (last.end - last.start);
      EXPECT_EQ(difference(solution.at(the_case.duration), resting), 0.0);
      break;
    }
    case Ending::event_limit:
      EXPECT_GE(solution.events().size(), event_limit);
      break;
    case Ending::no_progress: {
      // elastic cables throw the body to and fro within an instant
      const std::vector<Event>& events = solution.events();
      const Event& earlier = events.at(events.size() - 5'000);
      EXPECT_LE(events.back().time - earlier.time, 1e-11 * events.back().time);
      break;
    }
    case Ending::singular: {
      // at the end no tension of a sensible size holds the cables at zero gap and rate
      const State end = solution.at(solution.end_time());
      CableSet resting;
      for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
        const Cable& cable = the_case.cables[index];
        if (gap(cable, end) < 1e-9 * cable.length && std::abs(gap_rate(cable, end)) < 1e-6) {
          resting.insert(index);
        }
      }
      EXPECT_GE(resting.size(), 2U) << "only two or more cables can jam";
      break;
    }
    default:
      ADD_FAILURE() << "ended with " << to_string(solution.ending()) << ", which no limit allows";
  }
}

/// No event adds energy, and none comes or goes between events.
void measure_energy(const Case& the_case, const Solution& solution, SystemTally& tally) {
  const double scale = energy_scale(the_case);
  double last = energy(the_case, the_case.initial);
  for (const Event& event : solution.events()) {
    const double before = energy(the_case, event.before);
    const double after = energy(the_case, event.after);
    tally.energy_drift = std::max(tally.energy_drift, std::abs(before - last) / scale);
    tally.energy_gain = std::max(tally.energy_gain, (after - before) / scale);
    last = after;
  }
}

class RandomSystems : public ::testing::TestWithParam<int> {};

TEST_P(RandomSystems, EndTruthfullyInTimeWithoutOverstretch) {
  Random random(system_seed + static_cast<std::uint64_t>(GetParam()));
  SystemTally tally;
  SolveOptions options;
  options.max_events = event_limit;
  for (int sample = 0; sample < systems_per_count; ++sample) {
    Case the_case = random_case(random, {static_cast<std::size_t>(GetParam()), 0.0, 0.2});
    the_case.duration = 20.0;
    if (sample % 5 == 4 && the_case.cables.size() < max_cables) {
      the_case.cables.push_back(the_case.cables.front());  // redundant at every pose
    }
    options.law = laws[static_cast<std::size_t>(sample) % laws.size()];
    SCOPED_TRACE("sample " + std::to_string(sample));
    ASSERT_TRUE(problems(the_case).empty()) << problems(the_case).front();
    const std::clock_t begin = std::clock();
    const Solution solution = solve(the_case, options);
    tally.slowest = std::max(tally.slowest, seconds_since(begin));
    measure_samples(the_case, solution, tally);
    measure_taut_arcs(the_case, solution, tally);
    measure_energy(the_case, solution, tally);
    expect_truthful(the_case, solution, tally);
  }
  std::cout << "  seed " << system_seed << " + " << GetParam() << '\n';
  for (std::size_t ending = 0; ending < tally.endings.size(); ++ending) {
    std::cout << "  " << to_string(static_cast<Ending>(ending)) << ": " << tally.endings[ending]
              << '\n';
  }
  expect_within("overstretch by length", tally.overstretch, 1e-12);  // = gap_rounding of the input
  expect_within("gap of a taut cable by length", tally.drift, 1e-12);
  expect_within("energy gain of an event", tally.energy_gain, 1e-13);  // some roundings
  expect_within("energy drift between events", tally.energy_drift, 1e-12);
  expect_within("negative tension", tally.push, 1e-9);                 // a release within rounding
  expect_within("rate of a taut cable [m/s]", tally.held_rate, 1e-9);  // almost dependent cables
  // 20,000 events take as long as some hundred standard cases
  expect_within("slowest, of the standard case's time", tally.slowest / time_of_standard_case(),
                35'000.0);
}

INSTANTIATE_TEST_SUITE_P(Cables, RandomSystems, ::testing::Range(1, 9));

}  // namespace
}  // namespace tautline::test
