// What a cable costs in a step, beside the engine's own ball joint in the same place.

#include <gtest/gtest.h>

#include <cstdio>

#include "engines/cables/cost.hpp"
#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

/// ODE's is 1.07 to 1.19 where a cable is taut: its ball joint takes as long as asking ODE, in
/// calls, for what a cable needs of its bodies. Bullet's is 0.56 to 0.68.
double allowed_ratio() { return Scene::engine == "ode" ? 1.3 : 1.0; }
constexpr int loads = 40;

#ifdef __OPTIMIZE__
constexpr bool optimised = true;
#else
constexpr bool optimised = false;
#endif

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

double ratio(double restitution, double above, double speed) {
  const double played = 1.0;  // [s]
  const auto joints = many_loads(Held::by_joint, restitution, above, speed);
  const auto cables = many_loads(Held::by_cable, restitution, above, speed);
  const Costs cost = costs(*cables, *joints, played);
  const double result = cost.cable / cost.joint;
  std::printf("%s: a step with cables takes %.3f of one with ball joints\n", Scene::engine.c_str(),
              result);
  return result;
}

TEST(Overhead, OfATautCableIsAllowed) {
  if (!optimised) {
    GTEST_SKIP() << "a program without optimisation measures the compiler";
  }
  EXPECT_LE(ratio(0.5, 0.0, 1.0), allowed_ratio());
}

TEST(Overhead, OfABouncingCableIsAllowed) {
  if (!optimised) {
    GTEST_SKIP() << "a program without optimisation measures the compiler";
  }
  EXPECT_LE(ratio(1.0, 0.3, 0.0), allowed_ratio());
}

}  // namespace
}  // namespace tautline::test
