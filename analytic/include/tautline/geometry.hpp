#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "tautline/case.hpp"

namespace tautline {

// Equation numbers are those of analytic/README.md.

/// Scalar cross product a x b.
template <class Real>
[[nodiscard]] Real cross(const BasicVec2<Real>& a, const BasicVec2<Real>& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// `v` turned by +90 degrees. Doubles stay side by side: a vector that is written number by number
/// and read as one waits for its numbers to reach the memory.
template <class Real>
[[nodiscard, gnu::always_inline]] inline BasicVec2<Real> perpendicular(const BasicVec2<Real>& v) {
  if constexpr (std::is_same_v<Real, double>) {
    return v.reverse().cwiseProduct(BasicVec2<Real>(-1.0, 1.0));
  } else {
    return {-v.y(), v.x()};
  }
}

/// The direction of the body's own first axis in the world.
template <class Real>
struct Heading {
  Real cosine;  // of the body's angle: the direction's x
  Real sine;    // and its y
};

/// At `angle` [rad], by arithmetic alone.
[[nodiscard]] Heading<double> compute_heading(double angle);

/// At `angle` [rad]. Every cable asks, for every question about a pose: the last answer is kept.
template <class Real>
[[nodiscard]] Heading<Real> heading(const Real& angle) {
  if constexpr (std::is_same_v<Real, double>) {
    static thread_local constinit double last = 0.0;
    static thread_local constinit Heading<double> kept{1.0, 0.0};
    if (std::bit_cast<std::uint64_t>(angle) != std::bit_cast<std::uint64_t>(last)) {
      kept = compute_heading(angle);
      last = angle;
    }
    return kept;
  } else {
    return {cos(angle), sin(angle)};
  }
}

/// The attachment relative to the centre of mass, in world axes [m].
template <class Real>
[[nodiscard]] BasicVec2<Real> attachment_arm(const BasicState<Real>& state,
                                             const BasicCable<Real>& cable) {
  const auto [c, s] = heading(state.angle);
  return c * cable.attachment + s * perpendicular<Real>(cable.attachment);
}

/// The body's attachment point in the world [m] (Eq. 1).
template <class Real>
[[nodiscard]] BasicVec2<Real> attachment_point(const BasicState<Real>& state,
                                               const BasicCable<Real>& cable) {
  return state.position + attachment_arm(state, cable);
}

/// The velocity of that point [m/s] (Eq. 2).
template <class Real>
[[nodiscard]] BasicVec2<Real> attachment_velocity(const BasicState<Real>& state,
                                                  const BasicCable<Real>& cable) {
  return state.velocity + state.spin * perpendicular(attachment_arm(state, cable));
}

/// Length minus distance [m]; admissible when >= 0 (Eq. 3).
template <class Real>
[[nodiscard]] Real gap(const BasicCable<Real>& cable, const BasicState<Real>& state) {
  return cable.length - (attachment_point(state, cable) - cable.anchor).norm();
}

/// d gap / dt [m/s]; negative when closing (Eq. 4).
template <class Real>
[[nodiscard]] Real gap_rate(const BasicCable<Real>& cable, const BasicState<Real>& state) {
  const BasicVec2<Real> arm = attachment_arm(state, cable);
  const BasicVec2<Real> from_anchor = state.position + arm - cable.anchor;
  const BasicVec2<Real> velocity = state.velocity + state.spin * perpendicular(arm);
  return -from_anchor.dot(velocity) / from_anchor.norm();
}

/// d^2 gap / dt^2 in free flight [m/s^2] (Eq. 5); negative when gravity closes the cable.
template <class Real>
[[nodiscard]] Real free_gap_acceleration(const BasicCase<Real>& the_case, std::size_t index,
                                         const BasicState<Real>& state) {
  const BasicCable<Real>& cable = the_case.cables[index];
  const BasicVec2<Real> arm = attachment_arm(state, cable);
  const BasicVec2<Real> from_anchor = state.position + arm - cable.anchor;
  const Real distance = from_anchor.norm();
  const BasicVec2<Real> velocity = state.velocity + state.spin * perpendicular(arm);
  const Real spin_squared = state.spin * state.spin;
  const BasicVec2<Real> acceleration = the_case.gravity - spin_squared * arm;
  const Real across = cross(from_anchor, velocity) / distance;
  return -(from_anchor.dot(acceleration) + across * across) / distance;
}

/// d gap / d(x, y, angle) [-, -, m]: the row of the constraint Jacobian (Eq. 6).
/// Requires distance > 0.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 3, 1> gap_gradient(const BasicCable<Real>& cable,
                                                     const BasicState<Real>& state) {
  const BasicVec2<Real> arm = attachment_arm(state, cable);
  const BasicVec2<Real> u = (state.position + arm - cable.anchor).normalized();
  return {-u.x(), -u.y(), -cross(arm, u)};
}

/// The rate of that row along the motion [1/s, 1/s, m/s]: the gap's second derivatives times the
/// velocity.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 3, 1> gap_gradient_rate(const BasicCable<Real>& cable,
                                                          const BasicState<Real>& state) {
  const BasicVec2<Real> arm = attachment_arm(state, cable);
  const BasicVec2<Real> from_anchor = state.position + arm - cable.anchor;
  const Real distance = from_anchor.norm();
  const BasicVec2<Real> u = from_anchor / distance;
  const BasicVec2<Real> arm_rate = state.spin * perpendicular(arm);
  const BasicVec2<Real> velocity = state.velocity + arm_rate;
  const BasicVec2<Real> u_rate = (velocity - u.dot(velocity) * u) / distance;
  return {-u_rate.x(), -u_rate.y(), -(cross(arm_rate, u) + cross(arm, u_rate))};
}

