// Steps by events: the user's own forces act over the whole step, wherever he gives them.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

/// Rounding of numbers of some metres and metres per second, over thousands of steps [-].
double force_rounding() { return 1e5 * Scene::rounding; }

enum class Given { before_the_step, in_the_step };

class CableForces : public testing::TestWithParam<Given> {};

INSTANTIATE_TEST_SUITE_P(Given, CableForces,
                         testing::Values(Given::before_the_step, Given::in_the_step),
                         [](const testing::TestParamInfo<Given>& instance) {
                           return instance.param == Given::in_the_step ? "InTheStep" : "BeforeIt";
                         });

/// A load that falls from the height of its anchor, on an elastic cable of 1 m. `forces` are given
/// once a step, or in each part, with the time as it begins.
struct Falling {
  std::unique_ptr<Scene> scene;
  std::function<void(Scene&, double)> forces;
  Given given;
  double time = 0.0;  // [s]

  Falling(Given how, double rate, const Vec3& attachment, std::function<void(Scene&, double)> push)
      : scene(std::make_unique<Scene>(gravity, rate)), forces(std::move(push)), given(how) {
    scene->add_body(load_mass, load_moment * Vec3::Ones(), -attachment, Vec3::Zero());
    scene->add_cable({{0, attachment}, {-1, Vec3::Zero()}, 1.0, 1.0});
    if (given == Given::in_the_step) {
      scene->push_in_steps([this](double dt) {
        forces(*scene, time);
        time += dt;
      });
    }
  }
  Falling(const Falling&) = delete;
  Falling& operator=(const Falling&) = delete;
  ~Falling() = default;

  int step() {
    if (given == Given::before_the_step) {
      forces(*scene, time);
      time += scene->dt();
    }
    return scene->step_by_events();
  }
  /// The kinetic energy, and that of gravity above the anchor [J].
  [[nodiscard]] double energy() const { return test::energy(scene->body(0), Velocity::is_current); }
};

TEST_P(CableForces, ReboundToTheHeightTheyCameFromUnderAConstantForce) {
  for (const double rate : {60.0, 240.0}) {
    for (const double force : {5.0, -5.0}) {
      Falling load(GetParam(), rate, Vec3::Zero(), [force](Scene& scene, double /*time*/) {
        scene.push(0, Vec3(0, force, 0), Vec3::Zero());
      });
      int impacts = 0;
      for (int steps = 0; steps < 20 * static_cast<int>(rate); ++steps) {
        load.step();
        impacts += load.scene->impulse(0) > 0.0 ? 1 : 0;
        ASSERT_NEAR(load.energy() - force * load.scene->body(0).position.y(), 0.0,
                    20.0 * force_rounding())
            << "force " << force << ", step " << steps << " at " << rate << " Hz";
      }
      EXPECT_GT(impacts, 15);
    }
  }
}

/// A force off the centre and a torque turn the load too, and its cable is fastened off it.
TEST_P(CableForces, DoTheWorkOfAForceAtAPointAndATorque) {
  const Vec3 force(0, 3, 0);
  const double torque = 0.05;  // [N m]
  for (const Vec3& attachment : {Vec3(0, 0.1, 0), Vec3(0.05, 0.1, 0)}) {
    Falling load(GetParam(), 60.0, attachment, [&](Scene& scene, double /*time*/) {
      const BodyState body = scene.body(0);
      // at the end of an arm that does not turn: the moment about the centre is constant
      scene.push_at(0, force, body.position + Vec3(0.02, 0, 0));
      scene.push(0, Vec3::Zero(), Vec3(0, 0, torque));
    });
    const double start = load.energy() - force.y() * load.scene->body(0).position.y();
    double turned = 0.0;  // [rad]
    double before = 0.0;
    int impacts = 0;
    for (int steps = 0; steps < 90; ++steps) {
      load.step();
      impacts += load.scene->impulse(0) > 0.0 ? 1 : 0;
      const BodyState body = load.scene->body(0);
      const double angle = std::atan2(body.axes(1, 0), body.axes(0, 0));
      turned += std::remainder(angle - before, 2.0 * std::acos(-1.0));
      before = angle;
      const double moment = torque + 0.02 * force.y();
      // engines turn a body by rotations of a third order in the step, ODE of its own kind
      const double third = moment * std::pow(body.spin.norm() * Scene::step_length, 3);
      EXPECT_NEAR(load.energy() - force.y() * body.position.y() - moment * turned, start,
                  1e-9 + 20.0 * force_rounding() + (steps + 1) * third)
          << "step " << steps;
    }
    EXPECT_GE(impacts, 1);
  }
}

/// How high the load is after 3 s and some impacts, under 4 N that swing 7 rad a second.
double height_under_force(Given given, double rate) {
  Falling load(given, rate, Vec3::Zero(), [](Scene& scene, double time) {
    scene.push(0, Vec3(0, 4.0 * std::sin(7.0 * time), 0), Vec3::Zero());
  });
  for (int steps = 0; steps < 3 * static_cast<int>(rate); ++steps) {
    load.step();
  }
  return load.scene->body(0).position.y();
}

