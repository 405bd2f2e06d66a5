#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "hard/hard_families.hpp"
#include "support.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

// Every shortcut leads to the motion that the general path finds. The lanes of solve_batch and
// swings told ahead have tests of their own: SolveBatch, SwingAhead.

namespace tautline::test {
namespace {

#ifdef TAUTLINE_SANITIZED
constexpr int systems = 40;
#else
constexpr int systems = 400;
#endif
constexpr std::uint64_t shortcut_seed = 20261126;
constexpr std::size_t most_events = 2'000;

/// True where the numbers differ by no more than the bounds of the errors of both allow.
bool within(const State& a, const State& b, const State& bound) {
  const State off{(a.position - b.position).cwiseAbs(), std::abs(a.angle - b.angle),
                  (a.velocity - b.velocity).cwiseAbs(), std::abs(a.spin - b.spin)};
  return off.position.x() <= 2 * bound.position.x() && off.position.y() <= 2 * bound.position.y() &&
         off.angle <= 2 * bound.angle && off.velocity.x() <= 2 * bound.velocity.x() &&
         off.velocity.y() <= 2 * bound.velocity.y() && off.spin <= 2 * bound.spin;
}

/// How many events were compared, and how many of them differ in a bit: not all are the same, or a
/// shortcut was not turned off.
struct SameEvents {
  std::size_t count = 0;
  std::size_t rounded = 0;
  void operator+=(const SameEvents& other) {
    count += other.count;
    rounded += other.rounded;
  }
};

/// Expects the same events as far as they are sure, to the bounds of their errors.
SameEvents expect_same_events(const Case& the_case, const SolveOptions& with,
                              const SolveOptions& without, const std::string& name) {
  const Solution one = solve(the_case, with);
  const Solution other = solve(the_case, without);
  const Uncertainty sure(the_case, one, with);
  SameEvents result;
  std::size_t& same = result.count;
  for (; same < one.events().size() && sure.events()[same]; ++same) {
    EXPECT_LT(same, other.events().size()) << name;
    if (same >= other.events().size()) {
      break;
    }
    const Event& a = one.events()[same];
    const Event& b = other.events()[same];
    const EventErrors& errors = *sure.events()[same];
    result.rounded += a.time != b.time || a.after.velocity != b.after.velocity ? 1U : 0U;
    EXPECT_TRUE(a.kind == b.kind && a.cables == b.cables &&
                std::abs(a.time - b.time) <= 2 * errors.time &&
                within(a.before, b.before, errors.before) && within(a.after, b.after, errors.after))
        << name << ", event " << same << " at " << a.time;
  }
  if (!sure.horizon()) {
    EXPECT_EQ(one.ending(), other.ending()) << name;
    EXPECT_EQ(one.events().size(), other.events().size()) << name;
  }
  return result;
}

TEST(Shortcuts, SingleBouncesAreThoseOfTheGeneralPathInRandomSystems) {
  Random random(shortcut_seed);
  SameEvents events;
  for (int sample = 0; sample < systems; ++sample) {
    const auto cables = static_cast<std::size_t>(sample) % max_cables + 1;
    const Case the_case = random_case(random, {cables, 0.0, 0.2});
    SolveOptions with;
    with.max_events = most_events;
    with.law = impact_laws[static_cast<std::size_t>(sample) % impact_laws.size()];
    SolveOptions without = with;
    without.single_bounces = false;
    events += expect_same_events(the_case, with, without,
                                 "system " + std::to_string(sample) + " of the seed");
  }
  EXPECT_GT(events.count, static_cast<std::size_t>(10 * systems));
  EXPECT_GT(events.rounded, 0U);
}

TEST(Shortcuts, SingleBouncesAreThoseOfTheGeneralPathInHardSystems) {
  Random random(hard_seed);
  SameEvents events;
  for (int sample = 0; sample < systems; ++sample) {
    const HardFamily& family =
        hard_families()[static_cast<std::size_t>(sample) % hard_families().size()];
    if (const auto system = hard_system(random, family, sample)) {
      SolveOptions with;
      with.max_events = most_events;
      with.law = system->law;
      SolveOptions without = with;
      without.single_bounces = false;
      events += expect_same_events(system->the_case, with, without,
                                   std::string(family.name) + " " + std::to_string(sample));
    }
  }
  EXPECT_GT(events.count, static_cast<std::size_t>(systems));
  EXPECT_GT(events.rounded, 0U);
}

/// What a period that is used again, and steps over as long a time, may differ by [-]: rounding
/// that grows with the number of steps.
constexpr double as_in_steps = 1e-11;

/// Expects that the motion repeats, as steps over its whole duration do.
void expect_repeats_as_in_steps(const Case& the_case) {
  SolveOptions without;
  without.half_swings = false;
  const Solution followed = solve(the_case, without);
  const Solution repeated = solve(the_case);
  ASSERT_TRUE(repeated.repetition());
  EXPECT_FALSE(followed.repetition());
  EXPECT_GT(followed.arcs().size(), 2 * repeated.arcs().size());
  double worst = 0.0;
  constexpr double every = 0.73;  // [s]
  for (double time = 0.0; time < the_case.duration; time += every) {
    worst = std::max(worst, difference(followed.at(time), repeated.at(time)));
  }
  expect_within(the_case.name + ": difference from the motion in steps", worst, as_in_steps);
}

TEST(Shortcuts, HalfSwingsAreThoseThatStepsFollow) {
  Case the_case = table_case("1510121100");
  the_case.duration = 200.0;
  expect_repeats_as_in_steps(the_case);
}

TEST(Shortcuts, WholeTurnsAreThoseThatStepsFollow) {
  Case the_case;  // a pendulum that goes round
  the_case.name = "full circles";
  the_case.body.inertia = 0.0;
  the_case.cables = {Cable{{0.0, 0.0}, {0.0, 0.0}, 1.0, 0.0}};
  the_case.initial.position = {0.0, -1.0};
  the_case.initial.velocity = {3.0, 0.0};  // sqrt(5) and more goes round
  the_case.duration = 60.0;
  expect_repeats_as_in_steps(the_case);
}

TEST(Shortcuts, WithoutHalfSwingsNothingIsLocked) {
  SolveOptions options;
  options.until_locked = true;
  const Case the_case = table_case("1510121100");
  EXPECT_EQ(solve(the_case, options).ending(), Ending::locked);
  options.half_swings = false;
  EXPECT_EQ(solve(the_case, options).ending(), Ending::reached_duration);
}

TEST(Shortcuts, ShippedCasesAreTheSameWithoutAny) {
  SolveOptions without;
  without.single_bounces = without.half_swings = false;
  SameEvents events;
  for (const Case& the_case : shipped_cases()) {
    events += expect_same_events(the_case, {}, without, the_case.name);
    const Solution one = solve(the_case);
    const Solution other = solve(the_case, without);
    const Uncertainty sure(the_case, one);
    constexpr int samples = 40;
    for (int k = 0; k <= samples; ++k) {
      const double time = std::min(one.end_time(), other.end_time()) * k / samples;
      if (const auto errors = sure.at(time)) {
        EXPECT_TRUE(within(one.at(time), other.at(time), *errors)) << the_case.name << ", " << time;
      }
    }
  }
  EXPECT_GT(events.count, 1'000U);
  EXPECT_GT(events.rounded, 0U);
}

}  // namespace
}  // namespace tautline::test
