// Takes steps with many loads, for a processor simulated by callgrind: `cable` or `joint` holds
// them, on `taut` or `bouncing` cables; with `made` the scene is only made. Prints how many steps
// there are.

#include <cstdio>
#include <memory>
#include <set>
#include <string>

#include "engines/cables/cost.hpp"
#include "engines/cables/measure.hpp"

namespace tautline::test {
namespace {

constexpr int loads = 40;
constexpr int steps = 60;

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

int taken(const std::set<std::string>& asked) {
  const Held held = asked.contains("joint") ? Held::by_joint : Held::by_cable;
  const auto scene =
      asked.contains("taut") ? many_loads(held, 0.5, 0.0, 1.0) : many_loads(held, 1.0, 0.3, 0.0);
  const int count = asked.contains("made") ? 0 : steps;
  for (int step = 0; step < count; ++step) {
    scene->step();
  }
  return count;
}

}  // namespace
}  // namespace tautline::test

int main(int argc, char** argv) {
  std::printf("%d steps\n", tautline::test::taken({argv + 1, argv + argc}));
}
