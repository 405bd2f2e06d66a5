// Cables that stretch: energy at any step, rest, what they tell, and what they are told.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "engines/cables/draw.hpp"
#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

constexpr double load_weight = load_mass * gravity;  // [N]

/// A load 2 m of cable below a point, fallen into it from `height` [m] above its end.
OneCable falling_load(double height, double stiffness, double ratio, double rate = 60.0) {
  OneCable setup{std::make_unique<Scene>(gravity, rate), {}, 1};
  setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3 + height, 0),
                        Vec3::Zero());
  setup.cable = {{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, 0.0};
  setup.cable.stiffness = {stiffness};
  setup.cable.damping_ratio = ratio;
  setup.scene->add_cable(setup.cable);
  return setup;
}

/// One to four spinning balls on cables to points and to each other, most of them elastic, with
/// stiffnesses k h^2 / m from 0.01 to a million. All begin slack.
struct RandomElasticWorld {
  Scene scene{gravity};
  double energy_range = 0.0;  // [J]

  explicit RandomElasticWorld(unsigned int seed) {
    Draw draw(seed);
    const int balls = draw.whole(1, 4);
    std::vector<double> masses;
    for (int ball = 0; ball < balls; ++ball) {
      masses.push_back(draw.scale(0.1, 10.0));
      const double moment = masses.back() * draw.between(0.01, 0.1);
      const Vec3 position = draw.within(1.0, false);
      const Vec3 velocity = draw.within(8.0, false);
      const Vec3 spin = draw.within(8.0, false);
      scene.add_body(masses.back(), moment * Vec3::Ones(), position, velocity);
      scene.set_velocity(ball, velocity, spin);
      energy_range += 0.5 * masses.back() * velocity.squaredNorm() +
                      0.5 * moment * spin.squaredNorm() + 4.0 * masses.back() * gravity;
    }
    const int cables = balls + draw.whole(0, 2);
    for (int cable = 0; cable < cables; ++cable) {
      add_cable(draw, cable < balls ? cable : draw.whole(0, balls - 1), masses);
    }
  }

  [[nodiscard]] double energy_now() const {
    double result = 0.0;
    for (int ball = 0; ball < scene.count(); ++ball) {
      result += energy(scene.body(ball), Velocity::lags);
    }
    return result;
  }

 private:
  void add_cable(Draw& draw, int ball, const std::vector<double>& masses) {
    CableData data{{ball, draw.within(0.2, false)}, {-1, draw.within(1.5, false)}, 1.0, 0.0};
    const int other = draw.whole(-1, static_cast<int>(masses.size()) - 1);
    if (other != ball && other >= 0) {
      data.second = {other, draw.within(0.2, false)};
    }
    data.length = line_of(data, bodies_of(scene, scene.count())).distance * draw.between(1.01, 2.0);
    data.restitution = draw.between(0.0, 1.0);
    const double stiffness = masses[static_cast<std::size_t>(ball)] * draw.scale(1e-2, 1e6) /
                             (Scene::step_length * Scene::step_length);
    const double ratio = draw.scale(1e-2, 10.0);
    const double kind = draw.between(0.0, 1.0);
    if (kind < 0.8) {
      data.stiffness = {stiffness};
      data.damping_ratio = kind < 0.4 ? ratio : 0.0;
    }
    if (kind < 0.2) {
      data.stiffness.push_back(5.0 * stiffness);
      data.stiffness.push_back(20.0 * stiffness);
    }
    scene.add_cable(data);
  }
};

TEST(StretchingCable, NeverGivesEnergyInRandomWorldsAtAbsurdSteps) {
  constexpr unsigned int worlds = 200;
  constexpr int steps = 600;
  // roundings of some thousand numbers, which have signs
  const double allowed = 1e3 * Scene::rounding;
  double most = 0.0;
  double pulls = 0.0;
  for (unsigned int seed = 1; seed <= worlds; ++seed) {
    RandomElasticWorld world(seed);
    const double start = world.energy_now();
    double highest = 0.0;
    for (int step = 0; step < steps; ++step) {
      world.scene.step();
      const double now = world.energy_now();
      ASSERT_TRUE(std::isfinite(now)) << "world " << seed;
      highest = std::max(highest, (now - start) / world.energy_range);
      ASSERT_GE(world.scene.impulse(0), 0.0) << "world " << seed;
      pulls += world.scene.impulse(0) > 0.0 ? 1.0 : 0.0;
    }
    EXPECT_LE(highest, allowed) << "world " << seed;
    most = std::max(most, highest);
  }
  std::printf("  %s: %u worlds, energy of the bodies up by %.2g of its range at most\n",
              Scene::engine.c_str(), worlds, most);
  EXPECT_GT(pulls, worlds * steps / 10.0);
}

