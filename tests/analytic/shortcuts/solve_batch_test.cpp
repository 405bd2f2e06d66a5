#include "tautline/solve_batch.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "hard/hard_families.hpp"
#include "shortcuts/batch/in_lane.hpp"
#include "shortcuts/single_bounces.hpp"
#include "support.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t batch_seed = 20261124;
#ifdef TAUTLINE_SANITIZED
constexpr int systems_per_count = 20;
constexpr int questions = 300;
#else
constexpr int systems_per_count = 150;
constexpr int questions = 3'000;
#endif

/// True for the same bits, also of NaN and of zeros with a sign.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const Vec2& a, const Vec2& b) { return same(a.x(), b.x()) && same(a.y(), b.y()); }

bool same(const State& a, const State& b) {
  return same(a.position, b.position) && same(a.angle, b.angle) && same(a.velocity, b.velocity) &&
         same(a.spin, b.spin);
}

bool same(const Event& a, const Event& b) {
  return same(a.time, b.time) && a.kind == b.kind && a.cables == b.cables &&
         a.impulses == b.impulses && same(a.before, b.before) && same(a.after, b.after);
}

bool same(const Arc& a, const Arc& b) {
  return same(a.start, b.start) && same(a.end, b.end) && same(a.initial, b.initial) &&
         a.taut == b.taut && a.series.rows() == b.series.rows() && a.series == b.series;
}

bool same(const Accumulation& a, const Accumulation& b) {
  return same(a.start, b.start) && same(a.time, b.time) && same(a.uncertainty, b.uncertainty) &&
         a.cables == b.cables && same(a.energy_lost, b.energy_lost);
}

bool same(const std::optional<Swing>& a, const std::optional<Swing>& b) {
  if (!a || !b) {
    return a.has_value() == b.has_value();
  }
  return same(a->energy, b->energy) && same(a->period, b->period) && same(a->least, b->least) &&
         same(a->largest, b->largest) && same(a->amplitude, b->amplitude);
}

template <class Part>
void expect_same(const std::vector<Part>& batch, const std::vector<Part>& alone,
                 const std::string& what) {
  ASSERT_EQ(batch.size(), alone.size()) << what;
  for (std::size_t k = 0; k < batch.size(); ++k) {
    ASSERT_TRUE(same(batch[k], alone[k])) << what << " " << k << " of " << batch.size();
  }
}

/// Solves all of them side by side and one by one.
void expect_same_solutions(const std::vector<Case>& cases, const SolveOptions& options = {}) {
  std::vector<int> taken(cases.size(), 0);
  solve_batch(cases, options, [&](std::size_t index, const Solution& solution) {
    ++taken[index];
    const Solution alone = solve(cases[index], options);
    const std::string name = "case " + std::to_string(index) + " " + cases[index].name;
    EXPECT_EQ(solution.ending(), alone.ending()) << name;
    EXPECT_TRUE(same(solution.swing(), alone.swing())) << name;
    expect_same(solution.events(), alone.events(), name + ", event");
    expect_same(solution.arcs(), alone.arcs(), name + ", arc");
    expect_same(solution.accumulations(), alone.accumulations(), name + ", accumulation");
  });
  EXPECT_EQ(taken, std::vector<int>(cases.size(), 1)) << "each once";
}

TEST(SolveBatch, ShippedCasesHaveTheirOwnSolutionsToTheBit) {
  expect_same_solutions(shipped_cases());
  expect_same_solutions(shipped_cases(), {.law = ImpactLaw::sequential, .until_locked = true});
  expect_same_solutions(shipped_cases(), {.until_locked = true, .swing_ahead = true});
}

TEST(SolveBatch, CopiesOfACaseHaveTheirOwnSolutionsToTheBit) {
  Random random(batch_seed);
  for (const char* const number : {"1910121100", "1510121100", "1110121100", "1900461100"}) {
    std::vector<Case> copies;
    for (int copy = 0; copy < systems_per_count / 4; ++copy) {
      copies.push_back(table_case(number));
      copies.back().initial.position += random.in_square(1e-3);
      copies.back().initial.spin += random.uniform(-1e-3, 1e-3);
      copies.back().body.mass = random.uniform(0.5, 2.0);
    }
    expect_same_solutions(copies);
  }
}

