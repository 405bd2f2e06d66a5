// Fixed steps: an elastic cable gives back what it takes, ten thousand times.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "measure.hpp"

namespace tautline::test {
namespace {

constexpr int wanted_impacts = 10'000;

/// Of the energy at the start [-]: a rounding of the engine's numbers per step, all of one sign.
double energy_rounding(int steps) { return steps * Scene::rounding; }

/// ODE's CFM of 1e-10 slows a rebound by 3.6e-7 m/s per N s: 1e-7 of the energy in an impact [-].
double energy_loss(int steps) { return 1e-7 * wanted_impacts + energy_rounding(steps); }

/// Runs until the impacts are done and says how far energy went up and down, of that at the start.
struct Drift {
  double gain;
  double loss;
  double highest;  // [m] of the centre, after the first impact
  int impacts;
  int steps;
};
Drift run(OneCable& setup, double zero_height) {
  const auto energy_now = [&setup, zero_height] {
    const BodyState body = setup.scene->body(0);
    return energy(body, Velocity::lags) - body.mass * gravity * zero_height;
  };
  const double start = energy_now();
  Drift drift{0.0, 0.0, -1e9, 0, 0};
  bool pulled = false;
  const int most_steps = 500'000;
  for (; drift.steps < most_steps && drift.impacts < wanted_impacts; ++drift.steps) {
    setup.scene->step();
    const bool pulls = setup.scene->impulse(0) > 0.0;
    drift.impacts += pulls && !pulled ? 1 : 0;
    pulled = pulls;
    const double change = energy_now() / start - 1.0;
    drift.gain = std::max(drift.gain, change);
    drift.loss = std::max(drift.loss, -change);
    if (drift.impacts > 0) {
      drift.highest = std::max(drift.highest, setup.scene->body(0).position.y());
    }
  }
  return drift;
}

TEST(ElasticCable, BouncesALoadTenThousandTimesToTheSameHeight) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  const double height = 0.05;
  setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3 + height, 0),
                        Vec3::Zero());
  setup.cable = {{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, 1.0};
  setup.scene->add_cable(setup.cable);
  const Drift drift = run(setup, 3.0);
  EXPECT_EQ(drift.impacts, wanted_impacts);
  // positions of 3 m are rounded, in a height of 0.05 m
  const double coarser = 3.0 / height;
  EXPECT_LE(drift.gain, coarser * energy_rounding(drift.steps));
  EXPECT_LE(drift.loss, coarser * energy_loss(drift.steps));
  EXPECT_LE(drift.highest, 3.0 + height * (1.0 + coarser * energy_rounding(drift.steps)));
}

TEST(ElasticCable, GainsNothingInTenThousandSpatialImpacts) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3.5, 0), Vec3(1, 0, 0.3));
  setup.cable = {{0, Vec3(0.2, 0.2, 0.1)}, {-1, Vec3(0, 5.2, 0)}, cable_length, 1.0};
  setup.scene->add_cable(setup.cable);
  setup.scene->add_scenery();
  const Drift drift = run(setup, 3.0);
  EXPECT_EQ(drift.impacts, wanted_impacts);
  EXPECT_LE(drift.gain, energy_rounding(drift.steps));
  EXPECT_LE(drift.loss, energy_loss(drift.steps));
}

TEST(CableByEnergy, RaisesALoadToTheSquareOfRestitution) {
  for (const double restitution : {0.9, 0.7, 0.5}) {
    OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
    setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 4, 0), Vec3::Zero());
    setup.cable = {{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, restitution};
    setup.scene->rebound_by_energy(setup.scene->add_cable(setup.cable));
    const double weight = load_mass * gravity;
    double before = energy(setup.scene->body(0), Velocity::lags) - 3.0 * weight;
    int impacts = 0;
    bool pulled = false;
    while (impacts < 4) {
      setup.scene->step();
      const bool pulls = setup.scene->impulse(0) > 0.0;
      if (pulls && !pulled) {
        ++impacts;
        const double after = energy(setup.scene->body(0), Velocity::lags) - 3.0 * weight;
        EXPECT_NEAR(std::sqrt(after / before), restitution, 1e-3) << "impact " << impacts;
        before = after;
      }
      pulled = pulls;
    }
  }
}

}  // namespace
}  // namespace tautline::test
