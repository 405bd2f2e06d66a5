// Taut swings that nothing presses outwards: without gravity, on a table seen from above, or of two
// loads that fall together. Energy, momenta and tension stay.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

constexpr int minute = 3600;  // steps

/// Two loads on a cable turn about each other, or one about a point.
struct Whirl {
  std::string name;
  double pace;         // [rad/s]
  double restitution;  // [-]
  double ratio;        // of the masses; 0: about a point
  double arm;          // of the attachments [m]
  bool by_events = false;
  double down = 0.0;  // gravity [m/s^2]
  int steps = minute;
  bool settles_late = false;  // what a swing borrows as it starts is less than it needs
};
void PrintTo(const Whirl& whirl, std::ostream* out) { *out << whirl.name; }

/// Claimed, of energy and tension: the tension is that of a circle that is wider by the arrow of a
/// step's chord, pace^2 dt^2 / 8, and 2e-4 at 2 rad/s [-].
constexpr double claimed = 1e-3;

class CableWhirl : public testing::TestWithParam<Whirl> {};

double kinetic(const std::vector<BodyState>& bodies, const Vec3& falling) {
  double sum = 0.0;
  for (const BodyState& body : bodies) {
    sum += 0.5 * body.mass * (body.velocity - falling).squaredNorm() +
           0.5 * body.spin.dot(body.inertia() * body.spin);
  }
  return sum;
}

