#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <type_traits>

#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"

// All that differs between bodies in the plane and in space: how they turn. The rest of a system
// is written once for any dimension D. Equations (S1), (S2), ... are in analytic/README.md,
// section 12.

namespace tautline {

/// A point of D dimensions, or a direction.
template <class Real, int D>
using BasicVector = Eigen::Matrix<Real, D, 1>;

/// How many numbers a spin has.
template <int D>
inline constexpr int spins = D == 2 ? 1 : 3;

/// A spin, a turn or a moment of D dimensions, in the axes of the body. In the plane it is one
/// number, anticlockwise.
template <class Real, int D>
using BasicTurn = Eigen::Matrix<Real, spins<D>, 1>;

/// A unit quaternion w, x, y, z: the turn by `a` about the unit vector u is cos(a/2), sin(a/2) u.
template <class Real>
using BasicQuaternion = Eigen::Matrix<Real, 4, 1>;
using Quaternion = BasicQuaternion<double>;  // in double

/// The place of a body in space, and its motion.
template <class Real>
struct BasicSpatialState {
  BasicVector<Real, 3> position = BasicVector<Real, 3>::Zero();  // [m], of the centre of mass
  /// From the body's axes to the world's. It and its negative are the same orientation.
  BasicQuaternion<Real> orientation = BasicQuaternion<Real>::Unit(0);
  BasicVector<Real, 3> velocity = BasicVector<Real, 3>::Zero();  // [m/s], of the centre of mass
  BasicVector<Real, 3> spin = BasicVector<Real, 3>::Zero();      // [rad/s], in the body's axes
};
using SpatialState = BasicSpatialState<double>;  // in double

/// The types that differ between the plane and space.
template <class Real, int D>
struct Turning;
/// In the plane a body turns by an angle.
template <class Real>
struct Turning<Real, 2> {
  using Inertia = Real;                   ///< [kg m^2], about the centre of mass
  using BodyState = BasicState<Real>;     ///< place and velocity of one body
  static constexpr int pose_numbers = 3;  ///< of an arc: x, y and the angle

  /// The inertia of a point mass.
  [[nodiscard]] static Inertia of_point() { return Real(0); }
};
/// In space a body turns by a quaternion. The axes of a body are its principal axes.
template <class Real>
struct Turning<Real, 3> {
  using Inertia = BasicVector<Real, 3>;       ///< [kg m^2], the principal moments
  using BodyState = BasicSpatialState<Real>;  ///< place and velocity of one body
  static constexpr int pose_numbers = 10;     ///< of an arc: position, quaternion and spin

  /// The inertia of a point mass.
  [[nodiscard]] static Inertia of_point() { return Inertia::Zero(); }
};

/// The moments of inertia [kg m^2], one for each number of a spin.
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> moments(const Real& inertia) {
  return BasicTurn<Real, 2>(inertia);
}
/// In space the three principal ones.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> moments(const BasicVector<Real, 3>& inertia) {
  return inertia;
}

/// True for a body that turns: it has an inertia, and is no point mass.
template <class Real>
[[nodiscard]] bool has_inertia(const Real& inertia) {
  return inertia > 0;
}
/// In space its moments are all zero, or all above zero.
template <class Real>
[[nodiscard]] bool has_inertia(const BasicVector<Real, 3>& inertia) {
  return inertia.x() > 0;
}

/// The spin of a body [rad/s].
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> spin_of(const BasicState<Real>& state) {
  return BasicTurn<Real, 2>(state.spin);
}
/// In space it is in the axes of the body.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> spin_of(const BasicSpatialState<Real>& state) {
  return state.spin;
}

/// `state` with this spin [rad/s].
template <class Real>
[[nodiscard]] BasicState<Real> with_spin(BasicState<Real> state,
                                         const std::type_identity_t<BasicTurn<Real, 2>>& spin) {
  state.spin = spin[0];
  return state;
}
/// In space.
template <class Real>
[[nodiscard]] BasicSpatialState<Real> with_spin(
    BasicSpatialState<Real> state, const std::type_identity_t<BasicTurn<Real, 3>>& spin) {
  state.spin = spin;
  return state;
}

/// The size of a spin [rad/s].
template <class Real>
[[nodiscard]] Real spin_size(const BasicState<Real>& state) {
  return abs(state.spin);
}
/// In space.
template <class Real>
[[nodiscard]] Real spin_size(const BasicSpatialState<Real>& state) {
  return state.spin.norm();
}

// ---- quaternions

