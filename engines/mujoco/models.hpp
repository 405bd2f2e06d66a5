#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::mujoco {

/// `tendon-limit` and `tendon-limit-rk4`: MuJoCo's limit of a tendon's length (tendon_limit.cpp).
[[nodiscard]] std::vector<ModelEntry> tendon_limit_models();

/// `impulse`: impulses by hand between MuJoCo's steps; `spring`: elastic cables (impulse.cpp).
[[nodiscard]] std::vector<ModelEntry> impulse_models();

/// `event`: the event driver over MuJoCo's integrator, Jacobian and mass matrix (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::mujoco
