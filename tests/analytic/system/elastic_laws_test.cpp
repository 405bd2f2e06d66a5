#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "support.hpp"
#include "system/elastic_systems.hpp"
#include "system/extrapolation.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"
#include "tautline/system_ledger.hpp"

// Elastic cables whose force bends at corners, or depends on the strain.

namespace tautline::test {
namespace {

/// A law with these corners.
Elasticity with_corners(Elasticity law, std::vector<Corner> corners) {
  law.corners = std::move(corners);
  return law;
}

/// A law of strain with this EA [N] and damping [N s/m].
Elasticity of_strain(double stiffness, double damping) {
  Elasticity law = with_damping(stiffness, damping);
  law.of_strain = true;
  return law;
}

TEST(BentForce, IsTheIntegralOfItsSlopeAndTheRateOfItsEnergy) {
  const Elasticity bent = with_corners(with_damping(100.0, 0.0), {{0.5, 400.0}, {0.75, 50.0}});
  EXPECT_EQ(spring_force(bent, 0.5, 2.0), 50.0);
  EXPECT_EQ(spring_force(bent, 0.625, 2.0), 100.0);
  EXPECT_EQ(spring_force(bent, 1.75, 2.0), 200.0);
  EXPECT_EQ(spring_stiffness(bent, 0.5, 2.0), 100.0);
  EXPECT_EQ(spring_stiffness(bent, 0.625, 2.0), 400.0);
  EXPECT_EQ(spring_stiffness(bent, 1.75, 2.0), 50.0);
  // triangles and trapezoids under the force
  EXPECT_EQ(spring_energy(bent, 0.5, 2.0), 12.5);
  EXPECT_EQ(spring_energy(bent, 0.75, 2.0), 12.5 + 0.25 * 100.0);
  EXPECT_EQ(spring_energy(bent, 1.75, 2.0), 12.5 + 0.25 * 100.0 + 175.0);
  Elasticity strained = bent;
  strained.of_strain = true;
  for (const double strain : {0.25, 0.5, 0.625, 1.75}) {
    EXPECT_EQ(spring_force(strained, 2.0 * strain, 2.0), spring_force(bent, strain, 2.0));
    EXPECT_EQ(spring_stiffness(strained, 2.0 * strain, 2.0),
              spring_stiffness(bent, strain, 2.0) / 2.0);
    EXPECT_EQ(spring_energy(strained, 2.0 * strain, 2.0), 2.0 * spring_energy(bent, strain, 2.0));
  }
}

TEST(BentForce, KeepsToTheClosedFormOfOneContact) {
  constexpr double k = 100.0;
  constexpr double at = 0.05;
  constexpr double speed = 1.0;
  for (const double beyond : {25.0, 400.0, 1e4}) {
    const Elasticity law = with_corners(with_damping(k, 0.0), {{at, beyond}});
    const auto found = elastic_contacts(solve(drop<double>(law, 0.0, speed, 0.25)));
    ASSERT_EQ(found.size(), 1U);
    ASSERT_TRUE(found[0].exit);
    // a part of an oscillation up to the corner, and one about another middle beyond it
    const double slow = std::sqrt(k);
    const double fast = std::sqrt(beyond);
    const double up_to = std::asin(at * slow / speed) / slow;
    const double left = std::sqrt(speed * speed - k * at * at);
    const double offset = k * at / beyond;
    const double amplitude = std::hypot(offset, left / fast);
    const double lasts = 2.0 * up_to + 2.0 * std::atan2(left, offset * fast) / fast;
    const double most =
        std::max({std::abs((*found[0].exit - found[0].entry) / lasts - 1.0),
                  std::abs(found[0].exit_speed / speed - 1.0),
                  std::abs(found[0].peak / (beyond * amplitude) - 1.0),
                  std::abs(found[0].greatest_stretch / (amplitude - offset + at) - 1.0),
                  std::abs(found[0].impulse / (2.0 * speed) - 1.0),
                  std::abs(found[0].peak_time / (found[0].entry + lasts / 2.0) - 1.0)});
    // the corner is known to a rounding of the length, a time beyond it to that over the speed
    expect_within("contact with a corner, then " + std::to_string(beyond) + " N/m", most, 2e-13);
  }
}

TEST(BentForce, WithTheSameSlopeIsStraight) {
  for (const double ratio : {0.0, 0.2}) {
    Elasticity law = with_ratio(1e3, ratio);
    const System straight = drop<double>(law, 9.81, 1.0, 0.1);
    law = with_corners(law, {{0.01, 1e3}, {0.02, 1e3}});
    const auto expected = elastic_contacts(solve(straight));
    const auto found = elastic_contacts(solve(drop<double>(law, 9.81, 1.0, 0.1)));
    ASSERT_EQ(found.size(), expected.size());
    double most = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      most = std::max({most, std::abs(found[i].entry - expected[i].entry),
                       std::abs(found[i].peak - expected[i].peak) / expected[i].peak,
                       std::abs(found[i].greatest_stretch - expected[i].greatest_stretch)});
    }
    expect_within("ratio " + std::to_string(ratio), most, 1e-12);
  }
}

TEST(BentForce, MayOnlyJustReachItsCorner) {
  // undamped, its greatest stretch is v / w = 0.1 m
  for (const double over : {-1e-9, -1e-15, 0.0, 1e-15, 1e-12, 1e-9}) {
    const Elasticity law = with_corners(with_damping(100.0, 0.0), {{0.1 - over, 400.0}});
    const auto solution = solve(drop<double>(law, 0.0, 1.0, 0.25));
    ASSERT_EQ(solution.ending(), Ending::reached_duration) << over;
    const auto found = elastic_contacts(solution);
    ASSERT_EQ(found.size(), 1U) << over;
    EXPECT_NEAR(found[0].greatest_stretch, 0.1, 1e-9) << over;
    EXPECT_NEAR(found[0].exit_speed, 1.0, 1e-13) << over;
  }
}

TEST(BentForce, MayStartAtOrBeyondACorner) {
  for (const double slack : {-0.125, -0.25}) {  // at the corner, and beyond it
    const Elasticity law = with_corners(with_damping(100.0, 0.0), {{0.125, 300.0}});
    System system = drop<double>(law, 0.0, 0.0, slack);
    system.duration = 0.5;  // it does not get to the other side of its anchor
    const auto found = elastic_contacts(solve(system));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].exit_speed, std::sqrt(2.0 * spring_energy(law, -slack, 1.0)), 1e-13);
    EXPECT_NEAR(found[0].peak, spring_force(law, -slack, 1.0), 1e-12);
  }
}

