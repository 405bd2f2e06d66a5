// Fixed steps: a load hangs still, falls asleep, and swings without being stretched or driven.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

/// ODE's CFM of 1e-10 lets a cable under 20 N give by 2e-9 m/s, five steps of which ERP leaves [m].
constexpr double cfm_sag = 1e-9;

/// A load that hangs by its middle, `above` [m] over where its cable is taut.
OneCable hanging(double restitution, double above) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3 + above, 0), Vec3::Zero());
  setup.cable = {{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, restitution};
  setup.scene->add_cable(setup.cable);
  setup.scene->add_scenery();
  return setup;
}

TEST(HangingLoad, ComesToRestAtTheEndOfItsCable) {
  for (const double restitution : {0.0, 0.2, 0.5, 0.9}) {
    OneCable setup = hanging(restitution, 0.3);
    double deepest = 0.0;
    double fastest = 0.0;
    for (int steps = 0; steps < 900; ++steps) {
      const Step step = take_step(setup);
      deepest = std::max(deepest, -step.gap);
      fastest = std::max(fastest, -step.rate_before);
    }
    // what a step at the fastest takes it beyond its end, and no more
    EXPECT_LE(deepest, fastest * Scene::step_length * 1.001) << "e " << restitution;
    const double still = 1e4 * Scene::rounding;  // [m/s], [m]: rounding of 3 m, in 1/60 s
    const double sag = still + cfm_sag;
    double sway = 0.0;
    for (int steps = 0; steps < 300; ++steps) {
      const Step step = take_step(setup);
      sway = std::max(sway, std::abs(step.rate_after));
      EXPECT_NEAR(step.gap, 0.0, sag) << "e " << restitution;
      EXPECT_NEAR(step.impulse / Scene::step_length, load_mass * gravity, 1e-3)
          << "e " << restitution;
      EXPECT_TRUE(setup.scene->taut(0));
    }
    EXPECT_LE(sway, still) << "e " << restitution;
  }
}

TEST(HangingLoad, StaysWhereItHangsFromTheStart) {
  for (const double restitution : {0.5, 1.0}) {
    OneCable setup = hanging(restitution, 0.0);
    for (int steps = 0; steps < 600; ++steps) {
      const Step step = take_step(setup);
      EXPECT_NEAR(step.gap, 0.0, 1e4 * Scene::rounding + cfm_sag);
      EXPECT_GT(step.impulse, 0.0);
    }
  }
}

TEST(HangingLoad, FallsAsleep) {
  OneCable setup = hanging(0.5, 0.3);
  setup.scene->let_sleep();
  for (int steps = 0; steps < 600 && !setup.scene->sleeps(0); ++steps) {
    setup.scene->step();
  }
  EXPECT_TRUE(setup.scene->sleeps(0));
  EXPECT_TRUE(setup.scene->taut(0));
  EXPECT_NEAR(setup.scene->reported_gap(0), 0.0, 1e-3);
}

TEST(HangingLoad, IsTakenOutOfAnOverstretch) {
  OneCable setup = hanging(0.5, -0.05);
  double gap = -0.05;
  for (int steps = 0; steps < 60; ++steps) {
    const Step step = take_step(setup);
    EXPECT_GE(step.gap, gap - 1e-6);
    gap = step.gap;
  }
  EXPECT_NEAR(gap, 0.0, 1e-5);  // 0.8^60 of it, and float's rounding
}

TEST(ElasticLoad, DoesNotFallAsleepWhileItBounces) {
  OneCable setup = hanging(1.0, 0.01);
  setup.scene->let_sleep();
  double highest = 0.0;
  for (int steps = 0; steps < 1200; ++steps) {
    setup.scene->step();
    highest = steps < 1080 ? 0.0 : std::max(highest, setup.scene->reported_gap(0));
  }
  // of the last 2 s: it still rises to where it was dropped, a step's fall aside
  EXPECT_GT(highest, 0.9 * 0.01);
}

TEST(SwingingLoad, IsNeitherStretchedNorDriven) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  const double angle = 0.6;  // [rad]
  const Vec3 anchor(0, 5.2, 0);
  const Vec3 down(std::sin(angle), -std::cos(angle), 0);
  setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), anchor + cable_length * down,
                        Vec3::Zero());
  setup.cable = {{0, Vec3::Zero()}, {-1, anchor}, cable_length, 0.5};
  setup.scene->add_cable(setup.cable);
  setup.scene->add_scenery();
  const double start = energy(setup.scene->body(0), Velocity::lags);
  const double speed = std::sqrt(2.0 * gravity * cable_length * (1.0 - std::cos(angle)));
  // per step the tangent leaves the circle by (v dt)^2 / 2 L, and 0.2 of what there is comes back
  const double stretch = std::pow(speed * Scene::step_length, 2) / (2.0 * cable_length) / 0.2;
  for (int steps = 0; steps < 3600; ++steps) {
    const Step step = take_step(setup);
    EXPECT_GE(step.gap, -1.1 * stretch);
    EXPECT_GT(step.impulse, 0.0);
    // half of gravity's part of a step is what a resting load seems to have too much
    const double allowed =
        load_mass * std::pow(gravity * Scene::step_length, 2) + load_mass * gravity * stretch;
    EXPECT_LE(energy(setup.scene->body(0), Velocity::lags), start + allowed);
  }
}

}  // namespace
}  // namespace tautline::test
