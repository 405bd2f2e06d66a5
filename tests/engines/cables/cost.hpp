// What a step costs in one scene beside another, which takes its place in turns.

#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

#include "engines/cables/scene.hpp"

namespace tautline::test {

/// What holds the loads of a scene whose cost is measured.
enum class Held { by_joint, by_cable };

struct Costs {
  double cable;  // of a step [s]
  double joint;
};

/// Time of a step [s].
inline double time_of(Scene& scene) {
  const int steps = 20;  // so short that most are not interrupted
  const auto start = std::chrono::steady_clock::now();
  for (int step = 0; step < steps; ++step) {
    scene.step();
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / steps;
}

/// The least of the times of `seconds`, taken in turns: another's load on the machine only ever
/// adds, and a second has quiet moments among other work.
inline Costs costs(Scene& cables, Scene& joints, double seconds) {
  const double infinite = std::numeric_limits<double>::infinity();
  Costs result{infinite, infinite};
  const auto start = std::chrono::steady_clock::now();
  const std::chrono::duration<double> enough(seconds);
  while (std::chrono::steady_clock::now() - start < enough) {
    result.cable = std::min(result.cable, time_of(cables));
    result.joint = std::min(result.joint, time_of(joints));
  }
  return result;
}

}  // namespace tautline::test