TEST(StrainedCable, OfOneLengthIsOneOfStretch) {
  System system = breakwater_system<double>(1.0);
  system.duration = 2.0;
  const double length = system.cables[0].length.at(0.0)[0];
  const auto expected = elastic_contacts(solve(elastic(system, with_damping(1e3, 3.0))));
  const auto found = elastic_contacts(solve(elastic(system, of_strain(1e3 * length, 3.0))));
  ASSERT_EQ(found.size(), expected.size());
  double most = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    most = std::max({most, std::abs(found[i].entry - expected[i].entry),
                     std::abs(found[i].peak / expected[i].peak - 1.0)});
  }
  expect_within("contacts", most, 1e-10);
}

/// A mass of 1 kg under a winch that shortens its cable of EA = 300 N by `speed` [m/s].
System on_a_winch(double speed) {
  System system = drop<double>(of_strain(300.0, 2.0), 9.81, 0.0, -0.05);
  system.cables[0].length = Function<1>::linear(
      {0.0, 0.8}, {Function<1>::Value(1.0), Function<1>::Value(1.0 - 0.8 * speed)});
  system.duration = 0.7;
  return system;
}

TEST(StrainedCable, OnAWinchAgreesWithAnotherMethod) {
  constexpr double speed = 0.75;
  const auto solution = solve(on_a_winch(speed));
  const auto found = elastic_contacts(solution);
  ASSERT_GE(found.size(), 2U);
  // depth, its rate and the time, while the cable pulls, or not
  const auto pull = [](const Numbers& y) {
    const double length = 1.0 - speed * y[2];
    return 300.0 * (y[0] - length) / length + 2.0 * (y[1] + speed);
  };
  const auto to = [&](Numbers y, double time, bool pulls) {
    constexpr int steps = 100;
    const double step = (time - y[2]) / steps;
    for (int i = 0; i < steps; ++i) {
      y = extrapolated(
          [&](const Numbers& now) {
            Numbers rates(3);
            rates << now[1], 9.81 - (pulls ? pull(now) : 0.0), 1.0;
            return rates;
          },
          y, step);
    }
    return y;
  };
  Numbers y(3);
  y << 1.05, 0.0, 0.0;
  y = to(y, *found[0].exit, true);
  // its tension at the exit, and the gap at the next entry, are zero
  expect_within("exit", std::abs(pull(y)), 1e-11);
  const State at_exit = solution.at(*found[0].exit).bodies[0];
  expect_within("place at the exit", std::abs(at_exit.position.y() + y[0]), 1e-13);
  expect_within("velocity at the exit", std::abs(at_exit.velocity.y() + y[1]), 1e-12);
  y = to(y, found[1].entry, false);
  const double over = y[0] - (1.0 - speed * y[2]);
  expect_within("entry", std::min(std::abs(over), std::abs(pull(y))), 1e-11);
}

