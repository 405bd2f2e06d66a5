#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::ode {

/// `row`, `early` and `contact`: ODE's contact joint with fixed steps; `spring`: elastic cables
/// (fixed_step.cpp).
[[nodiscard]] std::vector<ModelEntry> fixed_step_models();

/// `cable` and `cable-events`: the drop-in cable of this project (cable.cpp).
[[nodiscard]] std::vector<ModelEntry> cable_models();

/// `event`: the event driver over ODE's integrator and solver (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::ode
