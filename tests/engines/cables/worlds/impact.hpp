// How an impact looks from outside, in a step that has one.

#pragma once

#include <optional>

#include "engines/cables/worlds/ledger.hpp"

namespace tautline::test {

struct SeenImpact {
  double closing;  // [m/s]
  double ratio;    // rate after / closing: the restitution that was seen [-]
};

/// In a fixed step: the rates before and after the step, on the line before it. The hook's velocity
/// is that of the step itself.
[[nodiscard]] SeenImpact fixed_impact(const CableData& cable, const Moment& before,
                                      const Moment& after);

/// By events: the ends' flight from `before` to the instant at which the cable is taut, computed
/// here, and the impulse of the step. None if the flight does not make the cable taut, or
/// if a load turns so far in the step that the first instant is not to be told, or if the rebound
/// is so slow that the cable may be taut, and pull, again in the same step. `downwards` is gravity
/// [m/s^2].
[[nodiscard]] std::optional<SeenImpact> event_impact(const CableData& cable, const Moment& before,
                                                     const Moment& after, double impulse, double dt,
                                                     double downwards);

}  // namespace tautline::test
