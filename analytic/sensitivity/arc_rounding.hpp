#pragma once

#include <algorithm>
#include <cmath>

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

/// What errors are measured against all along a motion.
struct Sizes {
  explicit Sizes(const Case& the_case)
      : radius(attachment_radius(the_case)),
        shortest(shortest_length(the_case)),
        gravity(the_case.gravity.norm()),
        turned(radius > 0.0 ? std::min(1.0 / radius,
                                       radius * the_case.body.mass * inverse_mass(the_case.body)[2])
                            : 0.0),
        turns(!is_point_mass(the_case)) {}

  /// A bound of the speeds of the body's attachment points [m/s].
  [[nodiscard]] double speed(const State& state) const {
    return state.velocity.norm() + std::abs(state.spin) * radius;
  }

  double radius;    // [m], of the attachments
  double shortest;  // [m], of the cables
  double gravity;   // [m/s^2]
  double turned;    // [1/m], the spin that a unit of velocity turns into where cables share it out
  bool turns;       // false: a point mass
};

/// What first order and the series of derivatives leave open of an error [-]: where one number of
/// a state passes a zero of its first order, this part of the others' may be in it.
inline constexpr double open_part = 1e-3;

/// The bounds of the six numbers of `state`.
inline State bounds(const StateMatrix& squares, const Sizes& sizes, const State& state) {
  const StateVector own = squares.diagonal().cwiseMax(0.0);
  const double place = own[0] + own[1] + sizes.radius * sizes.radius * own[2];
  const double speed = own[3] + own[4] + sizes.radius * sizes.radius * own[5];
  const double rate =  // [1/s], at which taut cables turn one into the other
      sizes.speed(state) / sizes.shortest + std::sqrt(sizes.gravity / sizes.shortest);
  const double open = open_part * open_part;
  const double off = open * (place + (rate > 0.0 ? speed / (rate * rate) : 0.0));
  const double fast = open * (speed + rate * rate * place);
  const double turned = sizes.turned * sizes.turned;
  return {{bound(own[0] + off), bound(own[1] + off)},
          bound(own[2] + turned * off),
          {bound(own[3] + fast), bound(own[4] + fast)},
          bound(own[5] + turned * fast)};
}

/// Taut cables whose `independence` is below this are near a dead point, where rounding grows [-]:
/// above it, the square of a tenth, `bound_margin` has that.
inline constexpr double near_dead_point = 1e-2;

/// Of the state at the end of an arc of length `dt`.
inline StateVector arc_rounding(const Sizes& sizes, const State& start, const State& end,
                                double dt) {
  const double speed =
      std::sqrt(std::max(start.velocity.squaredNorm(), end.velocity.squaredNorm()));
  const double place =
      start.position.norm() + end.position.norm() + speed * dt + sizes.gravity * dt * dt;
  const double turn = std::abs(start.angle) + std::abs(end.angle);
  const double rate = speed + sizes.gravity * dt;
  const double spin = std::max(std::abs(start.spin), std::abs(end.spin)) + rate * sizes.turned;
  StateVector result;
  result << place, place, turn, rate, rate, spin;
  constexpr double operations = 3.0;  // that count, of those that make each number
  return operations * one_rounding * result;
}

/// The same on taut cables of which two hold the body, with their longest arm [m] and the least
/// `independence` of the arc. The rounding of their gaps turns the body by as much as it is large
/// against the sine between their rows; in the pose turned so the cables' rates are off, and what
/// takes them away spins the body by as much again.
inline StateVector taut_rounding(const Sizes& sizes, const State& start, const State& end,
                                 double dt, double arm, double independence) {
  StateVector result = arc_rounding(sizes, start, end, dt);
  const double sine = std::sqrt(std::max(independence, epsilon<double>()));
  const double turn = result[0] / (arm * sine);
  if (independence < near_dead_point) {
    result *= std::sqrt(near_dead_point) / sine;
  }
  result[2] += turn;
  result[5] += sizes.speed(end) / sizes.shortest * turn / sine;
  return result;
}

}  // namespace tautline