/// A law with this cut.
Elasticity with_cut(Elasticity law, ElasticCut cut) {
  law.cut = cut;
  return law;
}

TEST(CutOfStretch, HasTheRestitutionOfADampedOscillation) {
  for (const double ratio : {0.0, 0.1, 0.5, 0.9}) {
    const Elasticity law = with_cut(with_ratio(1e4, ratio), ElasticCut::stretch);
    const auto found = elastic_contacts(solve(drop<double>(law, 0.0, 1.0, 0.25)));
    ASSERT_EQ(found.size(), 1U) << ratio;
    ASSERT_TRUE(found[0].exit) << ratio;
    const double root = std::sqrt((1.0 - ratio) * (1.0 + ratio));
    const double kept = std::exp(-std::numbers::pi * ratio / root);
    const double lasts = std::numbers::pi / (100.0 * root);
    // an exit is known to a rounding of the length over its speed
    const double rounding = 4.0 * epsilon<double>() / (kept * lasts);
    // s' = 0 at acos(ratio) / root
    const double most_stretch = std::exp(-ratio * std::acos(ratio) / root) / 100.0;
    expect_within("ratio " + std::to_string(ratio),
                  std::max({std::abs(found[0].exit_speed - kept),
                            std::abs((*found[0].exit - found[0].entry) / lasts - 1.0),
                            std::abs(found[0].greatest_stretch / most_stretch - 1.0),
                            std::abs(found[0].impulse - 1.0 - kept)}),
                  2e-13 + rounding);
  }
}

