#include "tautline/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "error_flow.hpp"
#include "error_tracker.hpp"
#include "neighbours.hpp"
#include "simultaneous.hpp"

namespace tautline {
Uncertainty::Uncertainty(const Case& the_case, const Solution& solution,
                         const SolveOptions& options)
    : case_(&the_case), solution_(&solution), options_(options) {
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
  const auto [index, dt, periods] = solution_->place(time);
  const Arc& arc = solution_->arcs()[index];
  const State state = arc.after(dt, case_->gravity);
  Spread result = along(starts_[index], *case_, Sizes(*case_), arc,
                        basis(*case_, arc.initial, arc.taut), dt, state);
  const StateVector rate = rate_at(arc, dt, state, case_->gravity);
  const double late = periods * period_error_;              // of all of them alike
  add_late(result, tick_square(time) + late * late, rate);  // of the start of the arc
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
  State result = bounds(squares->topLeftCorner<6, 6>(), Sizes(*case_), solution_->at(time));
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

std::optional<double> Uncertainty::lock() const {
  const Event* const set = final_set(*solution_);
  if (set == nullptr || !events_.back() || unsure_.empty() || unsure_.back().from >= set->time ||
      unsure_.back().until < set->time) {
    return std::nullopt;
  }
  const double from = unsure_.back().from;
  const std::size_t arc = solution_->place(from).arc;
  if (merges_after(*case_, options_.law, *solution_, arc)) {
    return std::nullopt;
  }
  const double until = std::min(3.0 * unsure_.back().until - 2.0 * from, case_->duration);
  // of one each way both may happen to lock as the solution does: in 3 of 100 starts of the
  // standard case a rounding apart the others then lie outside, of three each way in 28 of
  // 19101211050, of five each way in none
  constexpr std::size_t pairs = 5;
  return spread_of_locks(
      *solution_, from,
      neighbours(*case_, *solution_, options_, {arc, starts_[arc], until - from, pairs}));
}

}  // namespace tautline
