#include "tautline/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "error_tracker.hpp"
#include "linearised.hpp"
#include "rounding.hpp"
#include "saltation.hpp"

namespace tautline {
namespace {

/// Terms of the derivative's series. Those of the motion fall to rounding in 28, so these to some
/// 1e-3 of the error, whose first digit is all that is said.
constexpr std::size_t flow_order = 6;

}  // namespace

StateMatrix arc_flow(const Case& the_case, const Arc& arc, double dt) {
  StateMatrix result = StateMatrix::Identity();
  if (arc.series.rows() == 0) {
    result.topRightCorner<3, 3>().diagonal().setConstant(dt);
    return result;
  }
  if (arc.series.rows() == 1) {
    return result;  // at rest
  }
  const auto series =
      flow_derivative(the_case, arc.initial, basis(the_case, arc.initial, arc.taut), flow_order);
  Eigen::Matrix<double, 3, 6> pose = Eigen::Matrix<double, 3, 6>::Zero();
  Eigen::Matrix<double, 3, 6> rate = Eigen::Matrix<double, 3, 6>::Zero();
  for (std::size_t k = series.size(); k-- > 0;) {
    rate = (rate * dt + pose).eval();
    pose = (pose * dt + series[k]).eval();
  }
  result << pose, rate;
  return result;
}

Uncertainty::Uncertainty(const Case& the_case, const Solution& solution,
                         const SolveOptions& options)
    : case_(&the_case), solution_(&solution) {
  ErrorTracker(the_case, solution, options, *this).run();
}

std::optional<double> Uncertainty::horizon() const {
  return unsure_.empty() ? std::nullopt : std::optional(unsure_.front().from);
}

/// The squares of the state's errors at `time` as one of its arc, which starts at an event.
std::optional<Uncertainty::Spread> Uncertainty::spread(double time) const {
  for (const Unsure& stretch : unsure_) {
    if (time >= stretch.from && time < stretch.until) {
      return std::nullopt;
    }
  }
  const auto& arcs = solution_->arcs();
  const auto next = std::upper_bound(arcs.begin(), arcs.end(), time,
                                     [](double t, const Arc& arc) { return t < arc.start; });
  const Arc& arc = *std::prev(next);
  const double dt = time - arc.start;
  const auto index = static_cast<std::size_t>(std::distance(arcs.begin(), next)) - 1;
  Spread result = mapped(starts_[index], arc_flow(*case_, arc, dt));
  add_errors(result, arc_rounding(*case_, arc.initial, arc.after(dt, case_->gravity), dt));
  const StateVector rate = state_rate(arc, dt, case_->gravity);
  result.topLeftCorner<6, 6>() = at_instant(result, rate);
  return result;
}

/// Where an event may be on the other side of `time`, what it changes is not sure.
void Uncertainty::add_jumps_near(double time, State& errors) const {
  const auto& events = solution_->events();
  const auto add = [&](std::size_t index) {
    const Event& event = events[index];
    if (events_[index] && std::abs(event.time - time) <= events_[index]->time) {
      errors.velocity += (event.after.velocity - event.before.velocity).cwiseAbs();
      errors.spin += std::abs(event.after.spin - event.before.spin);
    }
  };
  const auto next = std::upper_bound(events.begin(), events.end(), time,
                                     [](double t, const Event& event) { return t < event.time; });
  const auto index = static_cast<std::size_t>(std::distance(events.begin(), next));
  for (std::size_t other = index - std::min<std::size_t>(index, 2);
       other < std::min(events.size(), index + 2); ++other) {
    add(other);
  }
}

std::optional<State> Uncertainty::at(double time) const {
  const auto squares = spread(time);
  if (!squares) {
    return std::nullopt;
  }
  State result = bounds(squares->topLeftCorner<6, 6>());
  add_jumps_near(time, result);
  return result;
}

std::optional<double> Uncertainty::energy(double time) const {
  const auto squares = spread(time);
  if (!squares) {
    return std::nullopt;
  }
  const State state = solution_->at(time);
  const double mass = case_->body.mass;
  StateRow row;
  row << -mass * case_->gravity.transpose(), 0.0, mass * state.velocity.transpose(),
      case_->body.inertia * state.spin;
  const double rounding = 4 * epsilon<double>() * std::abs(tautline::energy(*case_, state));
  return bound(row, squares->topLeftCorner<6, 6>()) + rounding;
}

}  // namespace tautline
