#pragma once

#include <algorithm>

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// One cable at one pose, as a one-sided constraint row of an engine sees it: an impulse >= 0 along
/// `towards`, at `point`, that raises the gap rate.
struct CableRow {
  Vec2 point;     // [m], the attachment in the world
  Vec2 towards;   // [-], unit vector from the attachment to the anchor
  double moment;  // [m], arm x towards: the row's entry for the angle
  double gap;     // [m]
  double rate;    // [m/s], of the gap; negative when closing
};

/// The row of a cable at this pose.
[[nodiscard]] inline CableRow cable_row(const Cable& cable, const State& state) {
  const Eigen::Vector3d gradient = gap_gradient(cable, state);
  return {attachment_point(state, cable), gradient.head<2>(), gradient[2], gap(cable, state),
          gap_rate(cable, state)};
}

/// When a model with fixed steps lets a cable act.
enum class Activation {
  overstretched,  // at zero gap or beyond when the step starts
  crossing,       // also where the step would take the gap through zero
};

/// Whether a cable acts in a step of `dt` [s]. Gravity in this step is left out, as engines do.
[[nodiscard]] inline bool acts(const CableRow& row, Activation activation, double dt) {
  return row.gap <= 0.0 || (activation == Activation::crossing && row.gap < -row.rate * dt);
}

/// The gap rate a bounce asks for [m/s], >= 0.
[[nodiscard]] inline double rebound_rate(const CableRow& row, double restitution) {
  return restitution * std::max(0.0, -row.rate);
}

/// The gap rate a model with fixed steps asks for [m/s]: the bounce, or the speed that takes out
/// `correction` [1/s] of the overstretch, whichever is faster. Their sum would gain energy.
[[nodiscard]] inline double wanted_rate(const CableRow& row, double restitution,
                                        double correction) {
  return std::max(rebound_rate(row, restitution), correction * std::max(0.0, -row.gap));
}

/// The part of an overstretch that engines take out in one step unless told otherwise [-].
inline constexpr double usual_correction = 0.2;

/// The same part of the overstretch per second for the short last step of a run: dividing by a tiny
/// step would turn a small overstretch into a large speed [-].
[[nodiscard]] inline double correction_in_step(double dt, double usual_step) {
  return usual_correction * std::min(1.0, dt / usual_step);
}

}  // namespace tautline
