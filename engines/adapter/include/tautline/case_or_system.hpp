#pragma once

#include <algorithm>
#include <cstddef>

#include "tautline/system_geometry.hpp"

namespace tautline {

// A body in the plane and systems in space are asked alike.

/// The velocities of the bodies as a row of the constraint Jacobian has them [m/s, rad/s].
[[nodiscard]] inline Eigen::Vector3d motion_of(const State& state) {
  return {state.velocity.x(), state.velocity.y(), state.spin};
}
/// In a system one body comes after the other.
[[nodiscard]] inline RowOf<SpatialSystem> motion_of(const SpatialSystemState& state) {
  RowOf<SpatialSystem> result = no_change(state);
  Eigen::Index row = 0;
  for (const SpatialState& body : state.bodies) {
    result.segment<6>(row) << body.velocity, body.spin;
    row += 6;
  }
  return result;
}

/// `pose` with the velocities of `other`.
[[nodiscard]] inline State with_velocities(State pose, const State& other) {
  pose.velocity = other.velocity;
  pose.spin = other.spin;
  return pose;
}
/// Body by body in a system.
[[nodiscard]] inline SpatialSystemState with_velocities(SpatialSystemState pose,
                                                        const SpatialSystemState& other) {
  for (std::size_t body = 0; body < pose.bodies.size(); ++body) {
    pose.bodies[body].velocity = other.bodies[body].velocity;
    pose.bodies[body].spin = other.bodies[body].spin;
  }
  return pose;
}

/// The length of `cable` then [m].
[[nodiscard]] inline double length_of(const Cable& cable, const State& /*state*/) {
  return cable.length;
}
/// Given over time in a system.
[[nodiscard]] inline double length_of(const SpatialCable& cable, const SpatialSystemState& state) {
  return cable.length.at(state.time)[0];
}

/// The mass of the heaviest body [kg].
[[nodiscard]] inline double heaviest(const Case& the_case) { return the_case.body.mass; }
/// One of those of a system.
[[nodiscard]] inline double heaviest(const SpatialSystem& system) {
  return std::ranges::max_element(system.bodies, {}, &SpatialBody::mass)->mass;
}

/// The longest arm of a cable on body `index` [m].
[[nodiscard]] inline double longest_arm(const SpatialSystem& system, std::size_t index) {
  double arm = 0.0;
  for (const SpatialCable& cable : system.cables) {
    for (std::size_t end = 0; end <= cable.segments(); ++end) {
      arm = cable.end(end).body == index ? std::max(arm, cable.end(end).at.norm()) : arm;
    }
  }
  return arm;
}

}  // namespace tautline