TEST(StretchingCable, ComesToRestWhereItsLawSaysAtAnyStiffness) {
  const double unit = load_mass / (Scene::step_length * Scene::step_length);  // [N/m]
  for (const double part : {0.03, 1.0, 1e4}) {
    for (const double ratio : {0.0, 0.3}) {
      const OneCable setup = falling_load(0.1, part * unit, ratio);
      const double start = energy(setup.scene->body(0), Velocity::lags);
      for (int step = 0; step < 3600; ++step) {
        setup.scene->step();
        // a rounding of the height of some metres
        ASSERT_LE(energy(setup.scene->body(0), Velocity::lags),
                  start + 100.0 * Scene::rounding * load_weight)
            << "k h^2 / m of " << part;
      }
      // the rounding of a stretch, times the stiffness
      const double rounding =
          100.0 * Scene::rounding * (1.0 + part * unit * cable_length / load_weight);
      EXPECT_NEAR(setup.scene->taut_tension(0) / load_weight, 1.0, rounding) << part;
      EXPECT_NEAR(-setup.scene->reported_gap(0) * part * unit / load_weight, 1.0, rounding) << part;
    }
  }
}

TEST(StretchingCable, SharesALoadWithOthers) {
  Scene scene(gravity);
  scene.add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3, 0), Vec3::Zero());
  const double stiffness = 1e4;
  for (const double side : {-0.3, 0.3}) {
    for (const double depth : {-0.2, 0.2}) {
      CableData data{{0, Vec3(side, 0.2, depth)}, {-1, Vec3(side, 5.2, depth)}, cable_length, 0.0};
      data.stiffness = {stiffness};
      data.damping_ratio = 0.1;
      scene.add_cable(data);
    }
  }
  for (int step = 0; step < 3600; ++step) {
    scene.step();
  }
  // in float the rounding of a stretch is a thousandth of it
  const double rounding = 1e-9 + 1e4 * Scene::rounding;
  for (int cable = 0; cable < 4; ++cable) {
    EXPECT_NEAR(scene.taut_tension(cable) / load_weight, 0.25, rounding);
    EXPECT_NEAR(-scene.reported_gap(cable) * stiffness / load_weight, 0.25, rounding);
  }
}

TEST(StretchingCable, HangsInSeriesWithOneThatDoesNot) {
  constexpr double heavy = 1000.0;  // times the load's mass
  for (const bool upper_stretches : {false, true}) {
    Scene scene(gravity);
    const int load =
        scene.add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3, 0), Vec3::Zero());
    const int below = scene.add_body(heavy * load_mass, heavy * load_moment * Vec3::Ones(),
                                     Vec3(0, 1, 0), Vec3::Zero());
    std::vector<CableData> cables = {{{load, Vec3::Zero()}, {-1, Vec3(0, 5, 0)}, 2.0, 0.5},
                                     {{below, Vec3::Zero()}, {load, Vec3::Zero()}, 2.0, 0.5}};
    const std::size_t elastic = upper_stretches ? 0 : 1;
    cables[elastic].stiffness = {1e7};
    cables[elastic].damping_ratio = 0.1;
    for (const CableData& cable : cables) {
      scene.add_cable(cable);
    }
    for (int step = 0; step < 3600; ++step) {
      scene.step();
    }
    const double rounding = 1e-6 + 1e5 * Scene::rounding;
    EXPECT_NEAR(scene.taut_tension(0) / load_weight, 1.0 + heavy, rounding * heavy);
    EXPECT_NEAR(scene.taut_tension(1) / load_weight, heavy, rounding * heavy);
  }
}

