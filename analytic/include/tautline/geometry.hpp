#pragma once

#include <Eigen/Core>

#include "tautline/case.hpp"

namespace tautline {

// Equation numbers are those of analytic/README.md.

/// The attachment relative to the centre of mass, in world axes [m].
[[nodiscard]] Vec2 attachment_arm(const State& state, const Cable& cable);

/// The body's attachment point in the world [m] (Eq. 1).
[[nodiscard]] Vec2 attachment_point(const State& state, const Cable& cable);

/// The velocity of that point [m/s] (Eq. 2).
[[nodiscard]] Vec2 attachment_velocity(const State& state, const Cable& cable);

/// Length minus distance [m]; admissible when >= 0 (Eq. 3).
[[nodiscard]] double gap(const Cable& cable, const State& state);

/// d gap / dt [m/s]; negative when closing (Eq. 4).
[[nodiscard]] double gap_rate(const Cable& cable, const State& state);

/// d^2 gap / dt^2 in free flight [m/s^2] (Eq. 5); negative when gravity closes the cable.
[[nodiscard]] double free_gap_acceleration(const Case& the_case, std::size_t index,
                                           const State& state);

/// d gap / d(x, y, angle) [-, -, m]: the row of the constraint Jacobian (Eq. 6).
/// Requires distance > 0.
[[nodiscard]] Eigen::Vector3d gap_gradient(const Cable& cable, const State& state);

/// Diagonal of the inverse mass matrix for (x, y, angle) [1/kg, 1/kg, 1/(kg m^2)].
/// A point mass does not turn: its third entry is 0.
[[nodiscard]] Eigen::Vector3d inverse_mass(const Body& body);

/// J M^-1 J^T over `cables`, in rising index order, symmetric positive semidefinite (Eq. 7).
[[nodiscard]] CableMatrix delassus(const Case& the_case, const State& state, CableSet cables);

/// Applies `impulses` [N s], one per cable of `cables`, at the state's pose (Eq. 8).
[[nodiscard]] State with_impulses(const Case& the_case, const State& state, CableSet cables,
                                  const CableVector& impulses);

/// Kinetic plus potential energy [J]; zero potential at the origin of the world (Eq. 9).
[[nodiscard]] double energy(const Case& the_case, const State& state);

/// Linear momentum [N s].
[[nodiscard]] Vec2 momentum(const Case& the_case, const State& state);

/// Angular momentum about a world point [N m s].
[[nodiscard]] double angular_momentum(const Case& the_case, const State& state, const Vec2& about);

/// A bound of the speeds of the body's attachment points [m/s].
[[nodiscard]] double speed_scale(const Case& the_case, const State& state);

/// Scalar cross product a x b.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// `v` turned by +90 degrees.
[[nodiscard]] inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace tautline
