#include "bench/check/scheme.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "tautline/detail/flight.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

constexpr double probe_step = 1e-2;      // [s], the longest that all engines are made for
constexpr double probe_gravity = 100.0;  // [m/s^2]: g h^2 is 0.01 m, far above rounding
constexpr double probe_slack = 100.0;    // [m]

/// An engine adds some numbers up to 1 m or 1 rad for each of a few substeps.
constexpr double roundings_of_a_step = 10.0;

/// With more substeps than these a fall is told from no other, nor is a turn.
constexpr int most_parts = 64;

/// A step of a body that no cable pulls.
State probed(const Engine& engine, const std::string& model, double gravity, double spin) {
  Case the_case = bouncing_ball();
  the_case.gravity = Vec2(0.0, -gravity);
  the_case.cables.front().length = probe_slack;
  the_case.initial = {Vec2::Zero(), 0.0, Vec2::Zero(), spin};
  const auto simulation = engine.start(the_case, model, probe_step);
  simulation->step(probe_step);
  return simulation->state();
}

/// The number of parts, 1 to `most_parts`, whose `prediction` is `measured` within `tolerance`; the
/// nearest of several, none if there is none.
template <class Prediction>
std::optional<int> fitted(double measured, double tolerance, Prediction prediction) {
  std::optional<int> nearest;
  double apart = tolerance;
  for (int parts = 1; parts <= most_parts; ++parts) {
    if (std::abs(prediction(parts) - measured) <= apart) {
      apart = std::abs(prediction(parts) - measured);
      nearest = parts;
    }
  }
  return nearest;
}

/// What n substeps fall, of g h^2.
double fall_of(int substeps) { return (substeps + 1.0) / (2.0 * substeps); }

}  // namespace

std::string to_string(const Flight& flight) {
  switch (flight.scheme) {
    case Flight::Scheme::parabola:
      return "the exact parabola";
    case Flight::Scheme::position_first:
      return "semi-implicit Euler, position first";
    case Flight::Scheme::velocity_first:
      break;
  }
  return flight.substeps == 1 ? "semi-implicit Euler, velocity first"
                              : fmt::format("{} substeps of semi-implicit Euler", flight.substeps);
}

State slack_step(State state, const Vec2& gravity, double dt, const Flight& flight) {
  if (flight.scheme == Flight::Scheme::parabola) {
    return fly(state, gravity, dt);
  }
  const double fall =
      flight.scheme == Flight::Scheme::velocity_first ? fall_of(flight.substeps) : 0.0;
  state.position += dt * (state.velocity + fall * dt * gravity);
  state.velocity += dt * gravity;
  state.angle += dt * state.spin;
  return state;
}

Flight flight_of(const Engine& engine, const std::string& model, double rounding) {
  constexpr double unit = probe_gravity * probe_step * probe_step;  // [m]
  const double fallen = -probed(engine, model, probe_gravity, 0.0).position.y() / unit;
  // what falls like none of them is taken for the nearest of the three that differ most
  if (fallen <= 0.25) {
    return {Flight::Scheme::position_first};
  }
  const double tolerance = roundings_of_a_step * rounding / unit;
  if (std::abs(fallen - 0.5) <= tolerance) {
    return {Flight::Scheme::parabola};
  }
  if (const auto substeps = fitted(fallen, tolerance, fall_of)) {
    return {Flight::Scheme::velocity_first, *substeps};
  }
  return {fallen > 0.75 ? Flight::Scheme::velocity_first : Flight::Scheme::parabola};
}

Turn turn_of(const Engine& engine, const std::string& model, double rounding) {
  const double turned = probed(engine, model, 0.0, probed_turn / probe_step).angle;
  const double tolerance = roundings_of_a_step * rounding;
  Turn turn{0, probed_turn - turned};
  if (std::abs(turn.short_by) > tolerance) {
    const auto parts =
        fitted(turned, tolerance, [](int count) { return count * std::atan(probed_turn / count); });
    turn.arctangents = parts.value_or(0);
  }
  return turn;
}

}  // namespace tautline::bench