TEST(StretchingCable, TellsTensionPeakAndImpulse) {
  constexpr double rate = 3840.0;
  constexpr double stiffness = 3000.0;
  constexpr double height = 0.4;
  const OneCable setup = falling_load(height, stiffness, 0.0, rate);
  double impulse = 0.0;
  double most = 0.0;
  double before = 0.0;
  while (setup.scene->body(0).velocity.y() <= 0.0 || setup.scene->taut(0)) {
    const double gap = setup.scene->reported_gap(0);
    before = setup.scene->body(0).velocity.y();
    setup.scene->step();
    const double pull = setup.scene->impulse(0);
    impulse += pull;
    most = std::max(most, setup.scene->taut_tension(0));
    EXPECT_NEAR(setup.scene->taut_tension(0), pull * rate, 1e-5 * load_weight);
    EXPECT_EQ(setup.scene->impact_impulse(0), 0.0);
    if (gap > 0.0 && setup.scene->reported_gap(0) > 0.0) {
      EXPECT_EQ(pull, 0.0);
    }
  }
  EXPECT_GT(before, 0.0);
  // from the fall to its return: sqrt(2 g height) up and down, less what the step damps
  const double speed = std::sqrt(2.0 * gravity * height);
  const double frequency = std::sqrt(stiffness / load_mass);
  const double phase = 2.0 * (std::acos(-1.0) - std::atan(frequency * speed / gravity));
  const double damped = 4.0 * frequency / rate;  // [-]
  EXPECT_NEAR(impulse / (2.0 * load_mass * speed + load_weight * phase / frequency), 1.0, damped);
  const double peak =
      load_weight + std::hypot(load_weight, std::sqrt(stiffness * load_mass) * speed);
  EXPECT_NEAR(most / peak, 1.0, damped);
  EXPECT_NEAR(setup.scene->peak_tension(0), most, 1e-5 * load_weight);
}

TEST(StretchingCable, IsDampedByItsOwnDamperAloneWhereThatIsLarger) {
  constexpr double ratio = 0.1;
  constexpr double turn = 0.1;  // [rad], of the oscillator in a step: that alone is a ratio of 0.05
  constexpr double rate = 240.0;
  const double stiffness = load_mass * turn * turn * rate * rate;
  const double restitution = 0.744079398;      // of this ratio, (E6)
  constexpr double late = 2.0 * ratio * turn;  // [-]: the damper begins up to a step late
  for (int part = 0; part < 8; ++part) {
    Scene scene(0.0, rate);
    scene.add_body(load_mass, load_moment * Vec3::Ones(),
                   Vec3(0.0, -0.9 - part / (8.0 * rate), 0.0), Vec3(0.0, -1.0, 0.0));
    CableData cable = {{0, Vec3::Zero()}, {-1, Vec3::Zero()}, 1.0, 0.0};
    cable.stiffness = {stiffness};
    cable.damping_ratio = ratio;
    scene.add_cable(cable);
    for (int step = 0; step < 120; ++step) {
      scene.step();
    }
    EXPECT_NEAR(scene.body(0).velocity.y(), restitution, late) << part;
  }
}

TEST(StretchingCable, BreaksInASnapAtItsBreakingTension) {
  for (const bool breaks : {false, true}) {
    const OneCable setup = falling_load(0.4, 3000.0, 0.1, 960.0);
    // by (E7) of an undamped cable the snap has 237 N
    setup.scene->break_at_tension(0, breaks ? 150.0 : 300.0);
    for (int step = 0; step < 960; ++step) {
      setup.scene->step();
    }
    EXPECT_EQ(setup.scene->broken(0), breaks);
  }
}

TEST(StretchingCable, HangsOnAWinchAndByEvents) {
  const OneCable setup = falling_load(0.0, 1e4, 0.2);
  setup.scene->wind(0, -0.3);
  for (int step = 0; step < 180; ++step) {
    setup.scene->step();
  }
  const double rounding = 1e-6 + 1e4 * Scene::rounding;
  EXPECT_NEAR(setup.scene->taut_tension(0) / load_weight, 1.0, rounding);
  EXPECT_NEAR(setup.scene->body(0).velocity.y(), 0.3, rounding);
  setup.scene->wind(0, 0.0);
  for (int step = 0; step < 600; ++step) {
    setup.scene->step_by_events();
  }
  EXPECT_NEAR(setup.scene->taut_tension(0) / load_weight, 1.0, rounding);
  EXPECT_NEAR(-setup.scene->reported_gap(0) * 1e4 / load_weight, 1.0, rounding);
}

}  // namespace
}  // namespace tautline::test
