// Fixed steps of 1/60 s: restitution at every impact, momentum of a pair, and no pull while slack.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

/// Promised is 1 %. One row leaves ODE's CFM (1e-6 here) and float's rounding of 0.05 m/s in
/// coordinates of 6 m (1e-5) [-].
constexpr double restitution_tolerance = 1e-3;
constexpr double promised_tolerance = 1e-2;

/// Slower impacts are rounding to float [m/s].
constexpr double slowest = 0.05;

class Restitution : public testing::TestWithParam<Arrangement> {};

TEST_P(Restitution, IsThatOfTheCableAtEveryImpact) {
  for (const double restitution : {1.0, 0.9, 0.7, 0.5, 0.2}) {
    for (const double speed : {0.05, 0.1, 0.3, 1.0, 2.0, 5.0}) {
      OneCable setup = about_to_close(GetParam(), restitution, speed);
      int impacts = 0;
      bool slack = true;  // since it last pulled: what closes without is no impact
      for (int steps = 0; steps < 120; ++steps) {
        const Step step = take_step(setup);
        const bool fresh = step.impulse > 0.0 && slack;
        slack = step.impulse > 0.0 ? false : slack || step.gap > 0.0;
        if (!fresh || step.rate_before > -0.99 * slowest) {
          continue;
        }
        if (++impacts == 1) {
          EXPECT_NEAR(-step.rate_before, speed, 1e-3 * speed + 1e-4);
        }
        EXPECT_NEAR(-step.rate_after / step.rate_before, restitution,
                    restitution_tolerance * restitution)
            << "speed " << speed << ", impact " << impacts << " at " << step.rate_before;
      }
      EXPECT_GE(impacts, 1) << "e " << restitution << ", speed " << speed;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cable, Restitution, testing::ValuesIn(arrangements()),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           std::erase(name, '-');
                           return name;
                         });

TEST(Cable, ConservesTheMomentaOfAPair) {
  for (const double mass : {1.0, 100.0}) {
    OneCable setup{std::make_unique<Scene>(0.0), {}, 2};
    const Vec3 moments = load_moment * Vec3::Ones();
    const int one = setup.scene->add_body(load_mass, moments, Vec3(0, 3, 0), Vec3(-1, -3, 0.5));
    const int two = setup.scene->add_body(mass * load_mass, mass * moments, Vec3(0.5, 4.5, 0.3),
                                          Vec3(0.2, 1, 0));
    setup.cable = {{one, Vec3(0.2, 0.1, 0)}, {two, Vec3(0, -0.2, 0.1)}, cable_length, 0.7};
    setup.scene->add_cable(setup.cable);
    setup.scene->add_scenery();
    const auto momenta = [&setup](Vec3& angular) {
      Vec3 linear = Vec3::Zero();
      angular.setZero();
      for (const BodyState& body : bodies_of(*setup.scene, setup.count)) {
        linear += body.mass * body.velocity;
        angular += body.mass * body.position.cross(body.velocity) + body.inertia() * body.spin;
      }
      return linear;
    };
    int impacts = 0;
    for (int steps = 0; steps < 300; ++steps) {
      Vec3 angular_before;
      const Vec3 before = momenta(angular_before);
      const Step step = take_step(setup);
      Vec3 angular;
      const Vec3 after = momenta(angular);
      impacts += step.impulse > 0.0 ? 1 : 0;
      // rounding of the largest momentum there is, in a few operations
      const double allowed =
          100.0 * Scene::rounding * (1.0 + angular.norm() + mass * load_mass * 10);
      EXPECT_NEAR((after - before).norm(), 0.0, allowed) << "mass ratio " << mass;
      EXPECT_NEAR((angular - angular_before).norm(), 0.0, allowed) << "mass ratio " << mass;
    }
    EXPECT_GE(impacts, 1);
  }
}

/// A cable that pulls in a step is at its length when it ends; the swinging of the step aside.
TEST(Cable, NeverPullsWhereItStaysSlack) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int slack_steps = 0;
  int taut_steps = 0;
  for (int run = 0; run < 50; ++run) {
    OneCable setup = about_to_close(arrangements()[static_cast<std::size_t>(run) % 3], 0.7, 1.0);
    setup.scene->set_velocity(0, 4.0 * Vec3(any(generator), any(generator), any(generator)),
                              5.0 * Vec3(any(generator), any(generator), any(generator)));
    for (int steps = 0; steps < 200; ++steps) {
      const Step step = take_step(setup);
      const double gap = setup.scene->reported_gap(0);
      // it would have been out of gap without its pull, but for what gravity closes in a step
      const double fall = gravity * Scene::step_length * Scene::step_length;
      if (step.gap > fall && gap > fall) {
        EXPECT_EQ(step.impulse, 0.0) << "run " << run << ", gap " << step.gap << " to " << gap;
        EXPECT_FALSE(setup.scene->taut(0));
        ++slack_steps;
      }
      taut_steps += step.impulse > 0.0 ? 1 : 0;
    }
  }
  EXPECT_GT(slack_steps, 500);
  EXPECT_GT(taut_steps, 100);
}

