#include "error_tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "error_flow.hpp"
#include "simultaneous.hpp"
#include "tangent.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

ErrorTracker::ErrorTracker(const Case& the_case, const Solution& solution,
                           const SolveOptions& options, Uncertainty& result)
    : case_(the_case), solution_(solution), options_(options), result_(result), sizes_(the_case) {}

void ErrorTracker::run() {
  result_.events_.resize(solution_.events().size());
  result_.starts_.reserve(solution_.arcs().size());
  arrived_.reserve(solution_.arcs().size());
  if (const CableSet dead = dead_at_start(case_); !dead.empty()) {
    tie_ = Tie{EventKind::taut, dead};
    lose(0.0);
  }
  for (std::size_t index = 0; index < solution_.arcs().size(); ++index) {
    const Arc& arc = solution_.arcs()[index];
    start_events(index);
    result_.starts_.push_back(now_);
    arrived_.push_back(next_);
    if (!lost_ && arc.end > arc.start) {
      follow(index);
    }
    before_ = &arc;
  }
  if (solution_.repetition() && !lost_) {
    repeat(*solution_.repetition());
  }
}

/// Takes the events at the start of an arc: an impact, and what follows from it at once.
void ErrorTracker::start_events(std::size_t arc) {
  const auto& arcs = solution_.arcs();
  const auto& events = solution_.events();
  const bool pause = arc + 1 < arcs.size() && !(arcs[arc + 1].start > arcs[arc].start);
  bool impacts = false;
  for (bool first = true; next_ < events.size() && events[next_].time <= arcs[arc].start;
       first = false) {
    if (events[next_].kind == EventKind::impact && pause && impacts) {
      return;  // of the next arc
    }
    impacts = impacts || events[next_].kind == EventKind::impact;
    take(events[next_], first && before_ != nullptr && before_->end > before_->start);
    met_ = met_ | events[next_].cables;
    ++next_;
  }
}

/// Carries the errors over `event`; `arrives` where it ends an arc.
void ErrorTracker::take(const Event& event, bool arrives) {
  const CableSet hit = event.kind == EventKind::impact ? event.cables - taut_ : CableSet{};
  if (!lost_ && arrives && hit.empty() && event.kind == EventKind::slack && !release(event)) {
    lose_near(event.before, before_->start);  // along the arcs before, no tension touches zero
  }
  if (!lost_ && arrives && !hit.empty() && !arrive(event, hit)) {
    lose(last_event());
  }
  if (!lost_ && !(event.time > 0.0) && event.kind == EventKind::impact && !start(event)) {
    lose(last_event());
  }
  if (lost_) {
    taut_ = taut_after(event, taut_);
    if (meeting_ && meeting_->event == next_) {
      meet(event);
    }
    return;
  }
  const EventErrors errors = event.kind == EventKind::impact ? take_impact(event)
                             : event.kind == EventKind::taut ? take_taut(event)
                                                             : take_slack(event);
  if (!is_sure()) {
    lose(last_event());
    return;
  }
  result_.events_[next_] = errors;
}

/// True while errors are small against the system.
bool ErrorTracker::is_sure() const {
  const double part = largest_part / bound_margin;  // of squares
  const double place = part * sizes_.shortest;
  return std::isfinite(now_.trace()) && now_(0, 0) <= place * place &&
         now_(1, 1) <= place * place && (!sizes_.turns || now_(2, 2) <= part * part);
}

EventErrors ErrorTracker::take_taut(const Event& event) {
  EventErrors errors{bound(now_(6, 6)),
                     0.0,
                     CableVector::Zero(event.impulses.size()),
                     bounds(now_.topLeftCorner<6, 6>(), sizes_, event.before),
                     {}};
  close(event, event.cables);
  taut_ = taut_ | event.cables;
  now_ = projected(now_, tangent(case_, event.after, basis(case_, event.after, taut_)));
  if (const Accumulation* const accumulation = completed_by(event)) {
    // what the limit lies after the event is as wrong as the last bounce is long
    const double last =
        before_ != nullptr ? event.time - before_->start : 0.0;  // none at the start
    const double remaining = accumulation->time - accumulation->start;
    const double relative = last > 0.0 ? errors.time / last : 0.0;
    errors.time += accumulation->uncertainty + remaining * std::min(relative, 1.0);
  }
  StateVector rounding = arc_rounding(sizes_, event.before, event.after, 0.0);
  const double completed = options_.completion.error * sizes_.speed(event.after);
  rounding.tail<3>().array() += completed;
  add_errors(now_, rounding);
  errors.after = bounds(now_.topLeftCorner<6, 6>(), sizes_, event.after);
  return errors;
}

