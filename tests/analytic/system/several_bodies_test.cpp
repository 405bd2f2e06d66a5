#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"
#include "system/systems.hpp"
#include "tautline/islands.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_ledger.hpp"

// Several bodies: what is conserved, islands, clusters.

namespace tautline::test {
namespace {

using SystemSolution = BasicSolution<System>;

TEST(Chain, KeepsItsMomentaWithoutGravity) {
  for (const double e : {0.9, 1.0}) {
    const System system = chain<double>(e);
    const SystemSolution solution = solve(system);
    ASSERT_GE(solution.events().size(), 18U);
    const SystemState end = solution.at(solution.end_time());
    const Vec2 moved = momentum(system, end) - momentum(system, system.initial);
    const double turned = angular_momentum<double>(system, end, Vec2(0.0, 0.0)) -
                          angular_momentum<double>(system, system.initial, Vec2(0.0, 0.0));
    expect_within("momentum [N s]", moved.norm(), 1e-14);
    // twelve units of time away, a rounding of the places weighs more
    expect_within("angular momentum [N m s]", std::abs(turned), 2e-14);
  }
}

TEST(Chain, KeepsItsEnergyWhereItIsElastic) {
  const System system = chain<double>(1.0);
  const SystemSolution solution = solve(system);
  const double start = kinetic_energy(system.bodies, system.initial);
  const double end = kinetic_energy(system.bodies, solution.at(solution.end_time()));
  expect_within("energy [-]", std::abs(end - start) / start, 1e-14);
}

TEST(TwoBodies, ShareTheSnapOfTheirCable) {
  // 1 kg at 12 m/s pulls 2 kg taut: inelastic, both go on with 4 m/s, and the impulse is 8 N s
  System system;
  system.gravity = {};
  system.bodies.resize(2);
  system.bodies[1].mass = 2.0;
  CableOfSystem cable;
  cable.from = {0, {0.0, 0.0}, {}};
  cable.to = {1, {0.0, 0.0}, {}};
  cable.length = Function<1>::constant(3.0);
  cable.restitution = 0.0;
  system.cables = {cable};
  system.initial.bodies = {{{0.0, 0.0}, 0.0, {12.0, 0.0}, 0.0}, {{0.0, 0.0}, 0.0, {0.0, 0.0}, 0.0}};
  system.initial.bodies[1].position = {-1.0, 0.0};
  const SystemSolution solution = solve(system);
  ASSERT_FALSE(solution.events().empty());
  EXPECT_NEAR(solution.events()[0].time, 1.0 / 6.0, 1e-15);
  EXPECT_NEAR(solution.events()[0].impulses[0], 8.0, 1e-14);
  EXPECT_NEAR(solution.at(1.0).bodies[1].velocity.x(), 4.0, 1e-14);
}

TEST(Ledger, ClosesWithTheWorkOfAllThatActs) {
  System bouncing = bouncer<double>(0.14);
  bouncing.duration = 13.0;  // [s]: a rounding of the time grows with it
  const System systems[] = {shaken<double>(), plastic<double>(), waves<double>(),
                            winch<double>(),  pulley<double>(),  in_series<double>(),
                            bouncing,         chain<double>(0.9)};
  for (const System& system : systems) {
    const SystemLedger ledger = energy_ledger(system, solve(system));
    expect_within("residual [-]", std::abs(ledger.residual) / ledger.range, 1e-14);
    EXPECT_GE(ledger.impacts, 0.0);
  }
}

/// `a` and `b`, which nothing joins, as one system.
System together(const System& a, const System& b) {
  System result = a;
  const std::size_t first = a.bodies.size();
  result.bodies.insert(result.bodies.end(), b.bodies.begin(), b.bodies.end());
  result.initial.bodies.insert(result.initial.bodies.end(), b.initial.bodies.begin(),
                               b.initial.bodies.end());
  for (CableOfSystem cable : b.cables) {
    for (End* end : {&cable.from, &cable.to}) {
      end->body = end->body ? std::optional(*end->body + first) : std::nullopt;
    }
    result.cables.push_back(cable);
  }
  return result;
}

TEST(Islands, MoveTogetherAsAlone) {
  System one = shaken<double>();
  System two = in_series<double>();
  one.duration = two.duration = 5.0;
  const SystemMotion motion = solve_islands(together(one, two));
  ASSERT_EQ(motion.parts().size(), 2U);
  const SystemSolution alone_one = solve(one);
  const SystemSolution alone_two = solve(two);
  EXPECT_EQ(motion.events().size(), alone_one.events().size() + alone_two.events().size());
  for (int k = 0; k <= 100; ++k) {
    const double time = 0.05 * k;
    const SystemState all = motion.at(time);
    const SystemState first = alone_one.at(time);
    const SystemState second = alone_two.at(time);
    EXPECT_EQ(difference(all.bodies[0], first.bodies[0]), 0.0);
    EXPECT_EQ(difference(all.bodies[1], second.bodies[0]), 0.0);
    EXPECT_EQ(difference(all.bodies[2], second.bodies[1]), 0.0);
  }
}

/// Five equal balls in a row on strings between them, the last of which flies off at 1 m/s.
System row_of_balls() {
  System system;
  system.gravity = {};
  system.bodies.resize(5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double x = static_cast<double>(i);
    system.initial.bodies.push_back({{x, 0.0}, 0.0, {i == 4 ? 1.0 : 0.0, 0.0}, 0.0});
    if (i > 0) {
      CableOfSystem cable;
      cable.from = {i - 1, {0.0, 0.0}, {}};
      cable.to = {i, {0.0, 0.0}, {}};
      cable.length = Function<1>::constant(1.0);
      system.cables.push_back(cable);
    }
  }
  system.duration = 1.0;
  return system;
}

TEST(RowOfFiveBalls, IsPulledAsTheLawSays) {
  const auto velocities = [](ImpactLaw law) {
    SolveOptions options;
    options.law = law;
    const SystemSolution solution = solve(row_of_balls(), options);
    std::vector<double> result;
    for (const State& body : solution.at(1e-9).bodies) {
      result.push_back(body.velocity.x());
    }
    return result;
  };
  // one after the other: the first ball alone flies off, as in Newton's cradle
  const std::vector<double> sequential = velocities(ImpactLaw::sequential);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(sequential[i], i == 0 ? 1.0 : 0.0, 1e-14);
  }
  // all at once: each velocity is reflected at that of the centre, 0.2
  for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::poisson}) {
    const std::vector<double> together = velocities(law);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_NEAR(together[i], i == 4 ? -0.6 : 0.4, 1e-14);
    }
  }
  EXPECT_THROW(static_cast<void>(velocities(ImpactLaw::energetic)), std::invalid_argument);
}

}  // namespace
}  // namespace tautline::test