/// That rate as one of forces and moments in the world: in the plane the same.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 3, 1> wrench_rate(const BasicCable<Real>& cable,
                                                    const BasicState<Real>& state) {
  return gap_gradient_rate(cable, state);
}

/// Diagonal of the inverse mass matrix for (x, y, angle) [1/kg, 1/kg, 1/(kg m^2)].
/// A point mass does not turn: its third entry is 0.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, 3, 1> inverse_mass(const BasicBody<Real>& body) {
  const Real one(1);
  const Real inverse_inertia = body.inertia > 0 ? Real(one / body.inertia) : Real(0);
  return {one / body.mass, one / body.mass, inverse_inertia};
}

/// All that moves: the body.
template <class Real>
[[nodiscard]] const BasicBody<Real>& bodies_of(const BasicCase<Real>& the_case) {
  return the_case.body;
}

/// It, to be changed.
template <class Real>
[[nodiscard]] BasicBody<Real>& bodies_of(BasicCase<Real>& the_case) {
  return the_case.body;
}

/// How many ways to move it has.
template <class Real>
[[nodiscard]] constexpr std::size_t freedoms_of(const BasicCase<Real>& /*the_case*/) {
  return BasicCase<Real>::freedoms;
}

/// J M^-1 J^T over `cables`, in rising index order, symmetric positive semidefinite (Eq. 7).
template <class Real>
[[nodiscard]] BasicCableMatrix<Real> delassus(const BasicCase<Real>& the_case,
                                              const BasicState<Real>& state, CableSet cables) {
  std::array<Eigen::Matrix<Real, 3, 1>, max_cables> gradients;
  const Eigen::Matrix<Real, 3, 1> weight = inverse_mass(the_case.body);
  const auto count = static_cast<Eigen::Index>(cables.size());
  BasicCableMatrix<Real> result(count, count);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    Eigen::Matrix<Real, 3, 1>& gradient = gradients[static_cast<std::size_t>(row)];
    gradient = gap_gradient(the_case.cables[index], state);
    const Eigen::Matrix<Real, 3, 1> response = gradient.cwiseProduct(weight);
    for (Eigen::Index column = 0; column <= row; ++column) {
      result(row, column) = response.dot(gradients[static_cast<std::size_t>(column)]);
      result(column, row) = result(row, column);
    }
    ++row;
  }
  return result;
}

/// Its entry for one cable with itself [1/kg].
template <class Real>
[[nodiscard]] Real delassus(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                            std::size_t index) {
  const Eigen::Matrix<Real, 3, 1> row = gap_gradient(the_case.cables[index], state);
  return row.dot(row.cwiseProduct(inverse_mass(the_case.body)));
}

/// The next instant [s] at which something given over time is not smooth: never, all is constant.
template <class Real>
[[nodiscard]] Real next_knot(const BasicCase<Real>& /*the_case*/,
                             const BasicState<Real>& /*state*/) {
  return infinity<Real>();
}

/// The cables of `touching` that still touch at a knot, and those that do from there on.
template <class Real>
[[nodiscard]] CableSet touching_at_knot(const BasicCase<Real>& /*the_case*/,
                                        const BasicState<Real>& /*state*/, CableSet touching) {
  return touching;
}

/// True where ends of cables move in the world, or lengths change: then they do work.
template <class Real>
[[nodiscard]] constexpr bool is_driven(const BasicCase<Real>& /*the_case*/,
                                       const BasicState<Real>& /*state*/) {
  return false;
}

/// `state` at `time` [s], which a state of this kind of case does not keep.
template <class Real>
[[nodiscard]] BasicState<Real> at_time(BasicState<Real> state,
                                       const std::type_identity_t<Real>& /*time*/) {
  return state;
}

