#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <iostream>

#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t seed = 20240607;
#ifdef __SANITIZE_ADDRESS__
constexpr int systems_per_count = 100;  // sanitizers slow this down tenfold
#else
constexpr int systems_per_count = 1000;
#endif

/// Bounces between two almost parallel elastic cables may be as many as one likes; this many is
/// enough to see that they are real.
constexpr std::size_t event_limit = 20'000;

/// What became of many systems.
struct Tally {
  std::array<int, 7> endings{};  // by Ending
  double overstretch = 0.0;      // [-], of a cable's length
  double energy_gain = 0.0;      // [-], of the case's energy scale
  double held_rate = 0.0;        // [m/s], of a cable said to be taut
  double slowest = 0.0;          // [s] of wall time for one system
};

double overstretch(const Case& the_case, const Solution& solution) {
  double worst = 0.0;
  constexpr int samples = 200;
  for (int k = 0; k <= samples; ++k) {
    const State state =
        solution.at(std::min(1.0, static_cast<double>(k) / samples) * solution.end_time());
    for (const Cable& cable : the_case.cables) {
      worst = std::max(worst, -gap(cable, state) / cable.length);
    }
  }
  return worst;
}

/// An ending must be what it says.
void expect_truthful(const Case& the_case, const Solution& solution, Tally& tally) {
  ++tally.endings[static_cast<std::size_t>(solution.ending())];
  switch (solution.ending()) {
    case Ending::reached_duration:
      EXPECT_EQ(solution.end_time(), the_case.duration);
      break;
    case Ending::overflow:
      ADD_FAILURE() << "sizes near one overflow at " << solution.end_time();
      break;
    case Ending::event_limit:
      EXPECT_GE(solution.events().size() + 1, event_limit);
      break;
    case Ending::zeno:
    case Ending::taut: {
      ASSERT_FALSE(solution.events().empty());
      const Event& taut = solution.events().back();
      EXPECT_EQ(taut.kind, EventKind::taut);
      EXPECT_EQ(taut.time, solution.end_time());
      for (const std::size_t index : taut.cables) {
        tally.held_rate =
            std::max(tally.held_rate, std::abs(gap_rate(the_case.cables[index], taut.after)));
      }
      const auto held = resting_tensions(the_case, taut.after, taut.cables);
      ASSERT_TRUE(held.has_value()) << "no tension holds the cables said to be taut";
      EXPECT_GE(held->tension.minCoeff(), 0.0);
      if (solution.ending() == Ending::zeno) {
        EXPECT_GE(solution.accumulation()->time, solution.end_time());
        EXPECT_GT(held->tension.minCoeff(), 0.0);
      }
      break;
    }
    default:
      ADD_FAILURE() << "ended with " << to_string(solution.ending()) << ", which no limit allows";
  }
}

double worst_gain(const Case& the_case, const Solution& solution) {
  double worst = 0.0;
  double last = energy(the_case, the_case.initial);
  for (const Event& event : solution.events()) {
    worst = std::max(worst, energy(the_case, event.after) - last);
    last = energy(the_case, event.after);
  }
  return worst / energy_scale(the_case);
}

class RandomSystems : public ::testing::TestWithParam<int> {};

TEST_P(RandomSystems, EndTruthfullyInTimeWithoutOverstretch) {
  Random random(seed + static_cast<std::uint64_t>(GetParam()));
  Tally tally;
  SolveOptions options;
  options.max_events = event_limit;
  for (int sample = 0; sample < systems_per_count; ++sample) {
    const Case the_case = random_case(random, {static_cast<std::size_t>(GetParam()), 0.0, 0.2});
    SCOPED_TRACE("sample " + std::to_string(sample));
    ASSERT_TRUE(problems(the_case).empty()) << problems(the_case).front();
    const auto begin = std::chrono::steady_clock::now();
    const Solution solution = solve(the_case, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    tally.slowest = std::max(tally.slowest, taken.count());
    tally.overstretch = std::max(tally.overstretch, overstretch(the_case, solution));
    tally.energy_gain = std::max(tally.energy_gain, worst_gain(the_case, solution));
    expect_truthful(the_case, solution, tally);
  }
  std::cout << "  seed " << seed << " + " << GetParam() << '\n';
  for (std::size_t ending = 0; ending < tally.endings.size(); ++ending) {
    std::cout << "  " << to_string(static_cast<Ending>(ending)) << ": " << tally.endings[ending]
              << '\n';
  }
  expect_within("overstretch by length", tally.overstretch, 1e-12);  // = gap_rounding of the input
  expect_within("energy gain", tally.energy_gain, 1e-13);  // of some roundings between two events
  expect_within("rate of a taut cable [m/s]", tally.held_rate, 1e-9);  // almost dependent cables
  expect_within("wall time of one system [s]", tally.slowest, 10.0);   // 20 000 events take 0.1 s
}

INSTANTIATE_TEST_SUITE_P(Cables, RandomSystems, ::testing::Range(1, 9));

}  // namespace
}  // namespace tautline::test
