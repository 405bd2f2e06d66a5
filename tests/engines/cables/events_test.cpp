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

/// A load hoisted at 3 m/s; what hoists it brakes by `part` of gravity, at the mean speed of each
/// step, and the cable carries the rest.
void expect_tension_while_braking(bool by_hook, double part, double rate) {
  Scene scene(gravity, rate);
  const double speed = 3.0;
  const double length = 4.0;
  const Vec3 top(0, 2, 0);
  const int load = scene.add_body(load_mass, load_moment * Vec3::Ones(),
                                  top - length * Vec3::UnitY(), speed * Vec3::UnitY());
  const int hook = by_hook ? scene.add_hook(top) : -1;
  const int cable =
      scene.add_cable({{load, Vec3::Zero()}, {hook, by_hook ? Vec3::Zero() : top}, length, 0.5});
  const double braking = part * gravity;
  const double right = load_mass * (gravity - braking);
  // rounding of float in coordinates of some metres, in the velocity of a step
  const double allowed = std::max(1e-6, 1e3 * Scene::rounding * rate) * right / (1.0 - part);
  const auto hoisted = [speed, braking](double time) {
    return speed * time - 0.5 * braking * time * time;
  };
  const int steps = static_cast<int>(0.9 * speed / braking * rate);
  for (int step = 0; step < steps; ++step) {
    const double way = hoisted((step + 1) / rate) - hoisted(step / rate);
    if (by_hook) {
      scene.move_hook(hook, top + hoisted((step + 1) / rate) * Vec3::UnitY());
    } else {
      scene.wind(cable, -way * rate);
    }
    scene.step_by_events();
    ASSERT_NEAR(scene.impulse(cable) * rate, right, allowed)
        << "step " << step << ", part " << part << ", " << rate << " Hz, hook " << by_hook;
  }
}

TEST(CableByEvents, StaysTautWhileWhatHoistsBrakesByLessThanGravity) {
  for (const bool by_hook : {false, true}) {
    for (const double part : {0.3, 0.6, 0.8, 0.95}) {
      for (const double rate : {60.0, 240.0}) {
        expect_tension_while_braking(by_hook, part, rate);
      }
    }
  }
}

/// A hook that goes up and down as 1 m sin(4 t) throws its load, which flies, and catches it: its
/// cable goes slack where the hook brakes by gravity, and taut where the parabola meets the sine.
TEST(CableByEvents, IsThrownAndCaughtByAHeavingHook) {
  Scene scene(gravity);
  const double mass = 600.0;
  const double length = 20.0;
  const double pace = 4.0;
  scene.add_body(mass, load_moment * mass * Vec3::Ones(), -length * Vec3::UnitY(), Vec3::Zero());
  const int hook = scene.add_hook(Vec3::Zero());
  scene.add_cable({{0, Vec3::Zero()}, {hook, Vec3::Zero()}, length, 0.0});
  const double period = 2.0 * std::acos(-1.0) / pace;
  const double thrown = std::asin(gravity / (pace * pace)) / pace;
  const double caught = 1.1434;   // [s]
  const double impulse = 3530.4;  // [N s]
  int slack = 0;
  std::vector<double> snaps;
  bool was_taut = true;
  const int steps = 480;
  for (int step = 0; step < steps; ++step) {
    const double time = (step + 1) * scene.dt();
    scene.move_hook(hook, std::sin(pace * time) * Vec3::UnitY());
    scene.step_by_events();
    const double since = std::fmod(time, period);
    const bool taut = scene.taut(0);
    slack += taut ? 0 : 1;
    if (taut && !was_taut) {
      snaps.push_back(scene.impulse(0));
      EXPECT_NEAR(since, caught, 2.0 * scene.dt());
    }
    was_taut = taut;
    const double tension =
        mass * (gravity - pace * pace * std::sin(pace * (time - 0.5 * scene.dt())));
    // away from the throw and the catch, by two steps
    const double margin = 2.0 * scene.dt();
    if (time > 3.0 * scene.dt() && since > margin && since < thrown - margin) {
      EXPECT_NEAR(scene.impulse(0) / scene.dt(), tension, 0.02 * mass * gravity) << time << " s";
    }
  }
  EXPECT_NEAR(slack / static_cast<double>(steps), 0.611, 0.01);
  ASSERT_GE(snaps.size(), 4U);
  for (const double snap : snaps) {
    EXPECT_NEAR(snap, impulse, 0.1 * impulse);  // with the tension of the rest of its step
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
