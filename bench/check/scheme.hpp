#pragma once

#include <string>

#include "tautline/case.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

// How an engine flies a slack step: what it does to the position, and what to the angle.

/// The exact parabola, or semi-implicit Euler in one of its two orders. In n substeps with the
/// velocity first, v += g h and x += v h + g h^2 (n + 1) / (2n), with the v before.
struct Flight {
  enum class Scheme { parabola, velocity_first, position_first };
  Scheme scheme = Scheme::parabola;
  int substeps = 1;  // of `velocity_first`
};

/// "the exact parabola", "semi-implicit Euler, velocity first", "4 substeps of semi-implicit
/// Euler", ...
[[nodiscard]] std::string to_string(const Flight& flight);

/// The state after a slack step of `dt` [s].
[[nodiscard]] State slack_step(State state, const Vec2& gravity, double dt, const Flight& flight);

/// The velocities before a step of `dt` [s] at the pose at which the step solves its constraints.
template <class State>  // of a `Case` or a `SpatialSystem`
[[nodiscard]] State at_the_solve(const State& before, double dt, const Flight& flight) {
  return flight.scheme == Flight::Scheme::position_first
             ? moved(before, (dt * motion_of(before)).eval())
             : before;
}

/// How `model` seems to fly, from one step of a fall. `rounding` [-] is what its numbers leave of
/// one near 1.
[[nodiscard]] Flight flight_of(const Engine& engine, const std::string& model, double rounding);

/// By what angle a step turns a body: spin dt, or m atan(spin dt / m). A spin that is added to a
/// quaternion or to a cosine and sine, and then normalised, turns by an arctangent: m is 1 for each
/// substep of the latter, 2 for each of the former.
struct Turn {
  int arctangents = 0;    // m; 0: spin dt, or like none of them
  double short_by = 0.0;  // [rad], of `probed_turn`
};

/// The turn of one step that is asked for [rad]: below the quarter of pi to which some engines cut
/// it, and large enough that 12 arctangents are told from 13 in float.
inline constexpr double probed_turn = 0.4;

[[nodiscard]] Turn turn_of(const Engine& engine, const std::string& model, double rounding);

}  // namespace tautline::bench