/// How long after `state` something given over time is not smooth the next time [s], > 0: never,
/// all is constant. A state of a kind of case that changes over time has its time.
template <class Real>
[[nodiscard]] Real time_to_knot(const BasicCase<Real>& /*the_case*/,
                                const BasicState<Real>& /*state*/) {
  return infinity<Real>();
}

/// The speed of the fastest centre of mass [m/s].
template <class Real>
[[nodiscard]] Real centre_speed(const BasicState<Real>& state) {
  return state.velocity.norm();
}

/// `state` standing still.
template <class Real>
[[nodiscard]] BasicState<Real> standing_still(BasicState<Real> state) {
  state.velocity.setZero();
  state.spin = Real(0);
  return state;
}

/// `state` moving `part` times as fast [-].
template <class Real>
[[nodiscard]] BasicState<Real> times_as_fast(BasicState<Real> state,
                                             const std::type_identity_t<Real>& part) {
  state.velocity *= part;
  state.spin *= part;
  return state;
}

/// `state` with `part` [-] of the jump from `before` to `after` added to its velocity and spin.
template <class Real>
[[nodiscard]] BasicState<Real> with_jump(BasicState<Real> state, const BasicState<Real>& before,
                                         const BasicState<Real>& after,
                                         const std::type_identity_t<Real>& part) {
  state.velocity += part * (after.velocity - before.velocity);
  state.spin += part * (after.spin - before.spin);
  return state;
}

/// `state` with `gain` added to its velocity and spin [m/s, m/s, rad/s].
template <class Real>
[[nodiscard]] BasicState<Real> with_gain(BasicState<Real> state,
                                         const Eigen::Matrix<Real, 3, 1>& gain) {
  state.velocity += gain.template head<2>();
  state.spin += gain[2];
  return state;
}

/// `there`, a state near `state` with the same velocity, with `gain` added to its velocity and
/// spin.
template <class Real>
[[nodiscard]] BasicState<Real> with_momentum(const BasicBody<Real>& /*body*/,
                                             BasicState<Real> there,
                                             const BasicState<Real>& /*state*/,
                                             const Eigen::Matrix<Real, 3, 1>& gain) {
  return with_gain(there, gain);
}

/// `state` after its pose has moved by `step` [m, m, rad].
template <class Real>
[[nodiscard]] BasicState<Real> moved(BasicState<Real> state,
                                     const Eigen::Matrix<Real, 3, 1>& step) {
  state.position += step.template head<2>();
  state.angle += step[2];
  return state;
}

/// The state with this `pose` and its `rate`: (x, y, angle) and theirs; of the kind of `like`.
template <class Real>
[[nodiscard]] BasicState<Real> state_of(const BasicState<Real>& /*like*/,
                                        const Eigen::Matrix<Real, 1, 3>& pose,
                                        const Eigen::Matrix<Real, 1, 3>& rate, const Real& /*dt*/) {
  return {{pose[0], pose[1]}, pose[2], {rate[0], rate[1]}, rate[2]};
}

/// Taylor coefficients of x, y and angle of a body that stays where it is, but for its spin.
template <class Real>
[[nodiscard]] Eigen::Matrix<Real, Eigen::Dynamic, 3> resting_poses(const BasicState<Real>& state) {
  Eigen::Matrix<Real, Eigen::Dynamic, 3> poses(2, 3);
  poses << state.position.x(), state.position.y(), state.angle, Real(0), Real(0), state.spin;
  return poses;
}

/// Adds turns of the body [rad] to the start of an arc, and to the `poses` along it, if any.
template <class Real>
void add_turns(BasicState<Real>& start, Eigen::Matrix<Real, Eigen::Dynamic, 3>& poses,
               const std::type_identity_t<Real>& turns) {
  start.angle += turns;
  if (poses.rows() > 0) {
    poses(0, 2) += turns;
  }
}

/// Applies `impulses` [N s], one per cable of `cables`, at the state's pose (Eq. 8).
template <class Real>
[[nodiscard]] BasicState<Real> with_impulses(const BasicCase<Real>& the_case,
                                             const BasicState<Real>& state, CableSet cables,
                                             const BasicCableVector<Real>& impulses) {
  Eigen::Matrix<Real, 3, 1> change = Eigen::Matrix<Real, 3, 1>::Zero();
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    change += impulses[row++] * gap_gradient(the_case.cables[index], state);
  }
  change = change.cwiseProduct(inverse_mass(the_case.body)).eval();
  return with_gain(state, change);
}

/// Kinetic energy [J].
template <class Real>
[[nodiscard]] Real kinetic_energy(const BasicBody<Real>& body, const BasicState<Real>& state) {
  return (body.mass * state.velocity.squaredNorm() + body.inertia * state.spin * state.spin) / 2;
}

