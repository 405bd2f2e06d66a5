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
  if (!lost_ && arrives &&
      !(hit.empty() ? event.kind != EventKind::slack || release(event) : arrive(event, hit))) {
    lose();
  }
  if (!lost_ && !(event.time > 0.0) && event.kind == EventKind::impact && !start(event)) {
    lose();
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
    lose();
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
    const double last = event.time - before_->start;
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
    lose();
    return;
  }
  now_ = along(now_, case_, sizes_, arc, basis_, dt, last);
  if (!arc.taut.empty()) {
    add_late(now_, late_at_end(index), rate_at(arc, dt, last, case_.gravity));
  }
  fastest_ = std::max({fastest_, sizes_.speed(arc.initial), sizes_.speed(last)});
  if (!is_sure()) {
    lose();
  }
}

/// The square of what the instants of this taut arc add to how late a state is [s^2]: their
/// rounding; where a swing comes again for the n-th time the error of its period, which is the same
/// every time, so that the square of n times it grows by 2 n - 1.
double ErrorTracker::late_at_end(std::size_t index) {
  const auto& again = solution_.repetition();
  if (!again || index < again->first) {
    return tick_square(solution_.arcs()[index].end);
  }
  if (!period_error_) {
    period_error_ = period_error(*again);
  }
  const std::size_t times = (index - again->first) / again->arcs + 1;
  return static_cast<double>(2 * times - 1) / static_cast<double>(again->arcs) * *period_error_ *
         *period_error_;
}

/// By how much the period is off [s], the root of its square: twice what the arcs of half a swing
/// make of their own rounding.
double ErrorTracker::period_error(const Repetition& again) const {
  const auto& arcs = solution_.arcs();
  Spread own = Spread::Zero();
  for (std::size_t k = again.first - again.arcs / 2; k < again.first; ++k) {
    const double dt = arcs[k].end - arcs[k].start;
    own = along(own, case_, sizes_, arcs[k], basis_, dt, arcs[k + 1].initial);
  }
  // at the turning point nothing moves: an error of the velocities is one of the instant
  const Arc& turned = arcs[again.first];
  const Eigen::Vector3d acceleration =
      rate_at(turned, 0.0, turned.initial, case_.gravity).tail<3>();
  const Eigen::Vector3d force =
      Eigen::Vector3d(case_.body.mass, case_.body.mass, case_.body.inertia)
          .cwiseProduct(acceleration);
  const double square = force.dot(own.block<3, 3>(3, 3) * force);
  const double late = std::sqrt(std::max(square, 0.0)) / force.dot(acceleration);
  return std::hypot(2.0 * late, one_rounding * again.period);
}

/// From here on the solution is one of many.
void ErrorTracker::lose() {
  lost_ = true;
  meeting_ = meeting();
  const double last = before_ != nullptr && next_ > 0 ? solution_.events()[next_ - 1].time : 0.0;
  result_.unsure_.push_back({std::max(last, sure_to_), std::numeric_limits<double>::infinity(),
                             std::exchange(tie_, std::nullopt)});
}

}  // namespace tautline
