#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

#include "tautline/case_or_system.hpp"
#include "tautline/clock.hpp"
#include "tautline/impulses_by_hand.hpp"
#include "tautline/system_loads.hpp"

namespace tautline {

/// The forces in the world [N] and the moments in the bodies' own axes [N m] of `loads`.
[[nodiscard]] inline RowOf<SpatialSystem> wrench_of(const std::vector<BodyLoad>& loads,
                                                    const SpatialSystemState& state) {
  RowOf<SpatialSystem> result = no_change(state);
  for (std::size_t index = 0; index < loads.size(); ++index) {
    const auto row = static_cast<Eigen::Index>(6 * index);
    result.segment<3>(row) = loads[index].force;
    result.segment<3>(row + 3) = in_the_body(state.bodies[index], loads[index].moment);
  }
  return result;
}

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

/// A cable of a system as such a row: an impulse >= 0 along `wrench` raises the gap rate.
struct SystemRow {
  /// A pull of 1 N gives each body this force in the world [-], and this moment about its centre in
  /// its own axes [m].
  RowOf<SpatialSystem> wrench;
  double gap;    // [m]
  double rate;   // [m/s], of the gap; negative when closing
  double given;  // [m/s], of `rate` what moving ends and the length give alone

  /// The force on a body [-].
  [[nodiscard]] Eigen::Vector3d force(std::size_t body) const {
    return wrench.segment<3>(static_cast<Eigen::Index>(6 * body));
  }
  /// Its moment about the centre of the body, in world axes [m].
  [[nodiscard]] Eigen::Vector3d moment(std::size_t body, const SpatialState& state) const {
    return in_the_world(state, wrench.segment<3>(static_cast<Eigen::Index>(6 * body + 3)));
  }
};

/// The row of a cable of a system at these poses; ends and length as they move `later` [s].
[[nodiscard]] inline SystemRow cable_row(const SpatialCable& cable, const SpatialSystemState& state,
                                         double later = 0.0) {
  SpatialSystemState still = standing_still(state);
  still.time += later;
  return {gap_gradient(cable, state), gap(cable, state), gap_rate(cable, state),
          gap_rate(cable, still)};
}

/// `state` at the time of `clock`, which a state in the plane does not keep: a sum of steps would
/// miss the instant at which a cable is cut.
[[nodiscard]] inline State at_time_of_step(const State& state, const Clock& /*clock*/) {
  return state;
}
/// A system's state keeps it.
[[nodiscard]] inline SpatialSystemState at_time_of_step(SpatialSystemState state,
                                                        const Clock& clock) {
  state.time = clock.now();
  return state;
}

/// The row of a cable for a step of `dt` [s].
[[nodiscard]] inline CableRow row_in_step(const Cable& cable, const State& state, double /*dt*/) {
  return cable_row(cable, state);
}
/// In a system the ends and the length move as they do at the end of the step.
[[nodiscard]] inline SystemRow row_in_step(const SpatialCable& cable,
                                           const SpatialSystemState& state, double dt) {
  return cable_row(cable, state, dt);
}

/// The rate to ask of a solver that knows the bodies alone, where the gap is to have `rate` [m/s].
[[nodiscard]] inline double rate_of_bodies(const CableRow& /*row*/, double rate) { return rate; }
/// In a system the rest comes from what moves the ends and the length.
[[nodiscard]] inline double rate_of_bodies(const SystemRow& row, double rate) {
  return rate - row.given;
}

/// The bodies that a cable of a system pulls at, each once, in the order of its ends.
[[nodiscard]] inline std::vector<std::size_t> pulled_bodies(const SpatialCable& cable) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    const std::optional<std::size_t>& body = cable.end(i).body;
    if (body && std::find(result.begin(), result.end(), *body) == result.end()) {
      result.push_back(*body);
    }
  }
  return result;
}

/// The speed of the fastest body [m/s], to measure the roundings of velocities by.
[[nodiscard]] inline double fastest(const SpatialSystemState& state) {
  double result = 0.0;
  for (const SpatialState& body : state.bodies) {
    result = std::max(result, body.velocity.norm());
  }
  return result;
}

/// When a model with fixed steps lets a cable act.
enum class Activation {
  overstretched,  // at zero gap or beyond when the step starts
  crossing,       // also where the step would take the gap through zero
};

