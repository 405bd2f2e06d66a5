#include "bench/solution/samples.hpp"
#include "bench/data/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "tautline/detail/projection.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;

Six six_of(const State& state) {
  Six result;
  result << state.position, state.angle, state.velocity, state.spin;
  return result;
}

State state_of(const Six& six) { return {six.head<2>(), six[2], six.segment<2>(3), six[5]}; }

/// A bound of what `errors` of the state do to a gap or a tension that was computed from it: those
/// of each number, times the slope.
double through(const Six& slopes, const State& errors) {
  return slopes.cwiseAbs().dot(six_of(errors));
}

/// The accelerations of the gaps of `taut` under the given tensions.
CableVector accelerations(const Case& the_case, const State& state, CableSet taut,
                          const CableVector& tensions) {
  CableVector result = delassus(the_case, state, taut) * tensions;
  Eigen::Index row = 0;
  for (const std::size_t index : taut) {
    result[row++] += free_gap_acceleration(the_case, index, state);
  }
  return result;
}

/// Bounds of the errors of the `tensions` of `taut`, one for each. An error of the state lets the
/// gaps accelerate under the old tensions; the new ones take that away. To first order.
CableVector tension_errors(const Case& the_case, const State& state, CableSet taut,
                           const CableVector& tensions, const State& errors) {
  const double length = shortest_length(the_case);
  const double acceleration = acceleration_scale(the_case, state);
  const double speed = std::max(speed_scale(the_case, state), std::sqrt(acceleration * length));
  constexpr double part = 1e-5;  // [-], of a central difference: its error is of the square
  const double turn = 1.0 / std::max(attachment_radius(the_case) / length, 1.0);
  Six steps;
  steps << length, length, turn, speed, speed, speed / length * turn;
  const Six here = six_of(state);
  const Six off = six_of(errors);
  CableVector result = CableVector::Zero(tensions.size());
  for (Eigen::Index axis = 0; axis < 6; ++axis) {
    const double step = part * steps[axis];
    if (!(step > 0.0) || off[axis] == 0.0) {
      continue;
    }
    const auto moved = [&](double by) {
      return accelerations(the_case, state_of(here + by * Six::Unit(axis)), taut, tensions);
    };
    const CableVector slope = (moved(step) - moved(-step)) / (2.0 * step);
    result += off[axis] * multipliers(the_case, state, taut, slope).cwiseAbs();
  }
  CableVector rounding(tensions.size());
  Eigen::Index row = 0;
  for (const std::size_t index : taut) {
    rounding[row++] =
        few_roundings * rounding_of_acceleration(the_case, the_case.cables[index], state);
  }
  const double rounded = multipliers(the_case, state, taut, rounding).cwiseAbs().maxCoeff();
  result.array() += rounded + few_roundings * epsilon<double>() * tensions.cwiseAbs().maxCoeff();
  return result;
}

CableSample cable_sample(const Cable& cable, const State& state, bool taut,
                         const std::optional<State>& errors) {
  if (taut) {
    return {{0.0, 0.0}, {0.0, 0.0}, {}};
  }
  CableSample result{{gap(cable, state), -1.0}, {gap_rate(cable, state), -1.0}, {}};
  if (errors) {
    const Eigen::Vector3d gradient = gap_gradient(cable, state);
    Six of_gap = Six::Zero();
    of_gap.head<3>() = gradient;
    Six of_rate;
    of_rate << gap_gradient_rate(cable, state), gradient;
    const double speed = state.velocity.norm() + std::abs(state.spin) * cable.attachment.norm();
    result.gap.error = through(of_gap, *errors) + few_roundings * rounding_of_gap(cable, state);
    result.gap_rate.error =
        through(of_rate, *errors) + few_roundings * rounding_of_direction(cable, state) * speed;
  }
  return result;
}

