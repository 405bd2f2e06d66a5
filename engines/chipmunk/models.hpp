#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::chipmunk {

/// `row` and `early`: a constraint of our own in the space's steps (row.cpp).
[[nodiscard]] std::vector<ModelEntry> row_models();

/// `slide-joint` and `slide-joint-bounce`: Chipmunk's cpSlideJoint (slide_joint.cpp).
[[nodiscard]] std::vector<ModelEntry> slide_joint_models();

/// `event`: the event driver over Chipmunk's integrator and solver (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::chipmunk
