// Steps split at the instants at which a cable goes taut: restitution is exact to rounding.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

/// Rounding of numbers of some metres and metres per second, after some operations [-].
double exact() { return 1e4 * Scene::rounding; }

/// The state after `dt` [s] of free flight without spin.
BodyState flown(BodyState body, double dt) {
  body.position += dt * body.velocity - 0.5 * dt * dt * gravity * Vec3::UnitY();
  body.velocity -= dt * gravity * Vec3::UnitY();
  return body;
}

TEST(CableByEvents, HasExactRestitutionInTheFirstImpact) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int measured = 0;
  for (int run = 0; run < 60; ++run) {
    const double restitution = 0.5 * (1.0 + any(generator));
    OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
    setup.scene->add_body(load_mass, Vec3(0.02, 0.05, 0.08), Vec3(0, 4, 0),
                          Vec3(any(generator), 2.0 * any(generator), any(generator)));
    setup.cable = {{0, 0.2 * Vec3(any(generator), 1, any(generator))},
                   {-1, Vec3(0, 5.2, 0)},
                   cable_length,
                   restitution};
    setup.scene->add_cable(setup.cable);
    setup.scene->add_scenery();
    std::vector<BodyState> before;
    int parts = 0;
    do {
      before = bodies_of(*setup.scene, 1);
      parts = setup.scene->step_by_events();
    } while (setup.scene->impulse(0) == 0.0);
    if (parts > 2) {
      continue;  // it came back within the step: the impulse is of two impacts
    }
    ++measured;

    // the impact, found from the state before by our own halving
    double slack = 0.0;
    double taut = Scene::step_length;
    for (int done = 0; done < 60; ++done) {
      const double middle = 0.5 * (slack + taut);
      const Line line = line_of(setup.cable, {flown(before[0], middle)});
      (line.distance > cable_length ? taut : slack) = middle;
    }
    const std::vector<BodyState> then = {flown(before[0], taut)};
    const Line line = line_of(setup.cable, then);
    const double closing = -gap_rate(line, setup.cable, then);
    const double rebound = setup.scene->impulse(0) * line.inverse[0] - closing;
    EXPECT_NEAR(rebound / closing, restitution, exact() / closing) << "run " << run;
  }
  EXPECT_GE(measured, 40);
}

TEST(CableByEvents, RaisesALoadToTheSquareOfRestitution) {
  for (const double restitution : {1.0, 0.9, 0.5, 0.2}) {
    OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
    setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 4, 0), Vec3::Zero());
    setup.cable = {{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, restitution};
    setup.scene->add_cable(setup.cable);
    setup.scene->add_scenery();
    const double weight = load_mass * gravity;
    double before = energy(setup.scene->body(0), Velocity::is_current) - 3.0 * weight;
    // a third rebound with 0.2 is over within its step
    for (int impact = 0; impact < 2; ++impact) {
      do {
        setup.scene->step_by_events();
      } while (setup.scene->impulse(0) == 0.0);
      const double after = energy(setup.scene->body(0), Velocity::is_current) - 3.0 * weight;
      // energies are differences of some 60 J
      EXPECT_NEAR(after, restitution * restitution * before, 60.0 * exact())
          << "e " << restitution << ", impact " << impact;
      before = after;
    }
  }
}

TEST(CableByEvents, GivesATumblingLoadNoEnergy) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  setup.scene->add_body(load_mass, Vec3(0.03, 0.06, 0.08), Vec3(0, 3.5, 0), Vec3(1, 0, 0.3));
  setup.cable = {{0, Vec3(0.2, 0.2, 0.1)}, {-1, Vec3(0, 5.2, 0)}, cable_length, 1.0};
  setup.scene->add_cable(setup.cable);
  setup.scene->add_scenery();
  const double start = energy(setup.scene->body(0), Velocity::is_current);
  int impacts = 0;
  for (int steps = 0; steps < 5000; ++steps) {
    setup.scene->step_by_events();
    impacts += setup.scene->impulse(0) > 0.0 ? 1 : 0;
    ASSERT_LE(energy(setup.scene->body(0), Velocity::is_current), start + 60.0 * exact());
  }
  EXPECT_GT(impacts, 100);
}