/// The accumulation that `event` completes, or null.
const Accumulation* ErrorTracker::completed_by(const Event& event) {
  const auto& all = solution_.accumulations();
  while (accumulation_ < all.size() && all[accumulation_].start < event.time) {
    ++accumulation_;
  }
  const bool completes = accumulation_ < all.size() && all[accumulation_].start == event.time &&
                         all[accumulation_].cables == event.cables;
  return completes ? &all[accumulation_] : nullptr;
}

EventErrors ErrorTracker::take_slack(const Event& event) {
  taut_ = taut_ - event.cables;
  const State same = bounds(now_.topLeftCorner<6, 6>(), sizes_, event.after);
  return {bound(now_(6, 6)), 0.0, CableVector::Zero(event.impulses.size()), same, same};
}

/// Carries the errors along the arc of this index.
void ErrorTracker::follow(std::size_t index) {
  const auto& arcs = solution_.arcs();
  const auto& events = solution_.events();
  const Arc& arc = arcs[index];
  const double dt = arc.end - arc.start;
  // the state at its end, which the solution has
  const State last = next_ < events.size() && events[next_].time <= arc.end ? events[next_].before
                     : index + 1 < arcs.size() ? arcs[index + 1].initial
                                               : arc.after(dt, case_.gravity);
  const bool goes_on = before_ != nullptr && followed_ == before_ && before_->taut == arc.taut;
  if (!arc.taut.empty() && !goes_on) {
    basis_ = basis(case_, arc.initial, arc.taut);
  }
  followed_ = &arc;
  if (!arc.taut.empty() && !releases_are_sure(index)) {
    lose(arc.start);
    return;
  }
  now_ = along(now_, case_, sizes_, arc, basis_, dt, last);
  if (!arc.taut.empty()) {
    add_late(now_, late_at_end(index), rate_at(arc, dt, last, case_.gravity));
  }
  fastest_ = std::max({fastest_, sizes_.speed(arc.initial), sizes_.speed(last)});
  if (!is_sure()) {
    lose_near(last, arc.start);  // where they still were
  }
}

/// The square of what the instants of this taut arc add to how late a state is [s^2]: their
/// rounding; in the period of a motion that repeats the error of that period.
double ErrorTracker::late_at_end(std::size_t index) {
  const auto& again = solution_.repetition();
  if (!again || index < again->first) {
    return tick_square(solution_.arcs()[index].end);
  }
  if (!period_error_) {
    period_error_ = period_error(*again);
  }
  return *period_error_ * *period_error_ /
         static_cast<double>(solution_.arcs().size() - again->first);
}

/// By how much the arcs of a period are off it [s], the root of the square, for their own rounding.
double ErrorTracker::period_error(const Repetition& again) const {
  const auto& arcs = solution_.arcs();
  const State& start = arcs[again.first].initial;
  // a swing turns there and once more after half of its arcs, which are those of the other half
  const std::size_t half = (arcs.size() - again.first) / 2;
  const double still = 1e-8 * fastest_ * fastest_ * case_.body.mass;
  const Body moved{case_.body.mass, is_point_mass(case_) ? 0.0 : case_.body.inertia};
  const bool turns_back = kinetic_energy(moved, start) <= still;
  Spread own = Spread::Zero();
  for (std::size_t k = again.first + (turns_back ? half : 0); k < arcs.size(); ++k) {
    const State& last = k + 1 < arcs.size() ? arcs[k + 1].initial : start;
    own = along(own, case_, sizes_, arcs[k], basis_, arcs[k].end - arcs[k].start, last);
  }
  const StateVector rate = rate_at(arcs[again.first], 0.0, start, case_.gravity);
  const StateVector weighted = along_motion(again.period).cwiseProduct(rate);
  const double square = weighted.dot(own.topLeftCorner<6, 6>() * weighted);
  const double late = std::sqrt(std::max(square, 0.0)) / weighted.dot(rate);
  return Vec2((turns_back ? 2.0 : 1.0) * late, one_rounding * again.period).norm();
}

