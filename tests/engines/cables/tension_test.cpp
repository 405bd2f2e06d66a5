// What can be read of a cable's tension, what breaks it, and how cables share a load.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "engines/cables/measure.hpp"
#include "engines/cables/worlds/run.hpp"

namespace tautline::test {
namespace {

class CableTension : public testing::TestWithParam<Stepping> {
 protected:
  static void step(Scene& scene) {
    GetParam() == Stepping::fixed ? scene.step() : static_cast<void>(scene.step_by_events());
  }
};

INSTANTIATE_TEST_SUITE_P(Stepped, CableTension,
                         testing::Values(Stepping::fixed, Stepping::by_events),
                         [](const testing::TestParamInfo<Stepping>& instance) {
                           return instance.param == Stepping::fixed ? "Fixed" : "ByEvents";
                         });

/// A truck of 2000 kg at 1 m/s takes up 0.1 m of slack to a car of 1000 kg.
std::unique_ptr<Scene> tow(double rate, double breaking_tension) {
  auto scene = std::make_unique<Scene>(0.0, rate);
  scene->add_body(2000.0, 200.0 * Vec3::Ones(), Vec3(4, 0, 0), Vec3(1, 0, 0));
  scene->add_body(1000.0, 100.0 * Vec3::Ones(), Vec3::Zero(), Vec3::Zero());
  scene->add_cable({{0, Vec3::Zero()}, {1, Vec3::Zero()}, 4.1, 0.0});
  scene->break_at_tension(0, breaking_tension);
  return scene;
}

TEST_P(CableTension, SeesNoImpact) {
  for (const double rate : {60.0, 240.0, 1000.0}) {
    const auto scene = tow(rate, 1.0);  // [N]
    double struck = 0.0;
    for (int steps = 0; steps < static_cast<int>(rate); ++steps) {
      step(*scene);
      struck += scene->impact_impulse(0);
      EXPECT_NEAR(scene->taut_tension(0), 0.0, 0.5) << "step " << steps << " at " << rate;
    }
    EXPECT_FALSE(scene->broken(0));
    EXPECT_NEAR(struck, 2000.0 * 1000.0 / 3000.0, 0.1);  // the reduced mass at 1 m/s
  }
}

TEST_P(CableTension, BreaksACableOfWhicheverStep) {
  for (const double rate : {60.0, 240.0, 1000.0}) {
    if (rate > 500.0 && Scene::rounding > 1e-10) {
      continue;  // a gap of float's rounding is closed in a step by hundreds of newtons
    }
    const auto scene = tow(rate, 1000.0);  // [N]
    double breaks_at = 0.0;
    for (int steps = 0; steps < static_cast<int>(4 * rate); ++steps) {
      // the engine pulls harder and harder, from the first second on; a third of it the car feels
      const double pull = 2000.0 * std::max(steps / rate - 1.0, 0.0);
      scene->push(0, Vec3(pull, 0, 0), Vec3::Zero());
      step(*scene);
      if (scene->broken(0) && breaks_at == 0.0) {
        breaks_at = pull;
      }
    }
    EXPECT_NEAR(breaks_at, 3000.0, 3.0 * 2000.0 / rate) << rate << " Hz";
    EXPECT_GT(-scene->reported_gap(0), 0.1);
  }
}

/// A step with an impact ends taut: its tension is that of the part after the impact.
TEST(CableTensionByEvents, IsReadApartFromTheImpact) {
  for (const double restitution : {0.0, 0.5}) {
    Scene scene(gravity);
    scene.add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, -0.7, 0), Vec3::Zero());
    scene.add_cable({{0, Vec3::Zero()}, {-1, Vec3::Zero()}, 1.0, restitution});
    while (scene.impulse(0) == 0.0) {
      scene.step_by_events();
    }
    const double speed = std::sqrt(2.0 * gravity * 0.3);
    const double impulse = (1.0 + restitution) * load_mass * speed;
    EXPECT_NEAR(scene.impact_impulse(0), impulse, 1e5 * Scene::rounding);
    const double tension = restitution > 0.0 ? 0.0 : load_mass * gravity;
    EXPECT_NEAR(scene.taut_tension(0), tension, 1e6 * Scene::rounding);
    if (restitution == 0.0) {
      EXPECT_GT(scene.impulse(0), scene.impact_impulse(0));
      scene.step_by_events();
      EXPECT_EQ(scene.impact_impulse(0), 0.0);
      EXPECT_NEAR(scene.taut_tension(0), tension, 1e6 * Scene::rounding);
    }
  }
}

