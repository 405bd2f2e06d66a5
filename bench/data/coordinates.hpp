#pragma once

#include <array>
#include <type_traits>

#include "tautline/case.hpp"

namespace tautline::bench {

/// One number of a state, and how tables name it.
template <class Real>
struct Coordinate {
  const char* name;
  const char* unit;
  bool is_rate;  // of another coordinate
  Real& value;   // [unit], inside of the state
};

/// The numbers of `state`, each with its name. What writes, reads or prints states loops over them.
template <class State>
requires requires(State& state) { state.angle; }
[[nodiscard]] auto coordinates(State& state) {
  using Real = std::remove_reference_t<decltype((state.angle))>;
  return std::array<Coordinate<Real>, 6>{{{"x", "m", false, state.position[0]},
                                          {"y", "m", false, state.position[1]},
                                          {"angle", "rad", false, state.angle},
                                          {"vx", "m/s", true, state.velocity[0]},
                                          {"vy", "m/s", true, state.velocity[1]},
                                          {"spin", "rad/s", true, state.spin}}};
}

/// Likewise in space; the orientation is a quaternion w, x, y, z, the spin in the body's axes.
template <class State>
requires requires(State& state) { state.orientation; }
[[nodiscard]] auto coordinates(State& state) {
  using Real = std::remove_reference_t<decltype((state.spin[0]))>;
  return std::array<Coordinate<Real>, 13>{{{"x", "m", false, state.position[0]},
                                           {"y", "m", false, state.position[1]},
                                           {"z", "m", false, state.position[2]},
                                           {"qw", "", false, state.orientation[0]},
                                           {"qx", "", false, state.orientation[1]},
                                           {"qy", "", false, state.orientation[2]},
                                           {"qz", "", false, state.orientation[3]},
                                           {"vx", "m/s", true, state.velocity[0]},
                                           {"vy", "m/s", true, state.velocity[1]},
                                           {"vz", "m/s", true, state.velocity[2]},
                                           {"wx", "rad/s", true, state.spin[0]},
                                           {"wy", "rad/s", true, state.spin[1]},
                                           {"wz", "rad/s", true, state.spin[2]}}};
}

}  // namespace tautline::bench