TEST(CutOfNothing, BrakesASlackCableToo) {
  constexpr double damping = 2.0;  // [N s/m], and a mass of 1 kg
  const Elasticity law = with_cut(with_damping(1e4, damping), ElasticCut::never);
  System system = drop<double>(law, 0.0, 1.0, 0.25);
  const auto solution = solve(system);
  const auto found = elastic_contacts(solution);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_TRUE(found[0].exit);
  // without a load the speed falls by c/m for each metre
  const double entry = 1.0 - damping * 0.25;
  const double ratio = damping / 200.0;
  const double kept = std::exp(-std::numbers::pi * ratio / std::sqrt(1.0 - ratio * ratio));
  const double left = solution.end_time() - *found[0].exit;
  const double later = entry * kept * std::exp(-damping * left);
  const double height = (entry * kept - later) / damping;
  const State end = solution.at(solution.end_time()).bodies[0];
  expect_within(
      "contact and flight",
      std::max({std::abs(found[0].entry_speed - entry),
                std::abs(found[0].entry + std::log(entry) / damping),
                std::abs(found[0].exit_speed - entry * kept), std::abs(end.velocity.y() - later),
                std::abs(end.position.y() + 1.0 - height)}),
      2e-13);
  EXPECT_NEAR(solution.tensions(0.0)[0], damping, 1e-14);
  EXPECT_NEAR(solution.tensions(solution.end_time())[0], -damping * later, 1e-13);
  const SystemLedger ledger = energy_ledger(system, solution);
  EXPECT_NEAR(ledger.dissipated, 0.5 - later * later / 2.0, 1e-14);
}

TEST(CutOfNothing, AccountsForAPassByItsAnchor) {
  System system =
      drop<double>(with_cut(with_damping(100.0, 0.1), ElasticCut::never), 10.0, 0.0, 1.8);
  for (const double off : {1e-3, 1e-6, 1e-9}) {
    system.initial.bodies[0].position.x() = off;
    const SystemLedger ledger = energy_ledger(system, solve(system));
    EXPECT_GT(ledger.dissipated, 0.1);
    expect_within("passes at " + std::to_string(off) + " m", std::abs(ledger.residual), 1e-12);
  }
}

/// All systems that are compared with another method, or whose energy is looked at.
std::vector<std::pair<std::string, System>> systems_of_laws() {
  const System breakwater = breakwater_system<double>(1.0);
  const Elasticity soft = with_damping(1e3, 3.0);
  const std::vector<Corner> hard = {{2e-3, 4e3}, {1e-2, 500.0}, {2e-2, 1e4}};
  Elasticity strained = with_corners(of_strain(1.5e3, 3.0), {{1e-3, 3e3}, {1e-2, 1e3}});
  Elasticity cubic = of_strain(1.5e3, 3.0);
  cubic.stiffness = {1.5e3, 2e3, 1e5};
  std::vector<std::pair<std::string, System>> result = {
      {"corners", elastic(breakwater, with_corners(soft, hard))},
      {"corners without damping", elastic(breakwater, with_corners(with_damping(1e3, 0.0), hard))},
      {"corners of strain", elastic(breakwater, strained)},
      {"cubic in the strain", elastic(breakwater, cubic)},
      {"two bodies", elastic(in_series<double>(), with_corners(soft, hard))},
      {"cut of stretch", elastic(breakwater, with_cut(soft, ElasticCut::stretch))},
      {"cut of nothing", elastic(breakwater, with_cut(soft, ElasticCut::never))},
      {"cut of nothing, corners of strain",
       elastic(breakwater, with_cut(strained, ElasticCut::never))}};
  for (auto& [name, system] : result) {
    system.duration = 2.0;
  }
  return result;
}

TEST(LawsOfElasticity, AgreeWithAnotherMethod) {
  for (const auto& [name, system] : systems_of_laws()) {
    const Apart apart = apart_from_extrapolation(system, system.duration, 1e-3);
    EXPECT_GE(apart.switchings, 10U) << name;
    expect_within(name + ", switches", apart.time, 2e-11);
    expect_within(name + ", state", apart.state, 4e-10);
  }
}

