#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tautline/system_geometry.hpp"

namespace tautline {

/// Force and moment on a body of a system, as a mean over a step: of all that is given and drag
/// (`loads_in_step`), or of elastic cables (`elastic_loads`).
struct BodyLoad {
  Eigen::Vector3d force;   // [N], in world axes, without gravity
  Eigen::Vector3d moment;  // [N m], about the centre, in world axes, without what turning gives
};

/// `what` [m/s] or [rad/s] and a steady `acceleration` of it over `dt` [s]: the mean acceleration
/// that a linear drag of `rate` [1/s] adds, exactly, however long the step.
[[nodiscard]] inline Eigen::Vector3d drag_in_step(const Eigen::Vector3d& what,
                                                  const Eigen::Vector3d& acceleration,
                                                  const Eigen::Vector3d& rate, double dt) {
  Eigen::Vector3d result = Eigen::Vector3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double x = rate[axis] * dt;
    if (x > 0.0) {
      const double lost = -std::expm1(-x);  // [-]
      result[axis] = (-lost * what[axis] + (lost / x - 1.0) * dt * acceleration[axis]) / dt;
    }
  }
  return result;
}

/// Gravity in the middle of a step of `dt` [s] from `state` on [m/s^2].
[[nodiscard]] inline Eigen::Vector3d gravity_in_step(const SpatialSystem& system,
                                                     const SpatialSystemState& state, double dt) {
  return system.gravity.at(state.time + 0.5 * dt);
}

/// The load of each body in such a step: what is given as it is in its middle, and drag.
[[nodiscard]] inline std::vector<BodyLoad> loads_in_step(const SpatialSystem& system,
                                                         const SpatialSystemState& state,
                                                         double dt) {
  const double middle = state.time + 0.5 * dt;
  const Eigen::Vector3d gravity = gravity_in_step(system, state, dt);
  std::vector<BodyLoad> result;
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const SpatialBody& body = system.bodies[i];
    const SpatialState& now = state.bodies[i];
    BodyLoad load{body.force.at(middle), body.moment.at(middle)};
    const Eigen::Vector3d falling = gravity + load.force / body.mass;
    load.force += body.mass * drag_in_step(now.velocity, falling,
                                           Eigen::Vector3d::Constant(body.drag / body.mass), dt);
    if (has_inertia(body.inertia)) {
      const Eigen::Vector3d turning = in_the_body(now, load.moment).cwiseQuotient(body.inertia);
      const Eigen::Vector3d braking =
          drag_in_step(now.spin, turning, body.inertia.cwiseInverse() * body.spin_drag, dt);
      load.moment += in_the_world(now, body.inertia.cwiseProduct(braking));
    }
    result.push_back(load);
  }
  return result;
}

/// The change of the velocity of a body [m/s], or of its spin in world axes [rad/s], that gravity
/// and its load give in `dt` [s].
struct Gain {
  Eigen::Vector3d velocity;  // [m/s]
  Eigen::Vector3d spin;      // [rad/s]
};
/// The gain of `body` in `state` under `gravity` and its `load` in `dt` [s].
[[nodiscard]] inline Gain gain_in_step(const SpatialBody& body, const SpatialState& state,
                                       const Eigen::Vector3d& gravity, const BodyLoad& load,
                                       double dt) {
  Gain result{dt * (gravity + load.force / body.mass), Eigen::Vector3d::Zero()};
  if (has_inertia(body.inertia)) {
    result.spin =
        in_the_world(state, dt * in_the_body(state, load.moment).cwiseQuotient(body.inertia));
  }
  return result;
}

/// The first instant after `time` [s] at which something given is not smooth; infinite: never.
[[nodiscard]] inline double next_knot_after(const SpatialSystem& system, double time) {
  double result = std::numeric_limits<double>::infinity();
  each_function(system,
                [&](const auto& function) { result = std::min(result, function.next_knot(time)); });
  for (const SpatialCable& cable : system.cables) {
    for (const auto& change : {cable.from_time, cable.cut_at}) {
      result = change && *change > time ? std::min(result, *change) : result;
    }
  }
  return result;
}

/// A step that ends within this part of it [-] of an instant at which something given is not
/// smooth, is after it.
inline constexpr double same_instant = 1e-9;

/// Calls `step` with start and end [s] of each part of a step of `dt` [s] from `time` on: it is
/// split where something given is not smooth.
template <class Step>
void each_smooth_part(const SpatialSystem& system, double time, double dt, const Step& step) {
  const double end = time + dt;
  const double near = same_instant * dt;
  while (time < end) {
    const double knot = next_knot_after(system, time + near);
    const double until = knot < end - near ? knot : end;
    step(time, until);
    time = until;
  }
}

/// `system` as an engine that moves ends and winches evenly has it in a step of `dt` [s] from
/// `time` [s] on.
[[nodiscard]] inline SpatialSystem evenly_in_step(SpatialSystem system, double time, double dt) {
  const auto even = [&](auto& function) {
    if (!function.is_constant()) {
      const auto start = function.at(time);
      const auto rate = ((function.at(time + dt) - start) / dt).eval();
      function.pieces = {{time, {start, rate}}};
      function.waves.clear();
    }
  };
  for (SpatialCable& cable : system.cables) {
    even(cable.length);
    even(cable.from.motion);
    even(cable.to.motion);
    for (SpatialEnd& ring : cable.through) {
      even(ring.motion);
    }
  }
  return system;
}

/// Thrown where an engine cannot do a cable: "unsupported: WHAT, cable N WHY".
class CableRefused : public std::invalid_argument {
 public:
  /// Cable `index` is `what` in the engine, and `why` says that this is not enough.
  CableRefused(std::string what, std::size_t index, std::string why)
      : invalid_argument("unsupported: " + what + ", cable " + std::to_string(index) + " " + why),
        what_(std::move(what)),
        index_(index),
        why_(std::move(why)) {}

  [[nodiscard]] std::size_t index() const { return index_; }  // of the cable

  /// This refusal with another number of the cable.
  [[nodiscard]] CableRefused of(std::size_t other) const { return {what_, other, why_}; }

 private:
  std::string what_;
  std::size_t index_;
  std::string why_;
};

/// Throws CableRefused where a cable does not go straight from a body to another one, or
/// to the world: `whose` cable, such as "tautline's drop-in cable", can do no more.
inline void check_straight(const SpatialSystem& system, const std::string& whose) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const SpatialCable& cable = system.cables[index];
    if (!cable.through.empty() || cable.from.body == cable.to.body) {
      throw CableRefused(whose + " goes straight from a body to another one or to the world", index,
                         "does not");
    }
  }
}

}  // namespace tautline
