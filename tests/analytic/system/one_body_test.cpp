#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/uncertainty.hpp"

// The two kernels solve one body on constant cables apart from each other: each checks the other.

namespace tautline::test {
namespace {

/// `the_case` without limits of validity, which a system has not.
Case without_limits(Case the_case) {
  the_case.angle_limit.reset();
  the_case.ceiling.reset();
  return the_case;
}

/// What differs between the first events of both kernels: times, and states before and after.
double difference_of_events(const Solution& planar, const BasicSolution<System>& general,
                            std::size_t count) {
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Event& one = planar.events()[i];
    const auto& other = general.events()[i];
    EXPECT_EQ(one.kind, other.kind) << "event " << i;
    EXPECT_EQ(one.cables, other.cables) << "event " << i;
    most = std::max({most, std::abs(one.time - other.time),
                     difference(one.before, other.before.bodies[0]),
                     difference(one.after, other.after.bodies[0])});
  }
  return most;
}

TEST(BothKernels, SolveTheFirstTenEventsOfEveryShippedCaseAlike) {
  // five of thirty grow by more than a hundred within ten events
  constexpr double close = 1e-13;
  std::size_t as_close = 0;
  double most = 0.0;
  for (const Case& shipped : shipped_cases()) {
    const Case the_case = without_limits(shipped);
    SCOPED_TRACE(the_case.name);
    SolveOptions options;
    options.max_events = 10;
    const Solution planar = solve(the_case, options);
    const auto general = solve(as_system(the_case), options);
    ASSERT_EQ(planar.events().size(), general.events().size());
    const double differ = difference_of_events(planar, general, planar.events().size());
    as_close += differ <= close ? 1U : 0U;
    most = std::max(most, differ);
  }
  EXPECT_GE(as_close, 25U);
  expect_within("largest difference in the first ten events", most, 5e-13);
}

/// The number of events up to which both kernels agree about kinds and cables.
std::size_t events_alike(const Solution& planar, const BasicSolution<System>& general) {
  const std::size_t count = std::min(planar.events().size(), general.events().size());
  for (std::size_t i = 0; i < count; ++i) {
    const Event& one = planar.events()[i];
    const auto& other = general.events()[i];
    if (one.kind != other.kind || one.cables != other.cables) {
      return i;
    }
  }
  return count;
}

TEST(BothKernels, FollowEveryShippedCaseToWhereItsDigitsEnd) {
  for (const Case& shipped : shipped_cases()) {
    const Case the_case = without_limits(shipped);
    SCOPED_TRACE(the_case.name);
    const Solution planar = solve(the_case);
    const auto general = solve(as_system(the_case));
    const std::size_t alike = events_alike(planar, general);
    const bool to_the_end = alike == planar.events().size() && alike == general.events().size();
    // where they part, rounding has grown to what decides between events
    double apart = 0.0;
    for (std::size_t i = 0; i < alike; ++i) {
      apart = std::max(apart,
                       difference(planar.events()[i].after, general.events()[i].after.bodies[0]));
    }
    EXPECT_TRUE(to_the_end || apart > 1e-8 || alike > 150) << alike << " events, " << apart;
  }
}

TEST(BothKernels, SolveTwoThousandRandomSystemsAlike) {
  Random random(20261127);
  int solved = 0;
  int others = 0;
  double most = 0.0;
  for (int i = 0; i < 2000; ++i) {
    Draw draw;
    draw.cables = 1 + static_cast<std::size_t>(i % 8);
    draw.taut_chance = 0.2;
    Case the_case = random_case(random, draw);
    the_case.duration = 2.0;
    if (!problems(the_case).empty()) {
      continue;
    }
    SolveOptions options;
    options.max_events = 6;
    const Solution planar = solve(the_case, options);
    const auto general = solve(as_system(the_case), options);
    ++solved;
    const std::size_t alike = events_alike(planar, general);
    others += alike < planar.events().size() ? 1 : 0;
    for (std::size_t k = 0; k < alike; ++k) {
      most =
          std::max(most, difference(planar.events()[k].after, general.events()[k].after.bodies[0]));
    }
  }
  EXPECT_GT(solved, 1500);
  EXPECT_LE(others, 4);  // elastic or nearly dependent cables, where rounding decides
  expect_within("largest difference in six events", most, 1e-9);
}

}  // namespace
}  // namespace tautline::test