/// The sample of a state with its tensions, all but the time.
MotionSample sample_of(const Case& the_case, const State& state, CableSet taut,
                       const CableVector& tensions, const std::optional<State>& errors) {
  MotionSample result;
  result.state = state;
  result.errors = errors;
  result.energy.value = energy(the_case, state);
  if (errors) {
    const double mass = the_case.body.mass;
    Six slopes;
    slopes << -mass * the_case.gravity, 0.0, mass * state.velocity,
        the_case.body.inertia * state.spin;
    result.energy.error =
        through(slopes, *errors) + few_roundings * rounding_of_energy(the_case, state);
  }
  const std::vector<Bounded> pulls = bounded_tensions(the_case, state, taut, tensions, errors);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    result.cables.push_back(
        cable_sample(the_case.cables[index], state, taut.contains(index), errors));
    result.cables.back().tension = pulls[index];
  }
  return result;
}

}  // namespace

std::vector<Bounded> bounded(const State& state, const std::optional<State>& errors) {
  std::vector<Bounded> result;
  for (const auto& one : coordinates(state)) {
    result.push_back({one.value, -1.0});
  }
  if (errors) {
    auto number = result.begin();
    for (const auto& one : coordinates(*errors)) {
      (number++)->error = one.value;
    }
  }
  return result;
}

std::vector<std::string> sample_names(const Case& the_case) {
  std::vector<std::string> result;
  for (const auto& one : coordinates(the_case.initial)) {
    result.emplace_back(one.name);
  }
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    for (const char* name : {"gap", "gap rate", "tension"}) {
      result.push_back(fmt::format("{} {}", name, index));
    }
  }
  result.emplace_back("energy");
  return result;
}

std::vector<Bounded> bounded_tensions(const Case& the_case, const State& state, CableSet taut,
                                      const CableVector& tensions,
                                      const std::optional<State>& errors) {
  std::vector<Bounded> result(the_case.cables.size(), Bounded{0.0, errors ? 0.0 : -1.0});
  if (taut.empty()) {
    return result;
  }
  CableVector pulls(static_cast<Eigen::Index>(taut.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : taut) {
    pulls[row++] = tensions[static_cast<Eigen::Index>(index)];
  }
  const CableVector bounds = errors ? tension_errors(the_case, state, taut, pulls, *errors)
                                    : CableVector::Constant(pulls.size(), -1.0);
  row = 0;
  for (const std::size_t index : taut) {
    result[index] = {pulls[row], bounds[row]};
    ++row;
  }
  return result;
}

MotionSample sample_at(const Case& the_case, const Solution& solution,
                       const Uncertainty& uncertainty, double time) {
  MotionSample result = sample_of(the_case, solution.at(time), taut_at(solution, time),
                                  solution.tensions(time), uncertainty.at(time));
  result.time = {time, 0.0};
  if (const auto error = uncertainty.energy(time)) {
    result.energy.error = std::min(result.energy.error, *error);
  }
  return result;
}

MotionSample sample_at_event(const Case& the_case, const Solution& solution,
                             const Uncertainty& uncertainty, std::size_t index, Side side) {
  const Event& event = solution.events()[index];
  const auto& errors = uncertainty.events()[index];
  const bool after = side == Side::after;
  CableSet taut;
  CableVector tensions = CableVector::Zero(static_cast<Eigen::Index>(the_case.cables.size()));
  if (after) {
    taut = taut_at(solution, event.time);
    tensions = solution.tensions(event.time);
  } else {
    const auto& arcs = solution.arcs();
    const auto next =
        std::lower_bound(arcs.begin(), arcs.end(), event.time,
                         [](const Arc& arc, double time) { return arc.start < time; });
    if (next != arcs.begin()) {
      const Arc& last = *std::prev(next);
      taut = last.taut;
      tensions = solution.tensions(last, last.end - last.start);
    }
  }
  MotionSample result =
      sample_of(the_case, after ? event.after : event.before, taut, tensions,
                errors ? std::optional(after ? errors->after : errors->before) : std::nullopt);
  result.time = {event.time, errors ? errors->time : -1.0};
  return result;
}

}  // namespace tautline::bench
