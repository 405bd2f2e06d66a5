#pragma once

#include "spread.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solution.hpp"

namespace tautline {

// What doubles add to the error of a motion. Each number is made by a few
// operations, whose roundings are taken as independent.

/// The size of the numbers that a gap is computed from [m].
inline double gap_scale(const Case& the_case, std::size_t index, const State& state) {
  const Cable& cable = the_case.cables[index];
  return cable.length + cable.anchor.norm() + state.position.norm() + cable.attachment.norm();
}

/// The spin that a unit of velocity turns into where taut or hit cables share it out [1/m].
inline double turned(const Case& the_case) {
  const double radius = attachment_radius(the_case);
  if (!(radius > 0.0)) {
    return 0.0;
  }
  const double inverse_inertia = inverse_mass(the_case.body)[2];
  return std::min(1.0 / radius, radius * the_case.body.mass * inverse_inertia);
}

/// Of the state at the end of an arc of length `dt`.
inline StateVector arc_rounding(const Case& the_case, const State& start, const State& end,
                                double dt) {
  const double speed = std::max(start.velocity.norm(), end.velocity.norm());
  const double place =
      start.position.norm() + end.position.norm() + speed * dt + the_case.gravity.norm() * dt * dt;
  const double turn = std::abs(start.angle) + std::abs(end.angle);
  const double rate = speed + the_case.gravity.norm() * dt;
  const double spin = std::max(std::abs(start.spin), std::abs(end.spin)) + rate * turned(the_case);
  StateVector result;
  result << place, place, turn, rate, rate, spin;
  constexpr double operations = 3.0;  // that count, of those that make each number
  return operations * one_rounding * result;
}

/// Of the pose at which `hit` become taut: what their gaps are off zero, and rounding of the gaps
/// and of the turned attachments.
inline double contact_rounding(const Case& the_case, const State& state, CableSet hit) {
  double result = 0.0;
  for (const std::size_t index : hit) {
    result = std::max(result, std::abs(gap(the_case.cables[index], state)) +
                                  4 * one_rounding * gap_scale(the_case, index, state));
  }
  return result;
}

}  // namespace tautline