TEST(Cable, ReportsItsGapAndRate) {
  OneCable setup = about_to_close(arrangements()[2], 0.7, 1.0);
  for (int steps = 0; steps < 60; ++steps) {
    setup.scene->step();
    const auto bodies = bodies_of(*setup.scene, setup.count);
    const Line line = line_of(setup.cable, bodies);
    const double allowed = 100.0 * Scene::rounding * 6.0;  // coordinates of 6 m
    EXPECT_NEAR(setup.scene->reported_gap(0), cable_length - line.distance, allowed);
    EXPECT_NEAR(setup.scene->reported_gap_rate(0), gap_rate(line, setup.cable, bodies), allowed);
  }
}

TEST(Cable, BouncesABoxThatSlidesOnTheGround) {
  for (const double restitution : {1.0, 0.7, 0.2}) {
    OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
    const int box = setup.scene->add_box(load_mass, Vec3(0, 0.1, 0));
    setup.cable = {{box, Vec3(-0.1, 0, 0)}, {-1, Vec3(-1, 0.1, 0)}, 1.1, restitution};
    setup.scene->add_cable(setup.cable);
    setup.scene->add_scenery();
    setup.scene->set_velocity(box, Vec3(3, 0, 0), Vec3::Zero());
    int impacts = 0;
    bool pulled = false;
    for (int steps = 0; steps < 30; ++steps) {
      const Step step = take_step(setup);
      if (step.impulse > 0.0 && !pulled && step.rate_before < -slowest) {
        ++impacts;
        EXPECT_NEAR(-step.rate_after / step.rate_before, restitution,
                    promised_tolerance * restitution);
      }
      pulled = step.impulse > 0.0;
    }
    EXPECT_GE(impacts, 1);
  }
}

/// A load of 10 kg on two cables from `side` [m] on its lid to one hook, or straight up.
void expect_bounces_on_two_cables(double side, bool hook, double restitution) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  const int load = setup.scene->add_body(10.0, Vec3(0.5, 1.0, 0.9), Vec3(0, 4.2, 0), Vec3::Zero());
  std::vector<CableData> cables;
  for (const double x : {-side, side}) {
    cables.push_back({{load, Vec3(x, 0.2, 0.5 * x)},
                      {-1, hook ? Vec3(0, 6, 0) : Vec3(x, 6, 0.5 * x)},
                      2.5,
                      restitution});
    setup.scene->add_cable(cables.back());
  }
  setup.scene->add_scenery();
  int impacts = 0;
  bool pulled = false;
  for (int steps = 0; steps < 200; ++steps) {
    const auto before = bodies_of(*setup.scene, 1);
    setup.scene->step();
    const auto after = bodies_of(*setup.scene, 1);
    const bool fresh = !pulled;
    pulled = false;
    for (int index = 0; index < 2; ++index) {
      const CableData& cable = cables[static_cast<std::size_t>(index)];
      const Line line = line_of(cable, before);
      const double closing = -gap_rate(line, cable, before);
      pulled = pulled || setup.scene->impulse(index) > 0.0;
      if (fresh && setup.scene->impulse(index) > 0.0 && closing > slowest) {
        ++impacts;
        EXPECT_NEAR(gap_rate(line, cable, after) / closing, restitution,
                    promised_tolerance * restitution)
            << "side " << side << ", hook " << hook << ", impact " << impacts << " at " << closing;
      }
    }
  }
  EXPECT_GE(impacts, 4);
}

TEST(Cable, BouncesALoadOnTwoCables) {
  for (const double restitution : {0.9, 0.7, 0.5}) {
    expect_bounces_on_two_cables(0.5, true, restitution);
    expect_bounces_on_two_cables(0.05, false, restitution);
    expect_bounces_on_two_cables(0.02, false, restitution);
  }
}

TEST(Cable, LetsALoadSettleOnTwoCloseCables) {
  OneCable setup{std::make_unique<Scene>(gravity), {}, 1};
  setup.scene->add_body(10.0, Vec3(0.5, 0.9, 1.0), Vec3(0, 3.8, 0), Vec3::Zero());
  for (const double x : {-0.05, 0.05}) {
    setup.scene->add_cable(
        {{0, Vec3(x, 0.2, 0.5 * x)}, {-1, Vec3(x, 6, 0)}, std::hypot(2.0, 0.5 * x), 0.5});
  }
  // it keeps turning to and fro under its cables, and bounces no more
  for (int steps = 0; steps < 1200; ++steps) {
    setup.scene->step();
    if (steps >= 600) {
      EXPECT_TRUE(setup.scene->taut(0) && setup.scene->taut(1)) << "step " << steps;
    }
  }
}

}  // namespace
}  // namespace tautline::test
