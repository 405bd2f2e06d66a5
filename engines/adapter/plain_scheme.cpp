#include "tautline/plain_scheme.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// The part of the overstretch that a step takes back [-], as engines do.
constexpr double corrected = 0.2;

/// Sweeps over the cables that act. One cable takes one, cables a few degrees apart some dozens.
constexpr int most_sweeps = 60;

/// A sweep that changes the rates by less than this part of the largest has converged [-].
constexpr double converged = 1e-13;

/// A cable that acts in a step.
struct Row {
  std::size_t cable = 0;
  Eigen::Vector3d gradient;   // of its gap
  double target = 0.0;        // [m/s], the least rate that it asks for
  double inverse_mass = 0.0;  // along it
  double overstretch = 0.0;   // [m]
};

}  // namespace

PlainScheme::PlainScheme(Case the_case, Acts acts)
    : case_(std::move(the_case)),
      acts_(acts),
      state_(case_.initial),
      impulses_(case_.cables.size()) {}

void PlainScheme::step(double dt) {
  const Eigen::Vector3d weight = inverse_mass(case_.body);
  const Eigen::Vector3d before(state_.velocity.x(), state_.velocity.y(), state_.spin);
  Eigen::Vector3d velocity = before;
  velocity.head<2>() += dt * case_.gravity;
  std::array<Row, max_cables> rows;
  std::size_t count = 0;
  for (std::size_t index = 0; index < case_.cables.size(); ++index) {
    const Cable& cable = case_.cables[index];
    const double room = gap(cable, state_);
    if (acts_ == Acts::late && room >= 0.0) {
      continue;
    }
    const Eigen::Vector3d row = gap_gradient(cable, state_);
    if (acts_ == Acts::early && room + dt * row.dot(velocity) >= 0.0) {
      continue;
    }
    const double rate = row.dot(before);
    rows[count++] = {index, row, rate < 0.0 ? restitution(cable, rate) * -rate : 0.0,
                     row.dot(row.cwiseProduct(weight)), std::max(0.0, -room)};
  }
  std::fill(impulses_.begin(), impulses_.end(), 0.0);
  for (int sweep = 0; sweep < most_sweeps && count > 0; ++sweep) {
    double change = 0.0;
    double largest = 0.0;
    for (std::size_t place = 0; place < count; ++place) {
      const Row& row = rows[place];
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
  state_.velocity = velocity.head<2>();
  state_.spin = velocity[2];
  // of the pose alone: as a velocity it would be a rebound
  Eigen::Vector3d way = dt * velocity;
  for (std::size_t place = 0; place < count; ++place) {
    const Row& row = rows[place];
    way += corrected * row.overstretch / row.inverse_mass * row.gradient.cwiseProduct(weight);
  }
  state_ = moved(state_, way);
}

}  // namespace tautline
