#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "spread.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// A cable at one pose: its gap and the derivatives of it, which share sine, cosine and root.
class CableView {
 public:
  CableView() = default;
  CableView(const Cable& cable, const Vec2& position, double sine, double cosine) {
    const Vec2& p = cable.attachment;
    arm_ = {cosine * p.x() - sine * p.y(), sine * p.x() + cosine * p.y()};
    const Vec2 from_anchor = position + arm_ - cable.anchor;
    distance_ = from_anchor.norm();
    direction_ = from_anchor / distance_;
    gap_ = cable.length - distance_;
  }

  [[nodiscard]] double gap() const { return gap_; }                   // [m]
  [[nodiscard]] const Vec2& arm() const { return arm_; }              // to the attachment [m]
  [[nodiscard]] Vec2 from() const { return distance_ * direction_; }  // anchor to attachment [m]

  /// Of the attachment [m/s].
  [[nodiscard]] Vec2 velocity(const State& state) const {
    return state.velocity + state.spin * perpendicular(arm_);
  }

  /// d gap / dt [m/s].
  [[nodiscard]] double rate(const State& state) const { return -direction_.dot(velocity(state)); }

  /// d gap / d(x, y, angle).
  [[nodiscard]] Eigen::Vector3d gradient() const {
    return {-direction_.x(), -direction_.y(), -cross(arm_, direction_)};
  }

  /// The second derivatives of the gap with respect to the same.
  [[nodiscard]] Eigen::Matrix3d curvature() const {
    const Vec2 across = perpendicular(direction_);
    const Eigen::Vector3d moved(across.x(), across.y(), across.dot(perpendicular(arm_)));
    Eigen::Matrix3d result = moved * (-moved / distance_).transpose();
    result(2, 2) += direction_.dot(arm_);
    return result;
  }

  /// d gap / d state.
  [[nodiscard]] StateRow gap_row() const {
    StateRow row;
    row << gradient().transpose(), 0.0, 0.0, 0.0;
    return row;
  }

  /// d rate / d state.
  [[nodiscard]] StateRow rate_row(const State& state) const {
    const Eigen::Vector3d motion(state.velocity.x(), state.velocity.y(), state.spin);
    StateRow row;
    row << (curvature() * motion).transpose(), gradient().transpose();
    return row;
  }

 private:
  Vec2 arm_ = Vec2::Zero();        // centre of mass to attachment [m]
  Vec2 direction_ = Vec2::Zero();  // from the anchor to the attachment
  double distance_ = 0.0;          // between them [m]
  double gap_ = 0.0;               // [m]
};

using CableViews = std::array<CableView, max_cables>;

/// All cables at the pose of `state`.
[[nodiscard]] inline CableViews cable_views(const Case& the_case, const State& state) {
  const auto [cosine, sine] = heading(state.angle);
  CableViews result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    result[index] = CableView(the_case.cables[index], state.position, sine, cosine);
  }
  return result;
}

}  // namespace tautline
