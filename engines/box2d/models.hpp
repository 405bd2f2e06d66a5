#pragma once

#include <vector>

#include "tautline/model_table.hpp"

namespace tautline::box2d {

/// `distance-joint` and `distance-joint-bounce`: Box2D's b2DistanceJoint (distance_joint.cpp).
[[nodiscard]] std::vector<ModelEntry> distance_joint_models();

/// `event`: the event driver over Box2D's integrator (event.cpp).
[[nodiscard]] std::vector<ModelEntry> event_models();

}  // namespace tautline::box2d
