#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "tautline/cable_spring.h"
#include "tautline/model_table.hpp"

// The models `cable` of Bullet and ODE share this.

namespace tautline {

/// The law of `cable`, one of `system`; of an inextensible one it has no stiffness. Throws
/// std::invalid_argument where the drop-in cable has no such law.
[[nodiscard]] inline CableElasticity drop_in_elasticity(const SpatialSystem& system,
                                                        const SpatialCable& cable) {
  CableElasticity result;
  if (cable.elasticity) {
    result.stiffness = cable.elasticity->stiffness;
    result.damping = cable.elasticity->damping;
    result.damping_ratio = cable.elasticity->damping_ratio;
  }
  if (const char* problem = result.problem()) {
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
