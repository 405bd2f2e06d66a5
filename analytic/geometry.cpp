#include "tautline/geometry.hpp"

#include <algorithm>
#include <cmath>

namespace tautline {

Vec2 attachment_arm(const State& state, const Cable& cable) {
  const double c = std::cos(state.angle);
  const double s = std::sin(state.angle);
  return {c * cable.attachment.x() - s * cable.attachment.y(),
          s * cable.attachment.x() + c * cable.attachment.y()};
}

Vec2 attachment_point(const State& state, const Cable& cable) {
  return state.position + attachment_arm(state, cable);
}

Vec2 attachment_velocity(const State& state, const Cable& cable) {
  return state.velocity + state.spin * perpendicular(attachment_arm(state, cable));
}

double gap(const Cable& cable, const State& state) {
  return cable.length - (attachment_point(state, cable) - cable.anchor).norm();
}

double gap_rate(const Cable& cable, const State& state) {
  const Vec2 from_anchor = attachment_point(state, cable) - cable.anchor;
  return -from_anchor.dot(attachment_velocity(state, cable)) / from_anchor.norm();
}

double free_gap_acceleration(const Case& the_case, std::size_t index, const State& state) {
  const Cable& cable = the_case.cables[index];
  const Vec2 arm = attachment_arm(state, cable);
  const Vec2 from_anchor = state.position + arm - cable.anchor;
  const double distance = from_anchor.norm();
  const Vec2 velocity = state.velocity + state.spin * perpendicular(arm);
  const Vec2 acceleration = the_case.gravity - state.spin * state.spin * arm;
  const double across = cross(from_anchor, velocity) / distance;
  return -(from_anchor.dot(acceleration) + across * across) / distance;
}

Eigen::Vector3d gap_gradient(const Cable& cable, const State& state) {
  const Vec2 arm = attachment_arm(state, cable);
  const Vec2 u = (state.position + arm - cable.anchor).normalized();
  return {-u.x(), -u.y(), -cross(arm, u)};
}

Eigen::Vector3d inverse_mass(const Body& body) {
  const double inverse_inertia = body.inertia > 0.0 ? 1.0 / body.inertia : 0.0;
  return {1.0 / body.mass, 1.0 / body.mass, inverse_inertia};
}

CableMatrix delassus(const Case& the_case, const State& state, CableSet cables) {
  const auto count = static_cast<Eigen::Index>(cables.size());
  CableMatrix jacobian(count, 3);
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    jacobian.row(row++) = gap_gradient(the_case.cables[index], state).transpose();
  }
  return jacobian * inverse_mass(the_case.body).asDiagonal() * jacobian.transpose();
}

State with_impulses(const Case& the_case, const State& state, CableSet cables,
                    const CableVector& impulses) {
  Eigen::Vector3d change = Eigen::Vector3d::Zero();
  Eigen::Index row = 0;
  for (const std::size_t index : cables) {
    change += impulses[row++] * gap_gradient(the_case.cables[index], state);
  }
  change = change.cwiseProduct(inverse_mass(the_case.body));
  State result = state;
  result.velocity += change.head<2>();
  result.spin += change[2];
  return result;
}

double energy(const Case& the_case, const State& state) {
  const Body& body = the_case.body;
  return 0.5 * body.mass * state.velocity.squaredNorm() +
         0.5 * body.inertia * state.spin * state.spin -
         body.mass * the_case.gravity.dot(state.position);
}

Vec2 momentum(const Case& the_case, const State& state) {
  return the_case.body.mass * state.velocity;
}

double angular_momentum(const Case& the_case, const State& state, const Vec2& about) {
  return the_case.body.mass * cross(state.position - about, state.velocity) +
         the_case.body.inertia * state.spin;
}

double speed_scale(const Case& the_case, const State& state) {
  double radius = 0.0;
  for (const Cable& cable : the_case.cables) {
    radius = std::max(radius, cable.attachment.norm());
  }
  return state.velocity.norm() + std::abs(state.spin) * radius;
}

}  // namespace tautline
