#pragma once

#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline {

/// One step of `dt` [s] of an engine that changes the velocity first and then moves the body, such
/// that it flies the exact parabola: half of gravity's impulse is taken away before the step and
/// given back after it. `World` has `kick(change of velocity [m/s])` and `advance(dt)`.
template <class World>
void fly_parabola(World& world, const Vec2& gravity, double dt) {
  world.kick(-0.5 * dt * gravity);
  world.advance(dt);
  world.kick(0.5 * dt * gravity);
}

/// What a model that flies so says of it.
[[nodiscard]] inline Setting parabola_setting() {
  return {"body velocity", "half of gravity's impulse before and after each step",
          "Semi-implicit Euler then flies the exact parabola."};
}

}  // namespace tautline
