#include "tautline/plain_scheme.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "tautline/case_or_system.hpp"
#include "tautline/elastic_step.hpp"

namespace tautline {
namespace {

// A body in the plane, and systems in space.

void accelerate(const Case& the_case, const State& /*state*/, double dt, Eigen::Vector3d& rates) {
  rates.head<2>() += dt * the_case.gravity;
}
/// Without the gyroscopic term: `after` keeps the angular momentum.
void accelerate(const SpatialSystem& system, const SpatialSystemState& state, double dt,
                RowOf<SpatialSystem>& rates) {
  rates += dt * free_accelerations(system, state);
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    const Eigen::Vector3d& inertia = system.bodies[index].inertia;
    if (has_inertia(inertia)) {
      rates.segment<3>(static_cast<Eigen::Index>(6 * index + 3)) -=
          dt * gyroscopic(inertia, state.bodies[index]).cwiseQuotient(inertia);
    }
  }
}

/// Sorts the elastic cables by their zones now, and gives their impulses over `dt` [s]; no cable of
/// a case is one.
void stretch(const Case& /*the_case*/, State& /*state*/, double /*dt*/,
             std::vector<double>& impulses) {
  std::fill(impulses.begin(), impulses.end(), 0.0);
}
void stretch(const SpatialSystem& system, SpatialSystemState& state, double dt,
             std::vector<double>& impulses) {
  state = with_zones_of_step(system, std::move(state));
  impulses = elastic_impulses(system, state, dt);
}

/// The part of a gap's rate that is given: by a winch and ends that move [m/s].
double given_rate(const Cable& /*cable*/, const State& /*state*/, double /*of_bodies*/) {
  return 0.0;
}
double given_rate(const SpatialCable& cable, const SpatialSystemState& state, double of_bodies) {
  return gap_rate(cable, state) - of_bodies;
}

/// `state` a step later, moved by `way` and with the rates `there`.
State after(const Case& /*the_case*/, State state, double /*dt*/, const Eigen::Vector3d& way,
            const Eigen::Vector3d& there) {
  state.velocity = there.head<2>();
  state.spin = there[2];
  return moved(state, way);
}
/// In space a step turns a body by its spin at half the step, and keeps the angular momentum: a
/// gyroscopic term at the start of a step would spin fast bodies up.
SpatialSystemState after(const SpatialSystem& system, const SpatialSystemState& state, double dt,
                         const RowOf<SpatialSystem>& way, const RowOf<SpatialSystem>& there) {
  const RowOf<SpatialSystem> gain = there - motion_of(state);
  const auto moved_by = [&](const RowOf<SpatialSystem>& part) {
    return with_momentum(system.bodies, moved(state, part), state, gain);
  };
  SpatialSystemState result = moved_by(way + dt * (motion_of(moved_by(0.5 * way)) - there));
  result.time += dt;
  return result;
}

/// The part of the overstretch that a step takes back [-], as engines do.
constexpr double corrected = 0.2;

/// Sweeps over the cables that act. One cable takes one, cables a few degrees apart some dozens.
constexpr int most_sweeps = 60;

/// A sweep that changes the rates by less than this part of the largest has converged [-].
constexpr double converged = 1e-13;

/// A cable that acts in a step.
template <class TheCase>
struct Row {
  std::size_t cable = 0;
  RowOf<TheCase> gradient;    // of its gap
  double target = 0.0;        // [m/s], the least rate that it asks the bodies for
  double inverse_mass = 0.0;  // along it
  double overstretch = 0.0;   // [m]
};

}  // namespace

template <class TheCase>
BasicPlainScheme<TheCase>::BasicPlainScheme(TheCase the_case, Acts acts)
    : case_(std::move(the_case)),
      acts_(acts),
      state_(case_.initial),
      impulses_(case_.cables.size()) {}

template <class TheCase>
void BasicPlainScheme<TheCase>::step(double dt) {
  stretch(case_, state_, dt, impulses_);
  const RowOf<TheCase> weight = inverse_mass(bodies_of(case_));
  const RowOf<TheCase> before = motion_of(state_);
  RowOf<TheCase> velocity = before;
  accelerate(case_, state_, dt, velocity);
  std::array<Row<TheCase>, max_cables> rows;
  std::size_t count = 0;
  for (std::size_t index = 0; index < case_.cables.size(); ++index) {
    const auto& cable = case_.cables[index];
    const double room = gap(cable, state_);
    if (is_elastic(cable) || (acts_ == Acts::late && room >= 0.0)) {
      continue;
    }
    const RowOf<TheCase> row = gap_gradient(cable, state_);
    const double of_bodies = row.dot(before);
    const double given = given_rate(cable, state_, of_bodies);
    if (acts_ == Acts::early && room + dt * (row.dot(velocity) + given) >= 0.0) {
      continue;
    }
    const double rate = of_bodies + given;
    rows[count++] = {index, row, (rate < 0.0 ? restitution(cable, rate) * -rate : 0.0) - given,
                     row.dot(row.cwiseProduct(weight)), std::max(0.0, -room)};
  }
  for (int sweep = 0; sweep < most_sweeps && count > 0; ++sweep) {
    double change = 0.0;
    double largest = 0.0;
    for (std::size_t place = 0; place < count; ++place) {
      const Row<TheCase>& row = rows[place];
      const double lacking = row.target - row.gradient.dot(velocity);
      const double more = std::max(lacking / row.inverse_mass, -impulses_[row.cable]);
      impulses_[row.cable] += more;
      velocity += more * row.gradient.cwiseProduct(weight);
      change = std::max(change, more < 0.0 ? -more : more);
      largest = std::max(largest, impulses_[row.cable]);
    }
    if (count == 1 || change <= converged * largest) {
      break;
    }
  }
  // of the pose alone: as a velocity it would be a rebound
  RowOf<TheCase> way = dt * velocity;
  for (std::size_t place = 0; place < count; ++place) {
    const Row<TheCase>& row = rows[place];
    way += corrected * row.overstretch / row.inverse_mass * row.gradient.cwiseProduct(weight);
  }
  state_ = after(case_, state_, dt, way, velocity);
}

template class BasicPlainScheme<Case>;
template class BasicPlainScheme<SpatialSystem>;

}  // namespace tautline