/// Kinetic plus potential energy [J]; zero potential at the origin of the world (Eq. 9).
template <class Real>
[[nodiscard]] Real energy(const BasicCase<Real>& the_case, const BasicState<Real>& state) {
  return kinetic_energy(the_case.body, state) -
         the_case.body.mass * the_case.gravity.dot(state.position);
}

/// True while the state, its energy and the squares of its numbers fit a Real.
template <class Real>
[[nodiscard]] bool fits(const BasicCase<Real>& the_case, const BasicState<Real>& state) {
  return isfinite(energy(the_case, state)) && isfinite(state.angle) &&
         isfinite(state.position.squaredNorm()) && isfinite(state.velocity.squaredNorm()) &&
         isfinite(Real(state.spin * state.spin));
}

/// Linear momentum [N s].
template <class Real>
[[nodiscard]] BasicVec2<Real> momentum(const BasicCase<Real>& the_case,
                                       const BasicState<Real>& state) {
  return the_case.body.mass * state.velocity;
}

/// Angular momentum about a world point [N m s].
template <class Real>
[[nodiscard]] Real angular_momentum(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                    const BasicVec2<Real>& about) {
  const BasicVec2<Real> from = state.position - about;
  return the_case.body.mass * cross(from, state.velocity) + the_case.body.inertia * state.spin;
}

/// True where both cables hang side by side: their gaps are equal at every pose.
template <class Real>
[[nodiscard]] bool side_by_side(const BasicCable<Real>& a, const BasicCable<Real>& b) {
  return a.length == b.length && a.anchor == b.anchor && a.attachment == b.attachment;
}

/// The largest distance of an attachment from the centre of mass [m].
template <class Real>
[[nodiscard]] Real attachment_radius(const BasicCase<Real>& the_case) {
  Real radius(0);
  for (const BasicCable<Real>& cable : the_case.cables) {
    const Real norm = cable.attachment.norm();
    radius = norm > radius ? norm : radius;
  }
  return radius;
}

/// The radius of gyration [m], at which a turn weighs as much as a shift; 0 for a point mass, whose
/// turn has no part in the motion.
template <class Real>
[[nodiscard]] Real gyration_radius(const BasicCase<Real>& the_case) {
  return is_point_mass(the_case) ? Real(0)
                                 : Real(sqrt(Real(the_case.body.inertia / the_case.body.mass)));
}

/// The speed [m/s] at which the fastest of `cables` closes; 0 where none does.
template <class TheCase>
[[nodiscard]] RealOf<TheCase> closing_speed(const TheCase& the_case, CableSet cables,
                                            const StateOf<TheCase>& state) {
  RealOf<TheCase> fastest(0);
  for (const std::size_t index : cables) {
    fastest = max(fastest, RealOf<TheCase>(-gap_rate(the_case.cables[index], state)));
  }
  return fastest;
}

/// A bound of the speeds of the body's attachment points [m/s].
template <class Real>
[[nodiscard]] Real speed_scale(const BasicCase<Real>& the_case, const BasicState<Real>& state) {
  return state.velocity.norm() + abs(state.spin) * attachment_radius(the_case);
}

/// The angle of `cable` from gravity's direction, or from that of x without gravity, anticlockwise
/// [rad].
template <class Real>
[[nodiscard]] Real cable_angle(const BasicCable<Real>& cable, const BasicState<Real>& state,
                               const BasicVec2<Real>& gravity) {
  const BasicVec2<Real> along = attachment_point(state, cable) - cable.anchor;
  const BasicVec2<Real> down = gravity.isZero(0) ? BasicVec2<Real>(Real(1), Real(0)) : gravity;
  return atan2(Real(down.x() * along.y() - down.y() * along.x()), Real(down.dot(along)));
}

/// The shortest length of a cable [m].
template <class Real>
[[nodiscard]] Real shortest_length(const BasicCase<Real>& the_case) {
  Real shortest = the_case.cables.front().length;
  for (const BasicCable<Real>& cable : the_case.cables) {
    shortest = cable.length < shortest ? cable.length : shortest;
  }
  return shortest;
}
/// At every state.
template <class Real>
[[nodiscard]] Real shortest_length(const BasicCase<Real>& the_case,
                                   const BasicState<Real>& /*state*/) {
  return shortest_length(the_case);
}

/// The size of the gaps' accelerations that gravity, the turn and the lengths give [m/s^2] (Eq. 5).
template <class Real>
[[nodiscard]] Real acceleration_scale(const BasicCase<Real>& the_case,
                                      const BasicState<Real>& state) {
  const Real speed = speed_scale(the_case, state);
  return the_case.gravity.norm() + state.spin * state.spin * attachment_radius(the_case) +
         speed * speed / shortest_length(the_case);
}

}  // namespace tautline
