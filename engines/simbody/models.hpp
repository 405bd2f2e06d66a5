#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::simbody {

/// `rope`: Simbody's own one-sided constraint in its time-stepper; `spring`: elastic cables
/// (rope.cpp).
[[nodiscard]] std::vector<ModelEntry> rope_models();

/// `event-handler`: Simbody's integrator and its event handlers (event_handler.cpp).
[[nodiscard]] std::vector<ModelEntry> event_handler_models();

}  // namespace tautline::simbody