TEST(LawsOfElasticity, AccountForEveryJoule) {
  auto systems = systems_of_laws();
  const Elasticity strained = with_corners(of_strain(1.5e3, 3.0), {{1e-3, 3e3}, {1e-2, 1e3}});
  Elasticity cubic = of_strain(1.5e3, 3.0);
  cubic.stiffness = {1.5e3, 2e3, 1e5};
  for (const ElasticCut cut : {ElasticCut::force, ElasticCut::stretch, ElasticCut::never}) {
    systems.emplace_back("winch", elastic(winch<double>(), with_cut(strained, cut)));
  }
  systems.emplace_back("waves", elastic(waves<double>(), strained));
  systems.emplace_back("moved anchors", elastic(shaken<double>(), cubic));
  systems.emplace_back("winch, cubic", elastic(winch<double>(), cubic));
  systems.emplace_back("mass on a winch", on_a_winch(0.75));
  System cut = elastic(winch<double>(), strained);
  cut.cables[0].cut_at = 1.3;
  systems.emplace_back("cut on a winch", cut);
  for (const auto& [name, system] : systems) {
    EXPECT_TRUE(problems(system).empty()) << name << ": " << problems(system).front();
    const SystemLedger ledger = energy_ledger(system, solve(system));
    EXPECT_GE(ledger.dissipated, -1e-14 * ledger.range) << name;
    // each arc knows a stretch to a rounding of the length, and its energy to that times the
    // tension
    expect_within(name, std::abs(ledger.residual) / ledger.range, 5e-14);
  }
}

TEST(LawsOfElasticity, SwitchOfMirroredCablesIsOneEvent) {
  for (const double tilt : {0.0, 0.3, 1.1}) {  // of the line that one mirrors the other at
    const Eigen::Rotation2Dd turned(tilt);
    System system = drop<double>(with_damping(1e3, 3.0), 9.81, 0.7, 0.1);
    system.gravity = Function<2>::constant(turned * Vec2(0.0, -9.81));
    system.initial.bodies[0].position = turned * system.initial.bodies[0].position;
    system.initial.bodies[0].velocity = turned * system.initial.bodies[0].velocity;
    system.cables[0].length = Function<1>::constant(1.3);
    system.cables.push_back(system.cables[0]);
    system.cables[0].to.at = turned * Vec2(-0.6, 0.2);
    system.cables[1].to.at = turned * Vec2(0.6, 0.2);
    const auto solution = solve(system);
    ASSERT_GE(solution.events().size(), 4U) << tilt;
    for (const auto& event : solution.events()) {
      EXPECT_EQ(event.cables.size(), 2U) << tilt << ", at " << event.time;
    }
  }
}

/// A mass at rest, whose anchor leaves it at `speed` [m/s] without gravity.
System towed(const Elasticity& law, double speed) {
  System system = drop<double>(law, 0.0, 0.0, 0.1);
  system.duration = 2.0;
  system.cables[0].to.motion =
      Function<2>::linear({0.0, 2.0}, {Vec2(0.0, 0.0), Vec2(0.0, 2.0 * speed)});
  return system;
}

TEST(FallingForce, IsRefusedWhereSomethingDrivesTheCable) {
  Elasticity law = with_damping(10.0, 0.0);
  law.stiffness = {10.0, -10.0};
  const std::string words =
      "m, which a motion that is driven over time may reach; stiffness must give";
  const auto expect_words = [&](const System& system, const std::string& why) {
    const auto found = problems(system);
    ASSERT_EQ(found.size(), 1U) << why;
    EXPECT_NE(found[0].find(words), std::string::npos) << found[0];
  };
  const System still = drop<double>(law, 0.0, 0.0, 0.1);
  EXPECT_TRUE(problems(still).empty());
  expect_words(towed(law, 2.0), "an end moves");
  System system = still;
  system.bodies[0].force.waves = {{Vec2(1.0, 0.0), 3.0, std::numbers::pi / 2.0}};  // none at first
  expect_words(system, "a load varies");
  system = still;
  system.cables[0].length =
      Function<1>::linear({0.0, 0.5}, {Function<1>::Value(1.0), Function<1>::Value(0.5)});
  expect_words(system, "a length varies");
  system = still;
  system.cables[0].from_time = 0.5;
  expect_words(system, "it may be hooked up at any stretch");
  // another body moves by itself
  system = still;
  system.bodies.push_back({});
  system.bodies[1].name = "other";
  system.bodies[1].force.waves = {{Vec2(1.0, 0.0), 3.0, std::numbers::pi / 2.0}};
  system.initial.bodies.push_back({});
  EXPECT_TRUE(problems(system).empty()) << problems(system).front();
  law.stiffness = {10.0, -10.0, 10.0};  // rises everywhere
  EXPECT_TRUE(problems(towed(law, 2.0)).empty());
}

