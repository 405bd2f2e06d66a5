#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "tautline/cable_spring.h"
#include "tautline/model_table.hpp"

// The models `cable` of Bullet and ODE share this.

namespace tautline {

/// The first thing of `cable` that the drop-in cable has not, as the rest of a sentence; null:
/// none.
[[nodiscard]] inline const char* missing_in_drop_in(const SpatialCable& cable) {
  const Elasticity& law = *cable.elasticity;
  if (!law.corners.empty()) {
    return "it takes no corners, but a polynomial";
  }
  if (law.of_strain && !cable.length.is_constant()) {
    return "it takes an EA only of a length that does not vary";
  }
  return law.cut == ElasticCut::force ? nullptr : "it takes no other cut than force";
}

/// The law of `cable`, one of `system`; of an inextensible one it has no stiffness. Throws
/// std::invalid_argument where the drop-in cable has no such law.
[[nodiscard]] inline CableElasticity drop_in_elasticity(const SpatialSystem& system,
                                                        const SpatialCable& cable) {
  CableElasticity result;
  const char* problem = nullptr;
  if (cable.elasticity) {
    result.stiffness = cable.elasticity->stiffness;
    result.damping = cable.elasticity->damping;
    result.damping_ratio = cable.elasticity->damping_ratio;
    double scale = 1.0;
    for (double& coefficient : result.stiffness) {  // of the stretch: EA / L, EA2 / L^2, ...
      scale *= cable.elasticity->of_strain ? cable.length.at(0.0)[0] : 1.0;
      coefficient /= scale;
    }
    problem = missing_in_drop_in(cable);
  }
  if (problem == nullptr) {
    problem = result.problem();
  }
  if (problem != nullptr) {
    const auto index = static_cast<std::size_t>(&cable - system.cables.data());
    throw std::invalid_argument("unsupported: cable " + std::to_string(index) +
                                " as tautline's drop-in cable: " + problem);
  }
  return result;
}

/// The settings of elastic cables, made by `function` of the drop-in cable.
[[nodiscard]] inline std::vector<Setting> elastic_drop_in_settings(const std::string& function) {
  return {{function, "the cable's stiffness and damping, of an elastic cable",
           "It stretches by an implicit step of its law."}};
}

}  // namespace tautline