/// Whether a cable acts in a step of `dt` [s]. Gravity in this step is left out, as engines do.
template <class Row>
[[nodiscard]] bool acts(const Row& row, Activation activation, double dt) {
  return row.gap <= 0.0 || (activation == Activation::crossing && row.gap < -row.rate * dt);
}

/// The gap rate a bounce asks for [m/s], >= 0.
template <class Row>
[[nodiscard]] double rebound_rate(const Row& row, double restitution) {
  return restitution * std::max(0.0, -row.rate);
}

/// By how much the gap rate of cable `index` changes at most in a step of `dt` [s] from `state` in
/// which it is not hit [m/s], >= 0: by gravity, and as cable and body turn. Nothing else pulls at
/// the body of a case.
[[nodiscard]] inline double change_in_step(const Case& the_case, std::size_t index,
                                           const State& state, double dt,
                                           const std::vector<BodyLoad>& /*pulls*/ = {}) {
  const Cable& cable = the_case.cables[index];
  const Eigen::Vector3d motion = motion_of(state);
  const double fallen = gap_gradient(cable, state).head<2>().dot(the_case.gravity);
  return dt * (std::abs(gap_gradient_rate(cable, state).dot(motion)) + std::abs(fallen));
}

/// In a system forces, drag, what is given over time and the `pulls` of cables that `system` does
/// not have change it, too.
[[nodiscard]] inline double change_in_step(const SpatialSystem& system, std::size_t index,
                                           const SpatialSystemState& state, double dt,
                                           const std::vector<BodyLoad>& pulls = {}) {
  const SpatialCable& cable = system.cables[index];
  const double turning = gap_gradient_rate(cable, state).dot(motion_of(state));
  double pulled = free_gap_acceleration(system, index, state) - turning;  // [m/s^2]
  if (!pulls.empty()) {
    pulled += gap_gradient(cable, state)
                  .cwiseProduct(inverse_mass(system.bodies))
                  .dot(wrench_of(pulls, state));
  }
  return dt * (std::abs(turning) + std::abs(pulled));
}

/// The gap rate that takes out `correction` [1/s] of the overstretch [m/s], at most `most` [m/s].
/// With the `change_in_step` it keeps a body in its swing, and throws none back that has hit the
/// cable: what is left of the overstretch then goes out by a move, see `out_of_overstretch`.
template <class Row>
[[nodiscard]] double push_rate(const Row& row, double correction, double most) {
  return std::min(most, correction * std::max(0.0, -row.gap));
}

/// The gap rate a model with fixed steps asks for [m/s]: the bounce, or the speed `push_rate`,
/// whichever is faster. Their sum would gain energy.
template <class Row>
[[nodiscard]] double wanted_rate(const Row& row, double restitution, double correction,
                                 double most = std::numeric_limits<double>::infinity()) {
  return std::max(rebound_rate(row, restitution), push_rate(row, correction, most));
}

/// The most cables of a case whose rows are independent [-].
template <class TheCase>
inline constexpr int rank_of = std::is_same_v<TheCase, Case> ? 3 : static_cast<int>(max_cables);

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
/// comes back fast enough by itself is left to it. `pulls` are those of the step. None where there
/// is nothing to move.
template <class TheCase>
[[nodiscard]] std::optional<StateOf<TheCase>> out_of_overstretch(
    const TheCase& the_case, const StateOf<TheCase>& state, double correction, double dt,
    const std::vector<BodyLoad>& pulls = {}) {
  CableSet holding;
  CableVector lacking(static_cast<Eigen::Index>(the_case.cables.size()));  // [m], <= 0
  Eigen::Index count = 0;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const auto row = cable_row(the_case.cables[index], state);
    if (!(row.gap <= 0.0)) {
      continue;
    }
    const double most = change_in_step(the_case, index, state, dt, pulls);
    if (row.rate >= -most) {
      const double done = std::max(most, row.rate);
      lacking[count++] = std::min(0.0, dt * (done + correction * row.gap));
      holding.insert(index);
    }
  }
  if (!(lacking.head(count).array() < 0.0).any()) {
    return std::nullopt;
  }
  const CableVector pushes = impulses_by_hand(delassus(the_case, state, holding),
                                              lacking.head(count), 0.0, rank_of<TheCase>);
  return moved(state, motion_of(with_impulses(the_case, standing_still(state), holding, pushes)));
}

}  // namespace tautline