TEST(SolveBatch, RandomSystemsHaveTheirOwnSolutionsToTheBit) {
  Random random(batch_seed);
  const SolveOptions options{.max_events = 2'000};
  for (std::size_t cables = 1; cables <= max_cables; ++cables) {
    std::vector<Case> cases;
    for (int system = 0; system < systems_per_count; ++system) {
      cases.push_back(random_case(random, {cables, 0.0, 0.3}));
      cases.back().duration = 3.0;
    }
    cases.push_back(table_case("1910121100"));  // among others, with cables of its own
    expect_same_solutions(cases, options);
  }
}

TEST(SolveBatch, HardSystemsHaveTheirOwnSolutionsToTheBit) {
  Random random(batch_seed);
  const SolveOptions options{.max_events = 1'000, .max_steps = 1'000};
  for (const HardFamily& family : hard_families()) {
    std::vector<Case> cases;
    for (int sample = 0; sample < systems_per_count / 6; ++sample) {
      if (auto system = hard_system(random, family, sample)) {
        cases.push_back(std::move(system->the_case));
      }
    }
    expect_same_solutions(cases, options);
  }
}

TEST(SolveBatch, SeveralThreadsDoNotDisturbEachOther) {
  const std::vector<Case> cases = shipped_cases();
  std::vector<std::jthread> threads;
  for (int count = 0; count < 4; ++count) {
    threads.emplace_back([&cases] { expect_same_solutions(cases); });
  }
}

TEST(SolveBatch, ACaseWithAProblemIsNamedBeforeAnyIsSolved) {
  std::vector<Case> cases = {table_case("1910121100"), table_case("1910121100")};
  cases[1].cables[0].restitution = 1.2;
  bool any_taken = false;
  EXPECT_THROW(solve_batch(cases, {}, [&](std::size_t, const Solution&) { any_taken = true; }),
               std::invalid_argument);
  EXPECT_FALSE(any_taken);
  EXPECT_NO_THROW(solve_batch({}, {}, [&](std::size_t, const Solution&) { any_taken = true; }));
  EXPECT_FALSE(any_taken);
}

TEST(SolveBatch, WhatTheTakerThrowsReachesTheCaller) {
  const std::vector<Case> cases(20, table_case("1510121100"));
  EXPECT_THROW(solve_batch(cases, {},
                           [](std::size_t, const Solution&) { throw std::runtime_error("full"); }),
               std::runtime_error);
}

/// Asks for a flight of `the_case` in a lane.
void ask(LaneQuestion& question, std::size_t lane, const Case& the_case, bool touches) {
  const InLane set{lane};
  SolveOptions options;
  options.completion = question.limits;
  const SingleBounces<Case> bounces(the_case, options);
  const Attempts<Case> attempts(the_case.cables.size(), options.completion);
  const std::optional<Hold> flies;
  const Touching none;
  const auto search =
      bounces.search({the_case, the_case.initial, none, {}, flies, the_case.duration}, attempts);
  set(question.world, bounces.world());
  set(question.from, search.from);
  set(question.from.rate_rounding, 1e-15);
  set(question.from.spin_rounding, 1e-15);
  for (std::size_t place = 0; place < question.count; ++place) {
    set(question.cables[place], bounces.cable_of(search, place));
  }
  set(question.touches, touches ? 1.0 : 0.0);
  set(question.horizon, search.horizon);
}

/// How many answers are of another bit. What is no bounce has no numbers.
int different(const LaneAnswer& a, const LaneAnswer& b) {
  int count = 0;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const auto is = [&](const LaneNumbers& x, const LaneNumbers& y) {
      return same(x.of[lane], y.of[lane]);
    };
    const auto are = [&](const Pair<LaneNumbers>& x, const Pair<LaneNumbers>& y) {
      return is(x.x, y.x) && is(x.y, y.y);
    };
    const bool numbers =
        is(a.dt, b.dt) && is(a.place, b.place) && are(a.before.position, b.before.position) &&
        is(a.before.angle, b.before.angle) && are(a.before.velocity, b.before.velocity) &&
        is(a.before.spin, b.before.spin) && is(a.before.rate_rounding, b.before.rate_rounding) &&
        is(a.before.spin_rounding, b.before.spin_rounding) && is(a.impulse, b.impulse) &&
        are(a.velocity, b.velocity) && is(a.spin, b.spin) && is(a.is_due, b.is_due) &&
        is(a.tried, b.tried);
    const bool is_all = a.is_all.of[lane] > 0.0;
    count += is(a.is_all, b.is_all) && (numbers || !is_all) ? 0 : 1;
  }
  return count;
}

/// Flights from slow to absurd: every decade of spins, and numbers that overflow.
Case random_flight(Random& random, std::size_t cables) {
  Case result = random_case(random, {cables, 0.01, 0.0});
  result.initial.spin *= random.log_uniform(1e-6, 1e6);
  result.initial.angle *= random.log_uniform(1e-3, 1e4);
  result.duration = random.log_uniform(1e-6, 1e2);
  if (random.chance(0.02)) {
    result.initial.velocity *= 1e200;
  }
  if (random.chance(0.01)) {
    result.initial.position.x() = std::nan("");
  }
  return result;
}

using Kind = std::pair<const char*, BounceLanes>;

/// The kinds of lanes that this processor and this build have.
std::vector<Kind> kinds() {
  std::vector<Kind> result;
#ifdef TAUTLINE_LANES
  if (__builtin_cpu_supports("avx2")) {
    result.emplace_back("AVX2", bounce_lanes_avx2);
  }
  if (__builtin_cpu_supports("avx512f")) {
    result.emplace_back("AVX-512", bounce_lanes_avx512);
  }
#endif
  return result;
}

TEST(SolveBatch, LanesOfAnyWidthAnswerToTheBitAsOne) {
  // none where this processor or this build has none
  for (const auto& [name, bounce_lanes] : kinds()) {
    Random random(batch_seed);
    int wrong = 0;
    int found = 0;
    for (int k = 0; k < questions; ++k) {
      LaneQuestion question;
      question.count = 1 + static_cast<std::size_t>(k) % max_cables;
      for (std::size_t lane = 0; lane < lanes; ++lane) {
        ask(question, lane, random_flight(random, question.count), random.chance(0.3));
      }
      LaneAnswer one;
      LaneAnswer several;
      bounce_lanes_one_by_one(question, one);
      bounce_lanes(question, several);
      wrong += different(several, one);
      for (const double is : one.is_all.of) {
        found += is > 0.0 ? 1 : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << name << ", seed " << batch_seed;
    EXPECT_GT(found, questions) << "most questions are worth asking";
  }
}

}  // namespace
}  // namespace tautline::test