TEST(FallingForce, LeavesAnUndampedCableLooseWhereItEnds) {
  constexpr double speed = 20.0;  // [m/s], of the anchor, which stops after 2 s
  Elasticity law = with_damping(10.0, 0.0);
  law.stiffness = {10.0, -1.0};  // no force from a stretch of 10 m on
  System system = towed(law, speed);
  system.duration = 3.2;
  const auto solution = solve(system);
  ASSERT_EQ(solution.ending(), Ending::reached_duration);
  const auto found = elastic_contacts(solution);
  ASSERT_EQ(found.size(), 2U);
  const double left = std::sqrt(speed * speed - 2.0 * spring_energy(law, 10.0, 1.0));
  EXPECT_NEAR(found[0].exit_speed, -left, 1e-12);
  EXPECT_NEAR(gap(system.cables[0], solution.at(*found[0].exit)), -10.0, 1e-12);
  EXPECT_NEAR(gap(system.cables[0], solution.at(found[1].entry)), -10.0, 1e-12);
  const SystemLedger ledger = energy_ledger(system, solution);
  expect_within("residual", std::abs(ledger.residual) / ledger.range, 1e-14);
}

TEST(LawsOfElasticity, HaveOneSentenceForEachProblem) {
  const auto expect_words = [](const Elasticity& law, const std::string& words) {
    const auto found = problems(drop<double>(law, 9.81, 1.0, 0.1));
    ASSERT_EQ(found.size(), 1U) << words;
    EXPECT_NE(found[0].find(words), std::string::npos) << found[0];
  };
  const Elasticity soft = with_damping(1e3, 3.0);
  EXPECT_TRUE(problems(drop<double>(with_corners(soft, {{0.1, 10.0}}), 9.81, 1.0, 0.1)).empty());
  expect_words(with_corners(soft, {{0.0, 2e3}}), "corners[0]: stretch 0 must be a finite number");
  expect_words(with_corners(soft, {{0.1, -2e3}}),
               "corners[0]: stiffness -2000 must be a finite number above 0 [N/m]");
  expect_words(with_corners(soft, {{0.2, 2e3}, {0.1, 3e3}}), "corners[1]: stretch 0.1");
  Elasticity cubic = with_corners(soft, {{0.1, 2e3}});
  cubic.stiffness = {1e3, 0.0, 1e3};
  expect_words(cubic, "corners go on from one stiffness, and 3 coefficients are given");
  expect_words(with_corners(soft, {{0.1, 1e15}}), "or lower its stiffness of corners[0] to ");
  Elasticity pushing = with_ratio(1e15, 0.3);
  pushing.cut = ElasticCut::stretch;  // its contacts have another restitution than (E6)
  expect_words(pushing, "s: make it inextensible, or lower its stiffness to ");
  expect_words(with_ratio(1e15, 0.3), "make it inextensible with restitution 0.45097545");
  // a contact that stays below the corner has it
  expect_words(with_corners(with_ratio(1e10, 0.3), {{0.1, 1e15}}),
               "make it inextensible with restitution 0.45097545");
  expect_words(of_strain(-5.0, 0.0), "EA -5 must be a finite number above 0 [N]");
  expect_words(of_strain(1e15, 0.0), "or lower its EA to ");
  Elasticity falls = of_strain(1e2, 0.0);
  falls.stiffness = {1e2, -1e2};
  expect_words(falls, "EA must give a force that rises");
  expect_words(with_corners(of_strain(1e3, 0.0), {{0.1, 0.0}}), "corners[0]: EA 0 must be");
}

}  // namespace
}  // namespace tautline::test
