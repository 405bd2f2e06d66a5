// What a cable costs in a step, beside the engine's own ball joint in the same place.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>

#include "measure.hpp"

namespace tautline::test {
namespace {

/// Bullet's is 0.56 to 0.68. ODE's is 1.07 to 1.19 where a cable is taut: its ball joint takes as
/// long as asking ODE, in calls, for what a cable needs of its bodies.
constexpr double allowed_ratio = 1.3;
constexpr int loads = 40;

#ifdef __OPTIMIZE__
constexpr bool optimised = true;
#else
constexpr bool optimised = false;
#endif

enum class Held { by_joint, by_cable };

/// Many loads, each on its own; they hang, or swing by `speed` [m/s].
std::unique_ptr<Scene> many_loads(Held held, double restitution, double above, double speed) {
  auto scene = std::make_unique<Scene>(gravity);
  for (int index = 0; index < loads; ++index) {
    const double x = 2.0 * index;
    const double y = 3.0 + (held == Held::by_cable ? above : 0.0);
    const int load =
        scene->add_body(load_mass, load_moment * Vec3::Ones(), Vec3(x, y, 0), Vec3(speed, 0, 0));
    if (held == Held::by_joint) {
      scene->add_ball_joint(load, Vec3(0, 2.2, 0));
    } else {
      scene->add_cable({{load, Vec3(0, 0.2, 0)}, {-1, Vec3(x, 5.2, 0)}, cable_length, restitution});
    }
  }
  return scene;
}

double time_of(Scene& scene) {
  const int steps = 20;  // so short that most are not interrupted
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < steps; ++step) {
    scene.step();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The least of several times, taken in turns: another's load on the machine only ever adds.
double ratio(double restitution, double above, double speed) {
  const auto joints = many_loads(Held::by_joint, restitution, above, speed);
  const auto cables = many_loads(Held::by_cable, restitution, above, speed);
  double of_joints = std::numeric_limits<double>::infinity();
  double of_cables = of_joints;
  constexpr int turns = 1000;  // some a second: long enough to have quiet moments among other tests
  for (int turn = 0; turn < turns; ++turn) {
    of_joints = std::min(of_joints, time_of(*joints));
    of_cables = std::min(of_cables, time_of(*cables));
  }
  const double result = of_cables / of_joints;
  std::printf("%s: a step with cables takes %.3f of one with ball joints\n", Scene::engine.c_str(),
              result);
  return result;
}

TEST(Overhead, OfATautCableIsAllowed) {
  if (!optimised) {
    GTEST_SKIP() << "a program without optimisation measures the compiler";
  }
  EXPECT_LE(ratio(0.5, 0.0, 1.0), allowed_ratio);
}

TEST(Overhead, OfABouncingCableIsAllowed) {
  if (!optimised) {
    GTEST_SKIP() << "a program without optimisation measures the compiler";
  }
  EXPECT_LE(ratio(1.0, 0.3, 0.0), allowed_ratio);
}

}  // namespace
}  // namespace tautline::test
