// Fixed steps: an elastic cable gives back what it takes, ten thousand times.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

constexpr int wanted_impacts = 10'000;

/// Of the energy at the start [-]: a random walk, of some roundings of the engine's numbers in each
/// step. What is measured is at most 12 sqrt(steps) roundings; a drift, all of one sign, would be
/// hundreds.
double energy_rounding(int steps) { return 24.0 * std::sqrt(steps) * Scene::rounding; }

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
Drift run(OneCable& setup, double zero_height, int most_steps = 500'000, int cables = 1) {
  const auto energy_now = [&setup, zero_height] {
    const BodyState body = setup.scene->body(0);
    return energy(body, Velocity::lags) - body.mass * gravity * zero_height;
  };
  const double start = energy_now();
  Drift drift{0.0, 0.0, -1e9, 0, 0};
  bool pulled = false;
  for (; drift.steps < most_steps && drift.impacts < wanted_impacts; ++drift.steps) {
    setup.scene->step();
    bool pulls = false;
    for (int index = 0; index < cables; ++index) {
      pulls = pulls || setup.scene->impulse(index) > 0.0;
    }
    drift.impacts += pulls && !pulled ? 1 : 0;
    pulled = pulls;
    const double change = energy_now() / start - 1.0;
    drift.gain = std::max(drift.gain, change);
    drift.loss = std::max(drift.loss, -change);
    if (drift.impacts > 0) {
      drift.highest = std::max(drift.highest, setup.scene->body(0).position.y());
    }
  }
  std::printf("%s: %d impacts in %d steps, energy at most %.2g above and %.2g below the start\n",
              Scene::engine.c_str(), drift.impacts, drift.steps, drift.gain, drift.loss);
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
  EXPECT_LE(drift.gain, energy_rounding(drift.steps));
  EXPECT_LE(drift.loss, energy_loss(drift.steps));
  EXPECT_LE(drift.highest, 3.0 + height * (1.0 + energy_rounding(drift.steps)));
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

/// A load on two elastic cables, side by side or to one hook.
struct Pair {
  std::string name;
  double mass;    // [kg]
  double moment;  // [kg m^2]
  double side;    // of the attachments [m]
  double depth;   // of the attachments [m]
  double hook;    // of the anchors, side and depth [-] of the attachments'
  double sway;    // velocity at the start [m/s]
};
void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.name; }

class ElasticPair : public testing::TestWithParam<Pair> {};

TEST_P(ElasticPair, GainsNothingInFiveMinutes) {
  const Pair& pair = GetParam();
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  setup.scene->add_body(pair.mass, pair.moment * Vec3::Ones(), Vec3(0, 4, 0),
                        Vec3(pair.sway, 0, 0));
  for (const double side : {-pair.side, pair.side}) {
    const double depth = side / pair.side * pair.depth;
    setup.scene->add_cable({{0, Vec3(side, 0.2, depth)},
                            {-1, Vec3(pair.hook * side, 5.2, pair.hook * depth)},
                            cable_length,
                            1.0});
  }
  const int minutes = 5;
  const Drift drift = run(setup, 3.0, minutes * 3600, 2);
  EXPECT_GT(drift.impacts, 100);
  EXPECT_LE(drift.gain, energy_rounding(drift.steps));
}

INSTANTIATE_TEST_SUITE_P(Cables, ElasticPair,
                         testing::Values(Pair{"parallel", 2.0, 0.05, 0.1, 0.0, 1.0, 0.0},
                                         Pair{"swaying", 2.0, 0.05, 0.1, 0.0, 1.0, 0.05},
                                         Pair{"wide", 2.0, 0.05, 0.2, 0.0, 1.0, 0.0},
                                         Pair{"crane", 10.0, 0.97, 0.1, 0.05, 0.0, 0.3},
                                         Pair{"close", 10.0, 0.97, 0.05, 0.025, 1.0, 0.0}),
                         [](const auto& instance) { return instance.param.name; });

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
