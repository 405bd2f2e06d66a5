#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// The state `dt` [s] later in free flight: a parabola and a steady turn, in closed form (Eq. 10).
[[nodiscard]] inline State fly(const State& state, const Vec2& gravity, double dt) {
  State result = state;
  result.position += dt * state.velocity + (0.5 * dt * dt) * gravity;
  result.angle += dt * state.spin;
  result.velocity += dt * gravity;
  return result;
}

}  // namespace tautline
