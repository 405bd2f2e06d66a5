#pragma once

#include <Eigen/Geometry>

#include "tautline/system_geometry.hpp"

// A planar system in a plane of space, where it moves as in the plane.

namespace tautline::test {

/// A plane of space, and the bodies in it.
struct Plane {
  Eigen::Matrix3d axes;   // columns: x and y of the plane, and its normal
  std::size_t normal;     // the axis of the bodies along it: 0, 1, 2
  Eigen::Vector2d other;  // [-], the moments about the other two axes, in those about this one

  /// A vector of the plane in space.
  [[nodiscard]] Eigen::Vector3d vector(const Vec2& v) const { return axes.leftCols<2>() * v; }
  /// A point of a body.
  [[nodiscard]] Eigen::Vector3d of_body(const Vec2& at) const {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    result[index(1)] = at.x();
    result[index(2)] = at.y();
    return result;
  }
  [[nodiscard]] Eigen::Vector3d inertia(double about_normal) const {
    Eigen::Vector3d result;
    result[index(0)] = about_normal;
    result[index(1)] = other.x() * about_normal;
    result[index(2)] = other.y() * about_normal;
    return result;
  }
  [[nodiscard]] SpatialState state(const State& planar) const {
    Eigen::Matrix3d own;  // where the axes of the body are at angle 0
    own.col(index(0)) = axes.col(2);
    own.col(index(1)) = axes.col(0);
    own.col(index(2)) = axes.col(1);
    const Eigen::Quaterniond q(own);
    SpatialState result;
    result.position = vector(planar.position);
    result.orientation = product<double>(
        Quaternion(q.w(), q.x(), q.y(), q.z()).normalized(),
        quaternion_of<double>(Eigen::Vector3d(planar.angle * Eigen::Vector3d::Unit(index(0)))));
    result.velocity = vector(planar.velocity);
    result.spin[index(0)] = planar.spin;
    return result;
  }

  /// The axis of the body that is `next` after its normal.
  [[nodiscard]] Eigen::Index index(std::size_t next) const {
    return static_cast<Eigen::Index>((normal + next) % 3);
  }
};

/// `function` in space, of a vector of the plane.
[[nodiscard]] inline Function<3> embedded(const Function<2>& function, const Plane& plane) {
  Function<3> result;
  for (const auto& piece : function.pieces) {
    result.pieces.push_back({piece.from, {}});
    for (const Vec2& coefficient : piece.coefficients) {
      result.pieces.back().coefficients.push_back(plane.vector(coefficient));
    }
  }
  for (const auto& wave : function.waves) {
    result.waves.push_back({plane.vector(wave.amplitude), wave.frequency, wave.phase});
  }
  return result;
}

/// `system` in that plane. Its moments are left out.
[[nodiscard]] inline SpatialSystem embedded(const System& system, const Plane& plane) {
  SpatialSystem result;
  result.name = system.name;
  for (const BodyOfSystem& body : system.bodies) {
    result.bodies.push_back({body.name,
                             body.mass,
                             plane.inertia(body.inertia),
                             body.drag,
                             body.spin_drag,
                             embedded(body.force, plane),
                             {}});
  }
  const auto end = [&](const End& one) {
    return SpatialEnd{one.body, one.body ? plane.of_body(one.at) : plane.vector(one.at),
                      embedded(one.motion, plane)};
  };
  for (const CableOfSystem& cable : system.cables) {
    SpatialCable& one = result.cables.emplace_back();
    one.from = end(cable.from);
    one.to = end(cable.to);
    for (const End& ring : cable.through) {
      one.through.push_back(end(ring));
    }
    one.length = cable.length;
    one.restitution = cable.restitution;
    one.capture_speed = cable.capture_speed;
    one.restitution_table = cable.restitution_table;
    one.from_time = cable.from_time;
    one.cut_at = cable.cut_at;
  }
  result.gravity = embedded(system.gravity, plane);
  for (const State& body : system.initial.bodies) {
    result.initial.bodies.push_back(plane.state(body));
  }
  result.duration = system.duration;
  return result;
}

}  // namespace tautline::test
