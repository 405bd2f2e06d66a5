#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::siconos_engine {

/// `moreau-jean` and `moreau-jean-projected`: Siconos' time-stepping; `spring`: elastic cables
/// (moreau_jean.cpp).
[[nodiscard]] std::vector<ModelEntry> moreau_jean_models();

/// `event-driven`: Siconos' own location of events (event_driven.cpp).
[[nodiscard]] std::vector<ModelEntry> event_driven_models();

}  // namespace tautline::siconos_engine