/// A taut cable beside one that goes taut has tension, and its share of the impact.
TEST(CableTensionByEvents, IsReadApartOfATautCableThatAnImpactStrikes) {
  Scene scene(gravity);
  const int upper = scene.add_body(3.0, Vec3::Ones(), Vec3(0, -1, 0), Vec3::Zero());
  const int lower = scene.add_body(1.0, Vec3::Ones(), Vec3(0, -1.5, 0), Vec3::Zero());
  scene.add_cable({{upper, Vec3::Zero()}, {-1, Vec3::Zero()}, 1.0, 0.0});
  scene.add_cable({{lower, Vec3::Zero()}, {upper, Vec3::Zero()}, 0.9, 0.0});
  do {
    scene.step_by_events();
    EXPECT_NEAR(scene.taut_tension(0),
                scene.impulse(1) > 0.0 ? scene.taut_tension(0) : 3.0 * gravity,
                1e6 * Scene::rounding);
  } while (scene.impulse(1) == 0.0);
  const double impulse = std::sqrt(2.0 * gravity * 0.4);  // of 1 kg that fell by 0.4 m
  // a part is no shorter than 1e-4 of a step, and the cable above delays the impact
  const double late = 1e-3 * gravity * Scene::step_length + 1e5 * Scene::rounding;
  EXPECT_NEAR(scene.impact_impulse(0), impulse, late);
  EXPECT_NEAR(scene.impact_impulse(1), impulse, late);
  EXPECT_GT(scene.taut_tension(0), 3.0 * gravity - 1e-3);
  EXPECT_LT(scene.taut_tension(0), 4.0 * gravity + 1e-3);
  scene.step_by_events();
  EXPECT_NEAR(scene.taut_tension(0), 4.0 * gravity, 1e6 * Scene::rounding);
  EXPECT_NEAR(scene.taut_tension(1), gravity, 1e6 * Scene::rounding);
}

/// A pendulum from the height of its anchor: 3 m g cos(angle), in every step and so at its rating.
TEST_P(CableTension, OfASwingIsThatOfItsAngle) {
  for (const double rating : {0.99, 1.02}) {
    Scene scene(gravity);
    scene.add_body(load_mass, load_moment * Vec3::Ones(), Vec3(2, 0, 0), Vec3::Zero());
    scene.add_cable({{0, Vec3::Zero()}, {-1, Vec3::Zero()}, 2.0, 0.5});
    const double largest = 3.0 * load_mass * gravity;
    scene.break_at_tension(0, rating * largest);
    const auto right = [&] { return -largest * scene.body(0).position.y() / 2.0; };
    for (int steps = 0; steps < 75 && !scene.broken(0); ++steps) {
      const double before = right();
      step(scene);
      // fixed steps have the tension of their beginning, and swing half a step ahead
      EXPECT_NEAR(scene.taut_tension(0), 0.5 * (before + right()), 0.02 * largest) << steps;
    }
    EXPECT_EQ(scene.broken(0), rating < 1.0);
  }
}

/// Statics do not say how four ropes share a box: those that are alike pull alike.
TEST_P(CableTension, IsSharedByRedundantCables) {
  for (const double tilt : {0.0, 0.5}) {
    Scene scene(gravity);
    const double mass = 10.0;
    scene.add_body(mass, Vec3(0.4, 0.9, 0.7), Vec3::Zero(), Vec3::Zero());
    scene.set_velocity(0, Vec3::Zero(), Vec3(tilt, 0, 0.5 * tilt));
    for (const double x : {-0.5, 0.5}) {
      for (const double z : {-0.4, 0.4}) {
        scene.add_cable({{0, Vec3(x, 0.25, z)}, {-1, Vec3(x, 2.35, z)}, 2.1, 0.3});
      }
    }
    scene.push_in_steps([&](double /*dt*/) {
      const BodyState body = scene.body(0);
      scene.push(0, -20.0 * body.velocity, -2.0 * body.spin);  // until it is at rest
    });
    for (int steps = 0; steps < 1800; ++steps) {
      step(scene);
    }
    const double part = Scene::rounding > 1e-10 ? 0.15 : 1e-3;  // floats leave more of it open
    for (int cable = 0; cable < 4; ++cable) {
      EXPECT_NEAR(scene.taut_tension(cable), mass * gravity / 4.0, part * mass * gravity / 4.0)
          << "cable " << cable << ", tilt " << tilt;
    }
  }
}

}  // namespace
}  // namespace tautline::test
