#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "cable_view.hpp"
#include "spread.hpp"
#include "tautline/detail/rows.hpp"

namespace tautline {

// How the acceleration of taut motion changes with the state. Each taut cable keeps the second
// derivative of (length^2 - distance^2) / 2 at zero, minus
//   from . (acceleration of the attachment) + (velocity of the attachment)^2.

/// What the body's acceleration leaves out of that [m^2/s^2].
[[nodiscard]] inline double bend(const CableView& cable, const State& state) {
  return cable.velocity(state).squaredNorm() -
         state.spin * state.spin * cable.from().dot(cable.arm());
}

/// The derivatives of the whole at a given `acceleration` of the body.
[[nodiscard]] inline StateRow bend_slopes(const CableView& cable, const State& state,
                                          const Eigen::Vector3d& acceleration) {
  const Vec2 turned = perpendicular(cable.arm());
  const Vec2 turning = acceleration[2] * turned - state.spin * state.spin * cable.arm();
  const Vec2 attachment = acceleration.head<2>() + turning;
  const Vec2 velocity = cable.velocity(state);
  const double turn = turned.dot(attachment) + cable.from().dot(perpendicular(turning)) -
                      2.0 * state.spin * velocity.dot(cable.arm());
  StateRow result;
  result << attachment.transpose(), turn, 2.0 * velocity.transpose(),
      2.0 * (velocity.dot(turned) - state.spin * cable.from().dot(cable.arm()));
  return result;
}

/// d (from, arm x from) / d pose: how a cable's force and moment turn, per force over length.
[[nodiscard]] inline Eigen::Matrix3d force_slopes(const CableView& cable) {
  Eigen::Matrix3d result = Eigen::Matrix3d::Identity();
  result.block<2, 1>(0, 2) = perpendicular(cable.arm());
  result.block<1, 2>(2, 0) = perpendicular(cable.arm()).transpose();
  result(2, 2) = cable.arm().dot(cable.arm() - cable.from());
  return result;
}

/// d acceleration / d state of motion on the independent cables `taut`, up to three, at zero gap
/// and rate (analytic/README.md, Eq. 51). Numbers times the root of the mass, as in rows.hpp.
[[nodiscard]] inline Eigen::Matrix<double, 3, 6> taut_slopes(const Case& the_case,
                                                             const State& state, CableSet taut) {
  const Eigen::Vector3d weight = root_of_inverse_mass(the_case.body);
  const CableViews views = cable_views(the_case, state);
  std::array<Vector3<double>, 3> rows{Vector3<double>::Zero(), Vector3<double>::Zero(),
                                      Vector3<double>::Zero()};
  std::size_t count = 0;
  for (const std::size_t index : taut) {
    const Vec2 from = views[index].from();
    rows[count++] =
        Eigen::Vector3d(from.x(), from.y(), cross(views[index].arm(), from)).cwiseProduct(weight);
  }
  const RowSpace<Case> space(rows, count);
  Eigen::Vector3d gravity = Eigen::Vector3d::Zero();
  gravity.head<2>() = the_case.gravity * std::sqrt(the_case.body.mass);
  Eigen::Vector3d kept = Eigen::Vector3d::Zero();  // by the cables, to keep their lengths
  std::size_t row = 0;
  for (const std::size_t index : taut) {
    kept -= space.dual(row++) * bend(views[index], state);
  }
  const Eigen::Vector3d acceleration = (space.across(gravity) + kept).cwiseProduct(weight);
  Eigen::Matrix3d turned = Eigen::Matrix3d::Zero();  // of the forces, by the pose
  Eigen::Matrix<double, 3, 6> result = Eigen::Matrix<double, 3, 6>::Zero();
  row = 0;
  for (const std::size_t index : taut) {
    const Eigen::Vector3d& dual = space.dual(row++);
    turned -= dual.dot(gravity - kept) * force_slopes(views[index]);  // pull = tension / length
    result -= dual * bend_slopes(views[index], state, acceleration);
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    result.col(axis) += space.across(turned.col(axis).cwiseProduct(weight));
  }
  return weight.asDiagonal() * result;
}

}  // namespace tautline
