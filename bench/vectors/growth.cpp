#include "bench/vectors/growth.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

using StateColumn = Eigen::Matrix<double, 6, 1>;

/// Half of a difference of states by which the derivative of an impact is taken [-], of its size:
/// the cube root of rounding, about.
constexpr double nudge = 1e-5;

/// The derivative before an impact is taken this much earlier [-], relative to its time: more than
/// rounding, and too little to change three digits of a growth.
constexpr double just_before = 1e-9;

/// Cables that close slower than this part of the fastest are at rest in an impact [-].
constexpr double resting = 1e-9;

StateColumn column_of(const State& state) {
  StateColumn result;
  result << state.position, state.angle, state.velocity, state.spin;
  return result;
}

State moved_by(const State& state, const StateColumn& change) {
  State result = state;
  result.position += change.head<2>();
  result.angle += change[2];
  result.velocity += change.segment<2>(3);
  result.spin += change[5];
  return result;
}

/// The cables of an impact that close, with their rates; the others are taut already.
std::vector<std::pair<std::size_t, double>> closing_cables(const Case& the_case,
                                                           const Event& event) {
  const double fastest = closing_speed(the_case, event.cables, event.before);
  std::vector<std::pair<std::size_t, double>> result;
  for (const std::size_t index : event.cables) {
    const double rate = gap_rate(the_case.cables[index], event.before);
    if (rate < -resting * fastest) {
      result.emplace_back(index, rate);
    }
  }
  return result;
}

}  // namespace

Growth::Growth(const Case& the_case, const Solution& solution, ImpactLaw law)
    : case_(the_case), law_(law), radius_(gyration_radius(the_case)) {
  Directions start = Directions::Identity(6, 6);  // of size one in the metric
  start(2, 2) = start(5, 5) = radius_ > 0.0 ? 1.0 / radius_ : 0.0;
  parts_.push_back({0.0, start, Sensitivity(the_case, solution, law)});
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      pass(event);
    }
  }
}

/// Starts a part at an impact that hits several cables from free flight.
void Growth::pass(const Event& event) {
  const auto closing = closing_cables(case_, event);
  if (closing.size() < 2 || closing.size() != event.cables.size()) {
    return;
  }
  const Directions before = carried(event.time * (1.0 - just_before));
  if (!before.allFinite()) {
    return;
  }
  // the neighbours that come to all of the cables after the same delay
  Eigen::MatrixXd parted(static_cast<Eigen::Index>(closing.size()) - 1, before.cols());
  const auto delays = [&](std::size_t place) -> Eigen::RowVectorXd {
    const auto& [index, rate] = closing[place];
    return gap_gradient(case_.cables[index], event.before).transpose() * before.topRows<3>() / rate;
  };
  for (std::size_t place = 1; place < closing.size(); ++place) {
    parted.row(static_cast<Eigen::Index>(place) - 1) = delays(place) - delays(0);
  }
  Eigen::FullPivLU<Eigen::MatrixXd> apart(parted);
  apart.setThreshold(resting);
  if (apart.dimensionOfKernel() == 0) {
    return;
  }
  const Eigen::MatrixXd together =
      apart.kernel().householderQr().householderQ() *
      Eigen::MatrixXd::Identity(before.cols(), apart.dimensionOfKernel());
  Case rest = case_;
  rest.initial = event.after;
  rest.duration = case_.duration - event.time;
  if (!(rest.duration > 0.0) || !problems(rest).empty()) {
    return;
  }
  SolveOptions options;
  options.law = law_;
  parts_.push_back({event.time, after_impact(event, before * together),
                    Sensitivity(rest, solve(rest, options), law_)});
}

/// Each column after the impact of `event`, by central differences; both sides fly to the instant
/// at which the gaps are zero and back.
Growth::Directions Growth::after_impact(const Event& event, const Directions& before) const {
  const auto first = closing_cables(case_, event).front();
  Directions result(6, before.cols());
  for (Eigen::Index column = 0; column < before.cols(); ++column) {
    const StateColumn change =
        nudge / std::max(1e-300, before.col(column).norm()) * StateColumn(before.col(column));
    StateColumn sum = StateColumn::Zero();
    for (const double side : {1.0, -1.0}) {
      const double delay =
          -side * gap_gradient(case_.cables[first.first], event.before).dot(change.head<3>()) /
          first.second;
      const State at_impact = fly(moved_by(event.before, side * change), case_.gravity, delay);
      const State after = resolve_impact(law_, case_, at_impact, event.cables).after;
      sum += side * column_of(fly(after, case_.gravity, -delay));
    }
    result.col(column) = sum / (2.0 * nudge) * before.col(column).norm();
  }
  return result;
}

/// The derivative of the state at `time` by the differences that are followed there.
Growth::Directions Growth::carried(double time) const {
  const auto next = std::upper_bound(parts_.begin(), parts_.end(), time,
                                     [](double t, const Part& part) { return t < part.start; });
  const Part& part = *std::prev(next);
  const double end = case_.duration - part.start;  // rounding may put a time behind it
  return part.sensitivity.at(std::min(time - part.start, end)) * part.derivative;
}

double Growth::size(Directions derivative) const {
  if (!derivative.allFinite()) {
    return std::numeric_limits<double>::infinity();
  }
  derivative.row(2) *= radius_;
  derivative.row(5) *= radius_;
  return Eigen::JacobiSVD<Directions>(derivative).singularValues()[0];
}

double Growth::at(double time) const { return size(carried(time)); }

}  // namespace tautline::bench
