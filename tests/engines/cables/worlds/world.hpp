// A world as data: loads, hooks that move, cables, ground and other boxes. Each engine's Scene
// plays it.
//
// Loads have the same moment of inertia about any axis. With unequal moments a body that tumbles
// freely gains or loses energy in both engines by itself, for they integrate its spin to first
// order; what is held against the cables here would be theirs. Most attachments are off the centre,
// so that cables do turn the loads.

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engines/cables/scene.hpp"

namespace tautline::test {

constexpr double world_gravity = 9.81;  // [m/s^2], unless a world has another
constexpr double box_side = 0.2;        // [m]

struct Load {
  double mass;    // [kg]
  double radius;  // of gyration [m]; that of the box if it is one
  Vec3 position;  // [m]
  Vec3 velocity;  // [m/s]
  Vec3 spin;      // [rad/s]
  bool is_box;    // of 0.2 m, and touches others; else it touches nothing
};

/// A hook goes to and fro on a line.
struct Hook {
  Vec3 middle;   // [m]
  Vec3 sway;     // to either side [m]
  double pace;   // [rad/s]
  double phase;  // [rad]

  [[nodiscard]] Vec3 at(double time) const { return middle + std::sin(pace * time + phase) * sway; }
};

/// The bodies of its scene are the loads, then the hooks, then the boxes.
struct World {
  std::string kind;
  std::uint64_t seed = 0;
  std::vector<Load> loads;
  std::vector<Hook> hooks;
  std::vector<CableData> cables;
  bool has_ground = false;
  bool may_sleep = false;
  double gravity = world_gravity;  // [m/s^2], downwards
  std::vector<Vec3> boxes;         // out of the loads' reach [m]

  [[nodiscard]] int load_count() const { return static_cast<int>(loads.size()); }
  [[nodiscard]] int hook(int index) const { return load_count() + index; }
};

/// A scene of `world`, `rate` steps a second.
[[nodiscard]] std::unique_ptr<Scene> play(const World& world, double rate);

/// Moves the hooks to where they are at `time` [s] with the next step.
void move_hooks(Scene& scene, const World& world, double time);

/// Where a cable's end is as the world begins [m].
[[nodiscard]] Vec3 place(const World& world, const CableEnd& end);

/// Fastens a cable that is longer by `slack` [m] than its ends are apart.
void tie(World& world, const CableEnd& first, const CableEnd& second, double slack,
         double restitution);

}  // namespace tautline::test
