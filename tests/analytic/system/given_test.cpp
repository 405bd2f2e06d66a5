#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support.hpp"
#include "system/systems.hpp"
#include "tautline/solve.hpp"
#include "tautline/system_geometry.hpp"

// Things given over time: moving anchors, lengths, forces, drag, cuts.

namespace tautline::test {
namespace {

using SystemSolution = BasicSolution<System>;

/// The largest overstretch of a cable that acts, at many times, in parts of its length.
double overstretch(const System& system, const SystemSolution& solution) {
  constexpr int samples = 4000;
  double most = 0.0;
  for (int k = 0; k <= samples; ++k) {
    const double time = std::min(solution.end_time(), solution.end_time() * k / samples);
    const SystemState state = solution.at(time);
    for (const CableOfSystem& cable : system.cables) {
      if (cable.acts_at(time)) {
        most = std::max(most, -gap(cable, state) / cable.length.at(time)[0]);
      }
    }
  }
  return most;
}

TEST(Bouncer, HitsEveryPeriodForSixtyPeriods) {
  const SystemSolution solution = solve(bouncer<double>(0.14));
  ASSERT_EQ(solution.events().size(), 60U);
  double late = 0.0;
  double off = 0.0;
  for (std::size_t i = 0; i < 60; ++i) {
    late = std::max(late, std::abs(solution.events()[i].time - 2.0 * static_cast<double>(i + 1)));
    off = std::max(off, std::abs(solution.events()[i].impulses[0] - 2.0));
  }
  expect_within("impact time [s]", late, 1e-12);
  expect_within("impulse [N s]", off, 1e-13);
}

/// By how much a push of 1e-6 has grown in an impact, over the eighth to the twelfth.
double growth(double a) {
  constexpr double push = 1e-6;
  const SystemSolution solution = solve(bouncer<double>(a, push));
  const auto away = [&](std::size_t i) {
    const double speed = solution.events()[i].after.bodies[0].velocity.y();
    return std::abs(speed - 1.0);
  };
  return std::pow(away(12) / away(4), 1.0 / 8.0);
}

TEST(Bouncer, IsStableUpToItsBorder) {
  // a w^2 sin(phase) < 2 g (1 + e^2) / (1 + e)^2, where a w cos(phase) = 1/3
  EXPECT_LT(growth(0.15), 1.0);
  EXPECT_GT(growth(0.16), 1.0);
}

TEST(Winch, GoesSlackWhereItStopsAndNothingElseIsLeftOfItsSpeed) {
  const System system = winch<double>();
  const SystemSolution solution = solve(system);
  const auto& events = solution.events();
  const auto slack = std::find_if(events.begin(), events.end(),
                                  [](const auto& event) { return event.kind == EventKind::slack; });
  ASSERT_NE(slack, events.end());
  EXPECT_DOUBLE_EQ(slack->time, 1.4);
  // it rises as fast as the cable was drawn in, seen along the cable
  const double rate = gap_rate(system.cables[0], slack->after);
  expect_within("rate after the stop [m/s]", std::abs(rate + -0.5), 1e-13);
  expect_within("overstretch", overstretch(system, solution), 1e-12);
}

TEST(Plastic, ReleasesWhereTheMovingEndsLeaveNoTension) {
  const System system = plastic<double>();
  const SystemSolution solution = solve(system);
  const auto& events = solution.events();
  ASSERT_GE(events.size(), 6U);
  // both cables taut from 0.4588 to 4.2499, the next impact at 4.8986 (an independent integration)
  EXPECT_NEAR(events[2].time, 0.4588, 1e-4);
  EXPECT_EQ(events[4].kind, EventKind::slack);
  EXPECT_NEAR(events[4].time, 4.2499, 1e-4);
  EXPECT_NEAR(events[5].time, 4.8986, 1e-4);
  expect_within("overstretch", overstretch(system, solution), 1e-12);
}

TEST(Given, MotionsNeverOverstretchACable) {
  for (const System& system : {shaken<double>(), waves<double>(), pulley<double>(),
                               in_series<double>(), chain<double>(0.9)}) {
    expect_within("overstretch", overstretch(system, solve(system)), 1e-12);
  }
}

TEST(Cut, LetsTheBodyFlyFromItsInstantOn) {
  System system;
  system.bodies.resize(1);
  system.cables = {to_world<double>(0, {0.0, 0.0}, {0.0, 0.0}, 1.0, 0.5)};
  system.cables[0].cut_at = 1.5;
  system.initial.bodies = {{{1.0, 0.0}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 2.0;
  const SystemSolution solution = solve(system);
  ASSERT_EQ(solution.events().back().kind, EventKind::slack);
  EXPECT_EQ(solution.events().back().time, 1.5);
  const State before = solution.at(1.5).bodies[0];
  const State after = solution.at(2.0).bodies[0];
  const Vec2 flown = before.position + 0.5 * before.velocity + 0.125 * Vec2(0.0, -1.0);
  expect_within("place after the flight [m]", (after.position - flown).norm(), 1e-15);
}

TEST(HookUp, ActsFromItsInstantOn) {
  System system;
  system.bodies.resize(1);
  system.cables = {to_world<double>(0, {0.0, 0.0}, {0.0, 0.0}, 1.0, 0.0)};
  system.cables[0].from_time = 0.5;
  system.initial.bodies = {{{0.0, -0.5}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 3.0;
  const SystemSolution solution = solve(system);
  ASSERT_FALSE(solution.events().empty());
  // a fall by 0.5 takes a second
  expect_within("instant of the impact [s]", std::abs(solution.events()[0].time - 1.0), 1e-15);
}

TEST(HookUp, LetsABodyFallBeforeItsCableThroughARingActs) {
  System system;
  system.bodies.resize(1);
  system.cables = {to_world<double>(0, {0.0, 0.0}, {3.0, 0.0}, 4.0, 0.0)};
  system.cables[0].through = {{std::nullopt, {0.0, 0.0}, {}}};
  system.cables[0].from_time = 0.5;
  system.initial.bodies = {{{0.0, -0.5}, 0.0, {0.0, 0.0}, 0.0}};
  system.duration = 1.5;
  const SystemSolution solution = solve(system);
  ASSERT_FALSE(solution.events().empty());
  // 1 m below the ring, after a second
  expect_within("instant of the impact [s]", std::abs(solution.events()[0].time - 1.0), 1e-15);
}

TEST(Drag, SlowsASphereAsItsClosedFormSays) {
  System system;
  system.bodies.resize(1);
  system.bodies[0].drag = 0.8;
  system.bodies[0].inertia = 1.0;
  system.bodies[0].spin_drag = 0.3;
  system.gravity = {};
  system.initial.bodies = {{{0.0, 0.0}, 0.0, {2.0, 0.0}, 1.0}};
  system.duration = 5.0;
  const State end = solve(system).at(5.0).bodies[0];
  expect_within("velocity [m/s]", std::abs(end.velocity.x() - 2.0 * std::exp(-4.0)), 1e-15);
  expect_within("place [m]", std::abs(end.position.x() - 2.5 * (1.0 - std::exp(-4.0))), 1e-14);
  expect_within("spin [rad/s]", std::abs(end.spin - std::exp(-1.5)), 1e-15);
}

}  // namespace
}  // namespace tautline::test
