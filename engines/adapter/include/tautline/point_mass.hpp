#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// The body's inertia [kg m^2], above 0 for the engines that need it so: a point mass gets its mass
/// times 1 m^2. No cable turns it, as its attachments are its centre.
[[nodiscard]] inline double turnable_inertia(const Body& body) {
  constexpr double any = 1.0;  // [m^2] times the mass
  return body.inertia > 0.0 ? body.inertia : any * body.mass;
}

}  // namespace tautline
