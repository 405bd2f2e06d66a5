#pragma once

#include <utility>

#include "tautline/case.hpp"
#include "tautline/multiprecision.hpp"

namespace tautline::bench {

[[nodiscard]] inline BasicVec2<Multi> in_digits(const Vec2& value) { return value.cast<Multi>(); }

[[nodiscard]] inline BasicState<Multi> in_digits(const State& state) {
  return {in_digits(state.position), state.angle, in_digits(state.velocity), state.spin};
}

/// The same case, its numbers the doubles that they are.
[[nodiscard]] inline BasicCase<Multi> in_digits(const Case& the_case) {
  BasicCase<Multi> result;
  result.name = the_case.name;
  result.body = {the_case.body.mass, the_case.body.inertia};
  for (const Cable& cable : the_case.cables) {
    BasicCable<Multi> same{in_digits(cable.anchor), in_digits(cable.attachment), cable.length,
                           cable.restitution,       cable.capture_speed,         {}};
    for (const RestitutionPoint& point : cable.restitution_table) {
      same.restitution_table.push_back({point.speed, point.restitution});
    }
    result.cables.push_back(std::move(same));
  }
  result.gravity = in_digits(the_case.gravity);
  result.initial = in_digits(the_case.initial);
  result.duration = the_case.duration;
  if (the_case.angle_limit) {
    result.angle_limit = Multi(*the_case.angle_limit);
  }
  if (the_case.ceiling) {
    result.ceiling = Multi(*the_case.ceiling);
  }
  return result;
}

}  // namespace tautline::bench