TEST(CableByEvents, IsHardlyOverstretchedByAFallOntoTwoCables) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  const int load =
      setup.scene->add_body(10.0, Vec3(0.5, 1.0, 0.9), Vec3(0.05, 4.2, 0), Vec3::Zero());
  for (const double side : {-0.5, 0.5}) {
    setup.scene->add_cable({{load, Vec3(side, 0.2, 0.5 * side)}, {-1, Vec3(0, 6, 0)}, 2.5, 0.5});
  }
  setup.scene->add_scenery();
  // a step of more impacts than parts ends with a late one
  const double late = gravity * Scene::step_length * Scene::step_length;
  for (int steps = 0; steps < 60; ++steps) {
    setup.scene->step_by_events();
    EXPECT_GE(setup.scene->reported_gap(0), -late);
    EXPECT_GE(setup.scene->reported_gap(1), -late);
  }
  for (int steps = 0; steps < 1200; ++steps) {
    setup.scene->step_by_events();
  }
  EXPECT_TRUE(setup.scene->taut(0));
  EXPECT_TRUE(setup.scene->taut(1));
}

TEST(CableByEvents, LeavesOtherBodiesInPeace) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  setup.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3.02, 0), Vec3::Zero());
  setup.scene->add_cable({{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, 1.0});
  setup.scene->add_scenery();
  // the scenery falls and comes to rest, while the load bounces every eighth of a second
  std::vector<BodyState> rested;
  int parts = 0;
  for (int steps = 0; steps < 900; ++steps) {
    parts += setup.scene->step_by_events();
    if (steps == 600) {
      rested = bodies_of(*setup.scene, setup.scene->count());
    }
  }
  EXPECT_GT(parts, 950);
  const auto after = bodies_of(*setup.scene, setup.scene->count());
  for (std::size_t index = 1; index < after.size(); ++index) {
    EXPECT_LT((after[index].position - rested[index].position).norm(), 1e-3) << "box " << index;
    EXPECT_LT(after[index].position.y(), 2.0) << "box " << index;
  }
}

/// Where a pendulum is after 5 s of steps, of which there are `rate` a second.
Vec3 swung(double rate) {
  Scene scene(gravity, rate);
  const Vec3 start(2, 4, 0);
  const Vec3 anchor(0, 5, 0);
  scene.add_body(load_mass, load_moment * Vec3::Ones(), start, Vec3::Zero());
  scene.add_cable({{0, Vec3::Zero()}, {-1, anchor}, (start - anchor).norm(), 0.5});
  for (int step = 0; step < 5 * static_cast<int>(rate); ++step) {
    scene.step_by_events();
  }
  return scene.body(0).position;
}

TEST(CableByEvents, SwingsToSecondOrderInTheStep) {
  const Vec3 reference = swung(Scene::rounding > 1e-10 ? 480 : 7680);
  const double coarse = (swung(60) - reference).norm();
  const double fine = (swung(120) - reference).norm();
  EXPECT_LT(coarse, 5e-3);  // [m]
  if (Scene::rounding > 1e-10) {
    EXPECT_LT(fine, coarse);  // float's rounding hides the rest
  } else {
    EXPECT_NEAR(coarse / fine, 4.0, 0.5);
  }
}

TEST(CableByEvents, TakesOnePartWhereNothingHappens) {
  OneCable setup = about_to_close(arrangements()[2], 0.7, 1.0);
  EXPECT_EQ(setup.scene->step_by_events(), 2);  // it closes in this step
  OneCable hanging{std::make_unique<Scene>(gravity), {}, 1};
  hanging.scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, 3, 0), Vec3::Zero());
  hanging.scene->add_cable({{0, Vec3(0, 0.2, 0)}, {-1, Vec3(0, 5.2, 0)}, cable_length, 0.5});
  for (int steps = 0; steps < 60; ++steps) {
    EXPECT_EQ(hanging.scene->step_by_events(), 1);
  }
}

}  // namespace
}  // namespace tautline::test
