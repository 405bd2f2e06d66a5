#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::bullet {

/// `row`, `early` and `row-sleeping`: a constraint row of our own; `spring`: elastic cables
/// (row.cpp).
[[nodiscard]] std::vector<ModelEntry> row_models();

/// `two-phase`: the same row, which lands first and bounces in the next step (two_phase.cpp).
[[nodiscard]] std::vector<ModelEntry> two_phase_models();

/// `contact` and `contact-tuned`: Bullet's contacts (contact.cpp).
[[nodiscard]] std::vector<ModelEntry> contact_models();

/// `bounce-limit`: a limit of Bullet's six-axis joint (bounce_limit.cpp).
[[nodiscard]] std::vector<ModelEntry> bounce_limit_models();

/// `cable` and `cable-events`: the drop-in cable of this project (cable.cpp).
[[nodiscard]] std::vector<ModelEntry> cable_models();

/// `event`: the event driver over Bullet's integrator and solver (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::bullet