/// The turn `second` after `first` where both are from the body's axes: first second.
template <class Real>
[[nodiscard]] BasicQuaternion<Real> product(const BasicQuaternion<Real>& first,
                                            const BasicQuaternion<Real>& second) {
  const BasicVector<Real, 3> a = first.template tail<3>();
  const BasicVector<Real, 3> b = second.template tail<3>();
  BasicQuaternion<Real> result;
  result[0] = first[0] * second[0] - a.dot(b);
  result.template tail<3>() = first[0] * b + second[0] * a + a.cross(b);
  return result;
}

/// The turn back.
template <class Real>
[[nodiscard]] BasicQuaternion<Real> conjugate(BasicQuaternion<Real> q) {
  q.template tail<3>() *= Real(-1);
  return q;
}

/// The quaternion of a turn by `by` [rad], an axis times an angle.
template <class Real>
[[nodiscard]] BasicQuaternion<Real> quaternion_of(const BasicVector<Real, 3>& by) {
  const Real angle = by.norm();
  if (!(angle > 0)) {
    return BasicQuaternion<Real>::Unit(0);
  }
  const Real half = angle / 2;
  BasicQuaternion<Real> result;
  result[0] = cos(half);
  result.template tail<3>() = by * Real(sin(half) / angle);
  return result;
}

/// The angle between two orientations [rad], 0 to pi.
template <class Real>
[[nodiscard]] Real angle_between(const BasicQuaternion<Real>& a, const BasicQuaternion<Real>& b) {
  const BasicQuaternion<Real> turn = product<Real>(conjugate<Real>(a), b);
  return 2 * atan2(Real(turn.template tail<3>().norm()), Real(abs(turn[0])));
}

/// `v`, in the axes of a body of this orientation, in world axes.
template <class Real>
[[nodiscard]] BasicVector<Real, 3> rotated(const BasicQuaternion<Real>& q,
                                           const BasicVector<Real, 3>& v) {
  const BasicVector<Real, 3> axis = q.template tail<3>();
  const BasicVector<Real, 3> twice = 2 * axis.cross(v);
  return v + q[0] * twice + axis.cross(twice);
}

/// `v`, in world axes, in the axes of a body of this orientation.
template <class Real>
[[nodiscard]] BasicVector<Real, 3> rotated_back(const BasicQuaternion<Real>& q,
                                                const BasicVector<Real, 3>& v) {
  return rotated<Real>(conjugate<Real>(q), v);
}

// ---- points of a body

/// `at`, in the frame of a body in `state`, in world axes [m].
template <class Real>
[[nodiscard]] BasicVec2<Real> in_the_world(const BasicState<Real>& state,
                                           const std::type_identity_t<BasicVec2<Real>>& at) {
  const auto [c, s] = heading(state.angle);
  return c * at + s * perpendicular<Real>(at);
}
/// In space.
template <class Real>
[[nodiscard]] BasicVector<Real, 3> in_the_world(
    const BasicSpatialState<Real>& state, const std::type_identity_t<BasicVector<Real, 3>>& at) {
  return rotated<Real>(state.orientation, at);
}

/// The velocity of the end of `arm` [m], in world axes, of a body in `state` that turns with `spin`
/// [rad/s].
template <class Real>
[[nodiscard]] BasicVec2<Real> swept(const BasicState<Real>& /*state*/,
                                    const std::type_identity_t<BasicTurn<Real, 2>>& spin,
                                    const std::type_identity_t<BasicVec2<Real>>& arm) {
  return spin[0] * perpendicular<Real>(arm);
}
/// In space.
template <class Real>
[[nodiscard]] BasicVector<Real, 3> swept(const BasicSpatialState<Real>& state,
                                         const std::type_identity_t<BasicTurn<Real, 3>>& spin,
                                         const std::type_identity_t<BasicVector<Real, 3>>& arm) {
  return in_the_world(state, spin).cross(arm);
}

/// The moment about its centre, in the axes of the body, of a `force` in world axes at the point
/// `at` of the body, which is at the end of `arm`.
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> moment_of(const BasicState<Real>& /*state*/,
                                           const std::type_identity_t<BasicVec2<Real>>& /*at*/,
                                           const std::type_identity_t<BasicVec2<Real>>& arm,
                                           const std::type_identity_t<BasicVec2<Real>>& force) {
  return BasicTurn<Real, 2>(cross<Real>(arm, force));
}
/// In space: b x R^T F (S4), exactly zero about a line through the centre on which `at` is.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> moment_of(
    const BasicSpatialState<Real>& state, const std::type_identity_t<BasicVector<Real, 3>>& at,
    const std::type_identity_t<BasicVector<Real, 3>>& /*arm*/,
    const std::type_identity_t<BasicVector<Real, 3>>& force) {
  return at.cross(rotated_back<Real>(state.orientation, force));
}

