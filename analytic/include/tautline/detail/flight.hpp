#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// The state `dt` [s] later in free flight: a parabola and a steady turn, in closed form (Eq. 10).
template <class Real>
[[nodiscard]] BasicState<Real> fly(const BasicState<Real>& state, const BasicVec2<Real>& gravity,
                                   const std::type_identity_t<Real>& dt) {
  const Real half_square = dt * dt / 2;
  BasicState<Real> result = state;
  result.position += dt * state.velocity + half_square * gravity;
  result.angle += dt * state.spin;
  result.velocity += dt * gravity;
  return result;
}

}  // namespace tautline