TEST_P(CableWhirl, KeepsEnergyMomentaAndTension) {
  const Whirl& whirl = GetParam();
  Scene scene(whirl.down);
  const bool pair = whirl.ratio > 0.0;
  const double radius = pair ? whirl.ratio / (1.0 + whirl.ratio) : 1.0;
  const Vec3 moments = 0.01 * Vec3::Ones();
  const int bodies = pair ? 2 : 1;
  scene.add_body(1.0, moments, Vec3(-radius, 0, 0), Vec3(0, -whirl.pace * radius, 0));
  if (pair) {
    scene.add_body(whirl.ratio, whirl.ratio * moments, Vec3(1.0 - radius, 0, 0),
                   Vec3(0, whirl.pace * (1.0 - radius), 0));
  }
  for (int body = 0; body < bodies; ++body) {
    const Vec3 spin = (whirl.arm > 0.0 ? whirl.pace : 0.0) * Vec3::UnitZ();
    scene.set_velocity(body, scene.body(body).velocity, spin);
  }
  const CableEnd other = pair ? CableEnd{1, Vec3(-whirl.arm, 0, 0)} : CableEnd{-1, Vec3::Zero()};
  scene.add_cable({{0, Vec3(whirl.arm, 0, 0)},
                   other,
                   pair ? 1.0 - 2.0 * whirl.arm : 1.0 - whirl.arm,
                   whirl.restitution});
  const auto now = [&scene, bodies] { return bodies_of(scene, bodies); };
  const auto momentum = [](const std::vector<BodyState>& of) {
    Vec3 sum = Vec3::Zero();
    for (const BodyState& body : of) {
      sum += body.mass * body.position.cross(body.velocity) + body.inertia() * body.spin;
    }
    return sum;
  };
  const double energy = kinetic(now(), Vec3::Zero());
  const Vec3 angular = momentum(now());
  const double tension = radius * whirl.pace * whirl.pace;
  // the first step is half of one, the second settles it
  const int settled = whirl.settles_late ? 5 : 2;
  double highest = energy;
  for (int step = 1; step <= whirl.steps; ++step) {
    whirl.by_events ? static_cast<void>(scene.step_by_events()) : scene.step();
    const Vec3 falling = -whirl.down * step * scene.dt() * Vec3::UnitY();
    highest = std::max(highest, kinetic(now(), falling));
    ASSERT_TRUE(scene.taut(0)) << "step " << step;
    if (step > settled) {
      ASSERT_NEAR(scene.impulse(0) / scene.dt(), tension, claimed * tension) << "step " << step;
    }
  }
  const Vec3 falling = -whirl.down * whirl.steps * scene.dt() * Vec3::UnitY();
  EXPECT_NEAR(kinetic(now(), falling), energy, claimed * energy);
  EXPECT_LE(highest, energy * (1.0 + claimed));
  if (pair) {
    // some roundings in each step, all of one sign at worst
    EXPECT_NEAR((momentum(now()) - angular).norm(), 0.0,
                10.0 * whirl.steps * Scene::rounding * angular.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(
    Cable, CableWhirl,
    testing::Values(Whirl{"Plastic", 2.0, 0.0, 1.0, 0.0}, Whirl{"Partly", 2.0, 0.3, 1.0, 0.0},
                    Whirl{"Elastic", 2.0, 1.0, 1.0, 0.0}, Whirl{"Slow", 0.3, 0.0, 1.0, 0.0},
                    Whirl{"Fast", 4.5, 0.0, 1.0, 0.0}, Whirl{"Unequal", 2.0, 0.0, 30.0, 0.0},
                    Whirl{"AboutAPoint", 2.0, 0.0, 0.0, 0.0},
                    Whirl{"AboutAPointElastic", 3.0, 1.0, 0.0, 0.0},
                    Whirl{"WithArms", 2.0, 0.5, 3.0, 0.2},
                    Whirl{"WithAnArmAboutAPoint", 2.0, 0.0, 0.0, 0.3},
                    Whirl{"Falling", 2.0, 0.0, 3.0, 0.0, false, 9.81, 120},
                    Whirl{"ByEvents", 2.0, 0.0, 1.0, 0.0, true},
                    Whirl{"ByEventsElastic", 2.0, 1.0, 0.0, 0.0, true}),
    [](const auto& instance) { return instance.param.name; });

/// Faster than a start may borrow for: it takes some more steps to settle, and keeps its energy.
TEST(CableWhirlFast, KeepsItsEnergyAtAnyPace) {
  for (const double pace : {10.0, 20.0}) {
    Scene scene(0.0);
    scene.add_body(1.0, 0.01 * Vec3::Ones(), Vec3(-1, 0, 0), Vec3(0, -pace, 0));
    scene.add_cable({{0, Vec3::Zero()}, {-1, Vec3::Zero()}, 1.0, 0.0});
    const double energy = kinetic(bodies_of(scene, 1), Vec3::Zero());
    for (int step = 0; step < minute; ++step) {
      scene.step();
      ASSERT_LE(kinetic(bodies_of(scene, 1), Vec3::Zero()), energy * (1.0 + claimed));
    }
    EXPECT_NEAR(kinetic(bodies_of(scene, 1), Vec3::Zero()), energy, claimed * energy) << pace;
  }
}

/// Two loads in series on a table, and three in a ring: what the start takes, 3/4 of the square of
/// a step's angle, is all.
TEST(CableWhirlOfSeveral, LosesNoMoreThanItsStart) {
  const double pace = 2.0;
  const auto after = [](Scene& scene, int bodies) {
    const double energy = kinetic(bodies_of(scene, bodies), Vec3::Zero());
    for (int step = 0; step < minute; ++step) {
      scene.step();
    }
    return kinetic(bodies_of(scene, bodies), Vec3::Zero()) / energy - 1.0;
  };
  Scene series(0.0);
  for (const double radius : {1.0, 2.0}) {
    series.add_body(1.0, 0.01 * Vec3::Ones(), Vec3(radius, 0, 0), Vec3(0, pace * radius, 0));
  }
  series.add_cable({{0, Vec3::Zero()}, {-1, Vec3::Zero()}, 1.0, 0.0});
  series.add_cable({{1, Vec3::Zero()}, {0, Vec3::Zero()}, 1.0, 0.0});
  EXPECT_NEAR(after(series, 2), 0.0, claimed);
  Scene ring(0.0);
  const double third = 2.0 * std::acos(-1.0) / 3.0;
  for (int index = 0; index < 3; ++index) {
    const Vec3 out(std::cos(index * third), std::sin(index * third), 0.0);
    ring.add_body(1.0, 0.01 * Vec3::Ones(), out, pace * Vec3::UnitZ().cross(out));
  }
  for (int index = 0; index < 3; ++index) {
    ring.add_cable({{index, Vec3::Zero()}, {(index + 1) % 3, Vec3::Zero()}, std::sqrt(3.0), 0.0});
  }
  EXPECT_NEAR(after(ring, 3), 0.0, claimed);
}

}  // namespace
}  // namespace tautline::test
