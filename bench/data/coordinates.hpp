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
[[nodiscard]] auto coordinates(State& state) {
  using Real = std::remove_reference_t<decltype((state.angle))>;
  return std::array<Coordinate<Real>, 6>{{{"x", "m", false, state.position[0]},
                                          {"y", "m", false, state.position[1]},
                                          {"angle", "rad", false, state.angle},
                                          {"vx", "m/s", true, state.velocity[0]},
                                          {"vy", "m/s", true, state.velocity[1]},
                                          {"spin", "rad/s", true, state.spin}}};
}

}  // namespace tautline::bench
