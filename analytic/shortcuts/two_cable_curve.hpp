#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "tautline/detail/rows.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// How a rigid body can be while two cables are taut. Its position and angle times the root of the
/// mass, from where it started, are a point `z` of a curve; its kinetic energy is half the square
/// of the speed there.
struct CurvePoint {
  Vector3<double> z;                    // [sqrt(kg) m]
  State pose;                           // of the body, at rest
  std::array<double, 2> gaps;           // [m]
  std::array<Vec2, 2> arms;             // of the attachments, in world axes [m]
  std::array<Vec2, 2> directions;       // from the anchors to them [-]
  std::array<Vector3<double>, 2> rows;  // gradients of the gaps by z
  Vector3<double> across;               // their cross product: along the curve

  // on the curve, by s, how far it has gone in the direction of its start [sqrt(kg) m]
  Vector3<double> way = Vector3<double>::Zero();   // dz / ds
  std::array<double, 2> bends{};                   // second derivatives of the gaps along `way`
  Vector3<double> bend = Vector3<double>::Zero();  // d^2 z / ds^2
};

/// The curve through `start` of a body on two independent cables.
class TwoCableCurve {
 public:
  TwoCableCurve(const Case& the_case, const State& start, CableSet cables)
      : cables_{&the_case.cables[*cables.begin()], &the_case.cables[*++cables.begin()]},
        origin_(start),
        weight_(root_of_inverse_mass(the_case.body)),
        scale_(std::min(shortest_length(the_case) / weight_[0], 1.0 / weight_[2])) {
    CurvePoint first = point_at(Row::Zero());
    direction_ = first.across.normalized();
    start_ = on_the_curve(first);
  }

  [[nodiscard]] const CurvePoint& start() const { return start_; }
  [[nodiscard]] const Vector3<double>& direction() const { return direction_; }  // of the start

  /// Where row . z = value, by Newton's method from about `guess`; none: not found.
  [[nodiscard]] std::optional<CurvePoint> find(const Vector3<double>& row, double value,
                                               const Vector3<double>& guess) const {
    CurvePoint point = point_at(guess);
    constexpr int enough = 8;  // each error is about the square of the one before
    for (int iteration = 0; iteration < enough; ++iteration) {
      const Row change =
          (point.gaps[0] * point.rows[1].cross(row) + point.gaps[1] * row.cross(point.rows[0]) +
           (row.dot(point.z) - value) * point.across) /
          point.across.dot(row);
      point = point_at(point.z - change);
      constexpr double half_of_digits = 1e-8;  // [-]
      if (change.norm() <= half_of_digits * scale_) {
        return on_the_curve(point);
      }
    }
    return std::nullopt;
  }

  /// At `s`, from a point near it.
  [[nodiscard]] std::optional<CurvePoint> at(double s, const CurvePoint& near) const {
    return find(direction_, s, onward(near, s - direction_.dot(near.z)));
  }

  /// Where the curve leads in `ds` from `point`, to second order.
  [[nodiscard]] static Vector3<double> onward(const CurvePoint& point, double ds) {
    return point.z + ds * (point.way + (ds / 2) * point.bend);
  }

 private:
  using Row = Vector3<double>;

  [[nodiscard]] CurvePoint point_at(const Row& z) const {
    CurvePoint point;
    point.z = z;
    point.pose.position = origin_.position + z.head<2>().cwiseProduct(weight_.head<2>());
    point.pose.angle = origin_.angle + z[2] * weight_[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const Cable& cable = *cables_[i];
      const Vec2 arm = attachment_arm(point.pose, cable);
      const Vec2 from_anchor = point.pose.position + arm - cable.anchor;
      const double distance = from_anchor.norm();
      const Vec2 u = from_anchor / distance;
      point.gaps[i] = cable.length - distance;
      point.arms[i] = arm;
      point.directions[i] = u;
      point.rows[i] = -Row(u.x(), u.y(), cross(arm, u)).cwiseProduct(weight_);
    }
    point.across = point.rows[0].cross(point.rows[1]);
    return point;
  }

  /// `point` with what is known where it is on the curve.
  [[nodiscard]] CurvePoint on_the_curve(CurvePoint point) const {
    const double per_along = 1.0 / point.across.dot(direction_);
    point.way = point.across * per_along;
    const Vec2 velocity = point.way.head<2>().cwiseProduct(weight_.head<2>());
    const double spin = point.way[2] * weight_[2];
    for (std::size_t i = 0; i < 2; ++i) {  // Eq. 5 without gravity
      const Vec2& u = point.directions[i];
      const double turn = cross<double>(u, velocity + spin * perpendicular(point.arms[i]));
      point.bends[i] = spin * spin * u.dot(point.arms[i]) - turn * turn / cables_[i]->length;
    }
    point.bend = -per_along * (point.bends[0] * point.rows[1].cross(direction_) +
                               point.bends[1] * direction_.cross(point.rows[0]));
    return point;
  }

  std::array<const Cable*, 2> cables_;
  State origin_;
  Row weight_;    // M^-1/2
  double scale_;  // of what bends the curve: a length, or a radian
  Row direction_ = Row::Zero();
  CurvePoint start_;
};

}  // namespace tautline
