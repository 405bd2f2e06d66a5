#pragma once

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// The body's inertia [kg m^2], above 0 for the engines that need it so: a point mass gets its mass
/// times 1 m^2. No cable turns it, as its attachments are its centre.
[[nodiscard]] inline double turnable_inertia(const Body& body) {
  constexpr double any = 1.0;  // [m^2] times the mass
  return body.inertia > 0.0 ? body.inertia : any * body.mass;
}
/// In space the three principal ones.
[[nodiscard]] inline Eigen::Vector3d turnable_inertia(const SpatialBody& body) {
  return has_inertia(body.inertia)
             ? body.inertia
             : Eigen::Vector3d::Constant(turnable_inertia(Body{body.mass, 0.0}));
}

}  // namespace tautline