/// The weights that compare changes of a state with those of a time: of masses and, for rates, of
/// `time` [s].
StateVector ErrorTracker::along_motion(double time) const {
  const double inertia = is_point_mass(case_) ? 0.0 : case_.body.inertia;  // its turn does nothing
  StateVector weights;
  weights << case_.body.mass, case_.body.mass, inertia, Eigen::Vector3d::Zero();
  weights.tail<3>() = time * time * weights.head<3>();
  return weights;
}

/// By how much a period is off for the error of the energy [s], the root of the square: the motion
/// is one of a family that differ in energy, and so in their period.
double ErrorTracker::period_drift(const Repetition& again) const {
  const auto& arcs = solution_.arcs();
  const auto energy_at = [&](std::size_t arc) {
    return kinetic_energy(case_.body, arcs[arc].initial);
  };
  std::size_t fastest = again.first;
  for (std::size_t arc = again.first; arc < arcs.size(); ++arc) {
    fastest = energy_at(arc) > energy_at(fastest) ? arc : fastest;
  }
  const State& state = arcs[fastest].initial;
  const Vec2 momentum = case_.body.mass * state.velocity;
  const double spin = is_point_mass(case_) ? 0.0 : state.spin;
  StateRow energy;
  energy << -case_.body.mass * case_.gravity.transpose(), 0.0, momentum.transpose(),
      case_.body.inertia * spin;
  // a neighbour that has 1 J more there, one period later
  StateVector faster = StateVector::Zero();
  faster.tail<3>() << state.velocity, spin;
  faster /= energy * faster;
  Spread squares = Spread::Zero();
  squares.topLeftCorner<6, 6>() = faster * faster.transpose();
  const std::size_t count = arcs.size() - again.first;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = [&](std::size_t later) {
      return again.first + (fastest - again.first + later) % count;
    };
    const Arc& arc = arcs[at(k)];
    squares =
        along(squares, case_, sizes_, arc, basis_, arc.end - arc.start, arcs[at(k + 1)].initial);
  }
  Eigen::Index largest = 0;
  const double square = squares.diagonal().head<6>().maxCoeff(&largest);
  StateVector later = squares.col(largest).head<6>() / std::sqrt(square);
  later *= energy * later < 0.0 ? -1.0 : 1.0;  // it has as much energy as before
  const StateVector rate = rate_at(arcs[fastest], 0.0, state, case_.gravity);
  const StateVector weighted = along_motion(again.period).cwiseProduct(rate);
  const double per_joule = std::abs(weighted.dot(later - faster)) / weighted.dot(rate);
  return per_joule * bound(energy, at_instant(result_.starts_[fastest], rate)) / bound_margin;
}

/// What the periods of a motion that repeats come to, one after the other: the same error each.
void ErrorTracker::repeat(const Repetition& again) {
  const auto& arcs = solution_.arcs();
  result_.period_error_ = Vec2(period_error(again), period_drift(again)).norm();
  double fastest = 0.0;
  double turning = 0.0;
  for (std::size_t arc = again.first; arc < arcs.size(); ++arc) {
    fastest = std::max(fastest, arcs[arc].initial.velocity.norm());
    turning = std::max(turning, sizes_.turns ? std::abs(arcs[arc].initial.spin) : 0.0);
  }
  const double part = largest_part / bound_margin;
  const double lateness = part * std::min(sizes_.shortest / fastest, 1.0 / turning);  // [s]
  const double until = arcs[again.first].start + lateness / result_.period_error_ * again.period;
  if (!(until >= solution_.end_time())) {
    lose(until);
  }
}

/// From here on, `since` [s], the solution is one of many.
void ErrorTracker::lose(double since) {
  lost_ = true;
  meeting_ = meeting();
  result_.unsure_.push_back({std::max(since, sure_to_), std::numeric_limits<double>::infinity(),
                             std::exchange(tie_, std::nullopt)});
}

/// `lose` where taut cables were followed up to `state`: near a dead point that is the reason.
void ErrorTracker::lose_near(const State& state, double since) {
  if (taut_.size() > 1 && independence(case_, state, taut_) < near_dead_point && !tie_) {
    tie_ = Tie{EventKind::taut, taut_};
  }
  lose(since);
}

/// The instant of the last event [s].
double ErrorTracker::last_event() const {
  return before_ != nullptr && next_ > 0 ? solution_.events()[next_ - 1].time : 0.0;
}

}  // namespace tautline
