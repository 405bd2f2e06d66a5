#pragma once

#include <cmath>
#include <numbers>

namespace tautline {

/// `angle` plus the whole turns that bring it nearest to `expected` [rad]: engines keep a matrix or
/// a quaternion, which know no turns. Exactly `angle` where no turn is added.
[[nodiscard]] inline double unwrap(double angle, double expected) {
  constexpr double turn = 2.0 * std::numbers::pi;
  return angle + turn * std::round((expected - angle) / turn);
}

}  // namespace tautline
