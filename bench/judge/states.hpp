#pragma once

#include <algorithm>
#include <cstddef>

#include "tautline/system_geometry.hpp"

namespace tautline::bench {

// A state that is judged is of the body of a case, or of the bodies of a system in space.

/// How far the centres of mass are apart that are off the most [m].
[[nodiscard]] inline double apart(const State& one, const State& other) {
  return (one.position - other.position).norm();
}
[[nodiscard]] inline double apart(const SpatialSystemState& one, const SpatialSystemState& other) {
  double worst = 0.0;
  for (std::size_t body = 0; body < one.bodies.size(); ++body) {
    worst = std::max(worst, (one.bodies[body].position - other.bodies[body].position).norm());
  }
  return worst;
}

/// How far the ends of `cable` are apart that are off the most, of those on bodies [m].
[[nodiscard]] inline double ends_apart(const Cable& cable, const State& one, const State& other) {
  return (attachment_point(one, cable) - attachment_point(other, cable)).norm();
}
[[nodiscard]] inline double ends_apart(const SpatialCable& cable, const SpatialSystemState& one,
                                       const SpatialSystemState& other) {
  double worst = 0.0;
  for (std::size_t end = 0; end <= cable.segments(); ++end) {
    if (cable.end(end).body) {
      worst = std::max(worst, (moving_point(cable.end(end), one).position -
                               moving_point(cable.end(end), other).position)
                                  .norm());
    }
  }
  return worst;
}

}  // namespace tautline::bench