/// The rate of that moment by the turn of the body alone, as numbers in the axes of the
/// body: `force` stays as it is in the world.
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> moment_rate(const BasicState<Real>& state,
                                             const std::type_identity_t<BasicVec2<Real>>& /*at*/,
                                             const std::type_identity_t<BasicVec2<Real>>& arm,
                                             const std::type_identity_t<BasicVec2<Real>>& force) {
  return BasicTurn<Real, 2>(cross<Real>(swept(state, spin_of(state), arm), force));
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> moment_rate(
    const BasicSpatialState<Real>& state, const std::type_identity_t<BasicVector<Real, 3>>& at,
    const std::type_identity_t<BasicVector<Real, 3>>& /*arm*/,
    const std::type_identity_t<BasicVector<Real, 3>>& force) {
  return at.cross(rotated_back<Real>(state.orientation, force).cross(state.spin));
}

/// That rate as a vector of the world, written in the axes of the body (S18).
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> moment_rate_in_world(
    const BasicState<Real>& state, const std::type_identity_t<BasicVec2<Real>>& at,
    const std::type_identity_t<BasicVec2<Real>>& arm,
    const std::type_identity_t<BasicVec2<Real>>& force) {
  return moment_rate(state, at, arm, force);
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> moment_rate_in_world(
    const BasicSpatialState<Real>& state, const std::type_identity_t<BasicVector<Real, 3>>& at,
    const std::type_identity_t<BasicVector<Real, 3>>& /*arm*/,
    const std::type_identity_t<BasicVector<Real, 3>>& force) {
  return state.spin.cross(at).cross(rotated_back<Real>(state.orientation, force));
}

/// A given `moment`, in world axes, in the axes of the body.
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> in_the_body(
    const BasicState<Real>& /*state*/, const std::type_identity_t<BasicTurn<Real, 2>>& moment) {
  return moment;
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> in_the_body(
    const BasicSpatialState<Real>& state, const std::type_identity_t<BasicTurn<Real, 3>>& moment) {
  return rotated_back<Real>(state.orientation, moment);
}

// ---- the motion of one body

/// The moment that turning gives [N m]: (I spin) x spin, none in the plane (S2).
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> gyroscopic(const Real& /*inertia*/,
                                            const BasicState<Real>& /*state*/) {
  return BasicTurn<Real, 2>::Zero();
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> gyroscopic(const BasicVector<Real, 3>& inertia,
                                            const BasicSpatialState<Real>& state) {
  const BasicVector<Real, 3>& spin = state.spin;
  return {Real((inertia.y() - inertia.z()) * spin.y() * spin.z()),
          Real((inertia.z() - inertia.x()) * spin.z() * spin.x()),
          Real((inertia.x() - inertia.y()) * spin.x() * spin.y())};
}

/// A bound of the spin's acceleration by that moment [rad/s^2] (S12).
template <class Real>
[[nodiscard]] Real gyroscopic_size(const Real& /*inertia*/, const BasicState<Real>& /*state*/) {
  return Real(0);
}
/// In space.
template <class Real>
[[nodiscard]] Real gyroscopic_size(const BasicVector<Real, 3>& inertia,
                                   const BasicSpatialState<Real>& state) {
  return gyroscopic(inertia, state).cwiseQuotient(inertia).norm();
}

/// `state` after the body has turned by `step` [rad], in its own axes.
template <class Real>
[[nodiscard]] BasicState<Real> turned(BasicState<Real> state,
                                      const std::type_identity_t<BasicTurn<Real, 2>>& step) {
  state.angle += step[0];
  return state;
}
/// In space.
template <class Real>
[[nodiscard]] BasicSpatialState<Real> turned(BasicSpatialState<Real> state,
                                             const std::type_identity_t<BasicTurn<Real, 3>>& step) {
  state.orientation = product<Real>(state.orientation, quaternion_of<Real>(step)).normalized();
  return state;
}

/// The spin of a body that is at `there`, where its angular momentum is what it is at `state` and
/// `gain` more, in the axes of the body at `state`, over the inertia (S18).
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> spin_carried(
    const Real& /*inertia*/, const BasicState<Real>& state, const BasicState<Real>& /*there*/,
    const std::type_identity_t<BasicTurn<Real, 2>>& gain) {
  return spin_of(state) + gain;
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> spin_carried(
    const BasicVector<Real, 3>& inertia, const BasicSpatialState<Real>& state,
    const BasicSpatialState<Real>& there, const std::type_identity_t<BasicTurn<Real, 3>>& gain) {
  if (!has_inertia(inertia)) {
    return state.spin;
  }
  const BasicVector<Real, 3> momentum = inertia.cwiseProduct(state.spin + gain);
  return rotated_back<Real>(there.orientation, rotated<Real>(state.orientation, momentum))
      .cwiseQuotient(inertia);
}

/// How much a body in `a` is turned from `b` [rad], whole turns aside.
template <class Real>
[[nodiscard]] Real turn_between(const BasicState<Real>& a, const BasicState<Real>& b) {
  const Real turn = 2 * acos(Real(-1));
  const Real angle = a.angle - b.angle;
  return abs(Real(angle - turn * floor(Real(angle / turn + Real(0.5)))));
}
/// In space.
template <class Real>
[[nodiscard]] Real turn_between(const BasicSpatialState<Real>& a,
                                const BasicSpatialState<Real>& b) {
  return angle_between<Real>(a.orientation, b.orientation);
}

/// The angle that a moment's potential energy is of [rad]; in space a moment has none, and this is
/// zero.
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> angle_of_potential(const BasicState<Real>& state) {
  return BasicTurn<Real, 2>(state.angle);
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> angle_of_potential(const BasicSpatialState<Real>& /*state*/) {
  return BasicTurn<Real, 3>::Zero();
}

/// Angular momentum of a body about a world point [N m s], in world axes.
template <class Real>
[[nodiscard]] BasicTurn<Real, 2> angular_momentum(const Real& mass, const Real& inertia,
                                                  const BasicState<Real>& state,
                                                  const BasicVec2<Real>& about) {
  const BasicVec2<Real> from = state.position - about;
  return BasicTurn<Real, 2>(Real(mass * cross<Real>(from, state.velocity) + inertia * state.spin));
}
/// In space.
template <class Real>
[[nodiscard]] BasicTurn<Real, 3> angular_momentum(const Real& mass,
                                                  const BasicVector<Real, 3>& inertia,
                                                  const BasicSpatialState<Real>& state,
                                                  const BasicVector<Real, 3>& about) {
  return mass * (state.position - about).cross(state.velocity) +
         rotated<Real>(state.orientation, inertia.cwiseProduct(state.spin));
}

// ---- states of a body in space by the names of geometry.hpp

/// `state` standing still.
template <class Real>
[[nodiscard]] BasicSpatialState<Real> standing_still(BasicSpatialState<Real> state) {
  state.velocity.setZero();
  state.spin.setZero();
  return state;
}

/// `state` moving `part` times as fast [-].
template <class Real>
[[nodiscard]] BasicSpatialState<Real> times_as_fast(BasicSpatialState<Real> state,
                                                    const std::type_identity_t<Real>& part) {
  state.velocity *= part;
  state.spin *= part;
  return state;
}

/// `state` with `part` [-] of the jump from `before` to `after` added to its velocity and spin.
template <class Real>
[[nodiscard]] BasicSpatialState<Real> with_jump(BasicSpatialState<Real> state,
                                                const BasicSpatialState<Real>& before,
                                                const BasicSpatialState<Real>& after,
                                                const std::type_identity_t<Real>& part) {
  state.velocity += part * (after.velocity - before.velocity);
  state.spin += part * (after.spin - before.spin);
  return state;
}

/// True while the numbers of `state` and their squares fit a Real.
template <class Real>
[[nodiscard]] bool numbers_fit(const BasicState<Real>& state) {
  return isfinite(state.angle) && isfinite(state.position.squaredNorm()) &&
         isfinite(state.velocity.squaredNorm()) && isfinite(Real(state.spin * state.spin));
}
/// In space.
template <class Real>
[[nodiscard]] bool numbers_fit(const BasicSpatialState<Real>& state) {
  return isfinite(state.orientation.squaredNorm()) && isfinite(state.position.squaredNorm()) &&
         isfinite(state.velocity.squaredNorm()) && isfinite(state.spin.squaredNorm());
}

/// The state of the numbers of an arc and their rates, each `pose_numbers` of them: the velocity is
/// the position's rate; in the plane the spin is the angle's.
template <class Real, class Numbers>
[[nodiscard]] BasicState<Real> body_of(const BasicState<Real>& /*like*/, const Numbers& pose,
                                       const Numbers& rate) {
  return {{pose[0], pose[1]}, pose[2], {rate[0], rate[1]}, rate[2]};
}
/// In space the spin has columns of its own, and the quaternion is normalised.
template <class Real, class Numbers>
[[nodiscard]] BasicSpatialState<Real> body_of(const BasicSpatialState<Real>& /*like*/,
                                              const Numbers& pose, const Numbers& rate) {
  return {{pose[0], pose[1], pose[2]},
          BasicQuaternion<Real>(pose[3], pose[4], pose[5], pose[6]).normalized(),
          {rate[0], rate[1], rate[2]},
          {pose[7], pose[8], pose[9]}};
}

/// Writes the two coefficients of a body that stays where it is to its columns of an arc; false
/// where it turns, and its turn is no polynomial.
template <class Real, class Columns>
[[nodiscard]] bool write_resting(const BasicState<Real>& state, Columns&& columns) {
  columns.row(0) << state.position.x(), state.position.y(), state.angle;
  columns(1, 2) = state.spin;
  return true;
}
/// In space.
template <class Real, class Columns>
[[nodiscard]] bool write_resting(const BasicSpatialState<Real>& state, Columns&& columns) {
  columns.row(0) << state.position.transpose(), state.orientation.transpose(),
      state.spin.transpose();
  return state.spin.isZero(0);
}

/// True where a turn by the spin of `state` leaves the point `at` of the body where it is, up to
/// rounding.
template <class Real>
[[nodiscard]] bool is_along(const BasicState<Real>& state,
                            const std::type_identity_t<BasicVec2<Real>>& at) {
  return state.spin == 0 || at.isZero(0);
}
/// In space.
template <class Real>
[[nodiscard]] bool is_along(const BasicSpatialState<Real>& state,
                            const std::type_identity_t<BasicVector<Real, 3>>& at) {
  return state.spin.cross(at).norm() <=
         few_roundings * epsilon<Real>() * state.spin.norm() * at.norm();
}

/// How many freedoms to turn the directions of `arms` notice, one a row: in space one less where
/// they are on a line.
template <class Real>
[[nodiscard]] int turns_held(const Eigen::Matrix<Real, Eigen::Dynamic, 2>& arms) {
  return arms.isZero(0) ? 0 : 1;
}
/// In space.
template <class Real>
[[nodiscard]] int turns_held(const Eigen::Matrix<Real, Eigen::Dynamic, 3>& arms) {
  if (arms.isZero(0)) {
    return 0;
  }
  Eigen::Index longest = 0;
  arms.rowwise().norm().maxCoeff(&longest);
  const BasicVector<Real, 3> one = arms.row(longest);
  for (Eigen::Index i = 0; i < arms.rows(); ++i) {
    const BasicVector<Real, 3> across = one.cross(BasicVector<Real, 3>(arms.row(i)));
    if (across.norm() > few_roundings * epsilon<Real>() * one.squaredNorm()) {
      return 3;
    }
  }
  return 2;
}

/// An inertia in numbers of another type.
template <class To, class Real>
[[nodiscard]] To inertia_in(const Real& inertia) {
  return static_cast<To>(inertia);
}
/// In space.
template <class To, class Real>
[[nodiscard]] BasicVector<To, 3> inertia_in(const BasicVector<Real, 3>& inertia) {
  return inertia.unaryExpr([](const Real& number) { return static_cast<To>(number); });
}

/// `vector` in numbers of another type.
template <class To, class Real, int Rows>
[[nodiscard]] Eigen::Matrix<To, Rows, 1> converted(const Eigen::Matrix<Real, Rows, 1>& vector) {
  return vector.unaryExpr([](const Real& number) { return static_cast<To>(number); });
}

/// `state` in numbers of another type.
template <class To, class Real>
[[nodiscard]] BasicState<To> converted(const BasicState<Real>& state) {
  return {converted<To>(state.position), static_cast<To>(state.angle),
          converted<To>(state.velocity), static_cast<To>(state.spin)};
}
/// In space.
template <class To, class Real>
[[nodiscard]] BasicSpatialState<To> converted(const BasicSpatialState<Real>& state) {
  return {converted<To>(state.position), converted<To>(state.orientation),
          converted<To>(state.velocity), converted<To>(state.spin)};
}

}  // namespace tautline
