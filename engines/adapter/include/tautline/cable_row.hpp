#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impulses_by_hand.hpp"

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

/// By how much the gap rate of cable `index` changes at most in a step of `dt` [s] from `state` in
/// which it is not hit [m/s], >= 0: by gravity, and as cable and body turn.
[[nodiscard]] inline double change_in_step(const Case& the_case, std::size_t index,
                                           const State& state, double dt) {
  const Cable& cable = the_case.cables[index];
  const Eigen::Vector3d motion(state.velocity.x(), state.velocity.y(), state.spin);
  const double fallen = gap_gradient(cable, state).head<2>().dot(the_case.gravity);
  return dt * (std::abs(gap_gradient_rate(cable, state).dot(motion)) + std::abs(fallen));
}

/// The gap rate that takes out `correction` [1/s] of the overstretch [m/s], at most `most` [m/s].
/// With the `change_in_step` it keeps a body in its swing, and throws none back that has hit the
/// cable: what is left of the overstretch then goes out by a move, see `out_of_overstretch`.
[[nodiscard]] inline double push_rate(const CableRow& row, double correction, double most) {
  return std::min(most, correction * std::max(0.0, -row.gap));
}

/// The gap rate a model with fixed steps asks for [m/s]: the bounce, or the speed `push_rate`,
/// whichever is faster. Their sum would gain energy.
[[nodiscard]] inline double wanted_rate(const CableRow& row, double restitution, double correction,
                                        double most = std::numeric_limits<double>::infinity()) {
  return std::max(rebound_rate(row, restitution), push_rate(row, correction, most));
}

/// The part of an overstretch that engines take out in one step unless told otherwise [-].
inline constexpr double usual_correction = 0.2;

/// The same part of the overstretch per second for the short last step of a run: dividing by a tiny
/// step would turn a small overstretch into a large speed [-].
[[nodiscard]] inline double correction_in_step(double dt, double usual_step) {
  return usual_correction * std::min(1.0, dt / usual_step);
}

/// `state` after its body has moved out of overstretch by what a step of `dt` [s] with `push_rate`
/// leaves of `correction` [1/s]: without a change of velocity, for that would be a rebound that
/// nobody asked for. A cable that is about to be hit takes no part, and one from which the body
/// comes back fast enough by itself is left to it. None where there is nothing to move.
[[nodiscard]] inline std::optional<State> out_of_overstretch(const Case& the_case,
                                                             const State& state, double correction,
                                                             double dt) {
  CableSet holding;
  CableVector lacking(static_cast<Eigen::Index>(the_case.cables.size()));  // [m], <= 0
  Eigen::Index count = 0;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const CableRow row = cable_row(the_case.cables[index], state);
    const double most = change_in_step(the_case, index, state, dt);
    if (row.gap <= 0.0 && row.rate >= -most) {
      const double done = std::max(most, row.rate);
      lacking[count++] = std::min(0.0, dt * (done + correction * row.gap));
      holding.insert(index);
    }
  }
  if (!(lacking.head(count).array() < 0.0).any()) {
    return std::nullopt;
  }
  const CableVector pushes =
      impulses_by_hand(delassus(the_case, state, holding), lacking.head(count), 0.0);
  const State move = with_impulses(the_case, standing_still(state), holding, pushes);
  return moved(state, Eigen::Vector3d(move.velocity.x(), move.velocity.y(), move.spin));
}

}  // namespace tautline