TEST_P(CableForces, OfTheTimeAreOfSecondOrderInTheStep) {
  // in float the rounding of so many small steps is more than what they gain
  const bool is_float = Scene::rounding > 1e-10;
  const double rounding = is_float ? 2e-3 : 0.0;  // [m]
  const double reference = height_under_force(GetParam(), is_float ? 960 : 7680);
  EXPECT_NEAR(height_under_force(GetParam(), 60), reference, 8e-3 + rounding);
  EXPECT_NEAR(height_under_force(GetParam(), 240), reference, 8e-3 / 16.0 + rounding);
}

/// The most by which a spring from the load to `end` adds energy in 10 s [J].
double driven_by_a_spring(Given given, double stiffness, const Vec3& end) {
  Falling load(given, 60.0, Vec3::Zero(), [&](Scene& scene, double /*time*/) {
    scene.push(0, stiffness * (end - scene.body(0).position), Vec3::Zero());
  });
  const auto all = [&] {
    return load.energy() + 0.5 * stiffness * (load.scene->body(0).position - end).squaredNorm();
  };
  load.scene->set_velocity(0, Vec3(0.5, 0, 0), Vec3::Zero());
  const double start = all();
  double most = 0.0;
  for (int steps = 0; steps < 600; ++steps) {
    load.step();
    most = std::max(most, all() - start);
  }
  return most;
}

TEST_P(CableForces, OfASpringDriveNothing) {
  // one turn in a second, above the cable's end: force and place are a step's way out of phase.
  // Held over each step it would add 26 times this
  const double swing = 0.5 * std::pow(load_mass * gravity, 2) / 80.0;
  EXPECT_LE(driven_by_a_spring(GetParam(), 80.0, Vec3::Zero()), 0.05 * swing);
  // with the impacts of a cable, each of which starts anew; before a step, nobody knows of the
  // impact in it. Held over each step it would add all of it again, and more
  const double fall = load_mass * gravity;
  EXPECT_LE(driven_by_a_spring(GetParam(), 20.0, Vec3(0, -0.5, 0)),
            (GetParam() == Given::in_the_step ? 0.02 : 0.08) * fall);
}

TEST_P(CableForces, OfDragTakeAsMuchAsInShortSteps) {
  const auto left = [](Given given, double rate) {
    Falling load(given, rate, Vec3::Zero(), [](Scene& scene, double /*time*/) {
      scene.push(0, -0.4 * scene.body(0).velocity, Vec3::Zero());
    });
    for (int steps = 0; steps < 5 * static_cast<int>(rate); ++steps) {
      load.step();
    }
    return load.energy();
  };
  const double reference = left(Given::in_the_step, 7680);
  EXPECT_LT(reference, -5.0);
  // before the step, the drag of a whole step is that before the impact in it
  const double order = GetParam() == Given::in_the_step ? 0.002 : 0.06;
  EXPECT_NEAR(left(GetParam(), 60), reference, -order * reference);
}

TEST_P(CableForces, OfOneStepActForOneStep) {
  for (const int at : {3, 10, 27}) {  // the cable goes taut in the 28th
    Falling load(GetParam(), 60.0, Vec3::Zero(), [&, at](Scene& scene, double time) {
      if (std::lround(std::floor(time * 60.0 + 1e-6)) == at) {
        scene.push(0, Vec3(6, 0, 0), Vec3::Zero());
      }
    });
    for (int steps = 0; steps < 40; ++steps) {
      load.step();
      if (load.scene->impulse(0) > 0.0) {
        break;
      }
      const double speed = steps < at ? 0.0 : 6.0 / load_mass * Scene::step_length;
      EXPECT_NEAR(load.scene->body(0).velocity.x(), speed, force_rounding()) << "step " << steps;
    }
  }
}

TEST_P(CableForces, HoldALoadTautAsGravityDoes) {
  for (const double force : {-5.0, 5.0}) {
    OneCable hanging{std::make_unique<Scene>(gravity), {}, 1};
    Scene& scene = *hanging.scene;
    scene.add_body(load_mass, load_moment * Vec3::Ones(), Vec3(0, -1, 0), Vec3::Zero());
    scene.add_cable({{0, Vec3::Zero()}, {-1, Vec3::Zero()}, 1.0, 0.5});
    const auto push = [&] { scene.push(0, Vec3(0, force, 0), Vec3::Zero()); };
    if (GetParam() == Given::in_the_step) {
      scene.push_in_steps([&](double /*dt*/) { push(); });
    }
    for (int steps = 0; steps < 120; ++steps) {
      if (GetParam() == Given::before_the_step) {
        push();
      }
      EXPECT_EQ(scene.step_by_events(), 1);
      // what a step function adds is known from its first call on
      EXPECT_LE(std::abs(scene.reported_gap(0)), 5.0 / load_mass * std::pow(scene.dt(), 2));
      if (steps > 2) {
        EXPECT_NEAR(scene.impulse(0) / scene.dt(), load_mass * gravity - force, 1e-3);
      }
    }
    EXPECT_NEAR(scene.reported_gap(0), 0.0, 1e-6);
  }
}

}  // namespace
}  // namespace tautline::test
