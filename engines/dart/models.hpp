#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::dart_engine {

/// `row` and `early`: a constraint of our own in the world's steps; `spring`: elastic cables
/// (row.cpp).
[[nodiscard]] std::vector<ModelEntry> row_models();

/// `event`: the event driver over DART's integrator and solver (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::dart_engine
