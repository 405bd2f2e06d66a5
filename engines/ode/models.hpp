#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::ode {

/// `row`, `early` and `contact`: ODE's contact joint with fixed steps (fixed_step.cpp).
[[nodiscard]] std::vector<ModelEntry> fixed_step_models();

/// `event`: the event driver over ODE's integrator and solver (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::ode
