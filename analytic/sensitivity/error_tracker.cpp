#include "error_tracker.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "linearised.hpp"
#include "rounding.hpp"
#include "saltation.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
#include "tautline/projection.hpp"

namespace tautline {
namespace {

/// First order is trusted while the bound of an error is below this part of what it would change
/// the order of: a closing rate, the time between two events, a gap that stays open [-].
constexpr double trusted_part = 0.25;

/// A meeting is looked for from as many places before an unsure stretch.
constexpr std::size_t most_places = 32;

/// The least value [m] that a gap has between two instants `dt` apart and at the second, from its
/// values and rates there (Hermite's cubic). The first instant does not count: it may start at
/// zero.
double least_gap(double g0, double r0, double g1, double r1, double dt) {
  const double a = 2 * (g0 - g1) + dt * (r0 + r1);
  const double b = 3 * (g1 - g0) - dt * (2 * r0 + r1);
  const double c = dt * r0;
  double least = g1;
  const double root = b * b - 3 * a * c;
  if (root > 0.0) {
    const double s = (-b + std::sqrt(root)) / (3 * a);  // where the second derivative is positive
    const double at = std::abs(a) > 1e-9 * std::abs(b) ? s : -c / (2 * b);
    if (at > 0.0 && at < 1.0 && (a != 0.0 || b > 0.0)) {
      least = std::min(least, ((a * at + b) * at + c) * at + g0);
    }
  }
  return least;
}

StateRow gap_row(const Cable& cable, const State& state) {
  StateRow row = StateRow::Zero();
  row.head<3>() = gap_gradient(cable, state).transpose();
  return row;
}

/// The second derivatives of a gap, with respect to x, y and angle.
Eigen::Matrix3d gap_curvature(const Cable& cable, const State& state) {
  const Vec2 arm = attachment_arm(state, cable);
  const Vec2 from_anchor = state.position + arm - cable.anchor;
  const double distance = from_anchor.norm();
  const Vec2 u = from_anchor / distance;
  const Vec2 across = perpendicular(u);
  const Eigen::Vector3d moved(across.x(), across.y(), across.dot(perpendicular(arm)));
  Eigen::Matrix3d result = -moved * moved.transpose() / distance;
  result(2, 2) += u.dot(arm);
  return result;
}

/// d gap rate / d state.
StateRow rate_row(const Cable& cable, const State& state) {
  StateRow row;
  row << gap_gradient_rate(cable, state).transpose(), gap_gradient(cable, state).transpose();
  return row;
}

/// The tensions that hold `pulling` [N], in rising index order.
CableVector tensions(const Case& the_case, const State& state, CableSet pulling) {
  CableVector free(static_cast<Eigen::Index>(pulling.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : pulling) {
    free[row++] = free_gap_acceleration(the_case, index, state);
  }
  return -multipliers<double>(the_case, state, pulling, free);
}

}  // namespace

ErrorTracker::ErrorTracker(const Case& the_case, const Solution& solution,
                           const SolveOptions& options, Uncertainty& result)
    : case_(the_case), solution_(solution), options_(options), result_(result) {}

void ErrorTracker::run() {
  result_.events_.resize(solution_.events().size());
  result_.starts_.reserve(solution_.arcs().size());
  for (std::size_t index = 0; index < solution_.arcs().size(); ++index) {
    const Arc& arc = solution_.arcs()[index];
    start_events(index);
    result_.starts_.push_back(now_);
    if (!lost_) {
      follow(arc);
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
  if (lost_) {
    taut_ = event.kind == EventKind::taut    ? taut_ | event.cables
            : event.kind == EventKind::slack ? taut_ - event.cables
                                             : taut_;
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
  if (event.kind == EventKind::impact) {
    places_.push_back({next_, now_, taut_});
    if (places_.size() > most_places) {
      places_.pop_front();
    }
  }
}

/// Adds the error of the instant at which `hit` become taut. False where first order does not say
/// what happens.
bool ErrorTracker::arrive(const Event& event, CableSet hit) {
  const double place = contact_rounding(case_, event.before, hit);
  now_.diagonal().head<2>().array() += place * place;
  const auto delay = delay_derivative(case_, event.before, hit);
  if (!delay || !order_is_sure(event)) {
    return false;
  }
  const double last = before_->start;
  const StateMatrix squares = now_.topLeftCorner<6, 6>();
  if (!(bound(*delay, squares) <= trusted_part * (event.time - last))) {
    return false;
  }
  now_ = delayed(now_, *delay, rate_);
  for (const std::size_t index : hit) {
    const Cable& cable = case_.cables[index];
    const double rate = gap_rate(cable, event.before);
    const double error =
        bound(rate_row(cable, event.before), now_.topLeftCorner<6, 6>(), curvature_);
    if (!(error <= trusted_part * std::abs(rate)) ||
        (depends_on_speed(cable) && std::abs(-rate - cable.capture_speed) <= error)) {
      return false;
    }
    curvature_ = std::max(curvature_, std::pow(error / rate, 2));
  }
  const double tick = one_rounding * event.time;
  now_(6, 6) += tick * tick;
  return true;
}

/// Adds the error of the instant at which the tension of the cables of `event` is zero.
bool ErrorTracker::release(const Event& event) {
  const CableSet pulling = basis(case_, event.before, taut_);
  if ((pulling & event.cables).empty()) {
    return true;
  }
  const std::size_t lost = *(pulling & event.cables).begin();
  const auto tension = [&](const State& state) {
    const CableVector all = tensions(case_, state, pulling);
    Eigen::Index row = 0;
    for (const std::size_t index : pulling) {
      if (index == lost) {
        break;
      }
      ++row;
    }
    return all[row];
  };
  // differences whose rounding and curvature balance
  const double part = std::cbrt(epsilon<double>());
  const double length = before_->end - before_->start;
  const State earlier = before_->after(length * (1.0 - part), case_.gravity);
  const double fall = (tension(event.before) - tension(earlier)) / (length * part);
  if (!(fall < 0.0)) {
    return false;
  }
  StateRow delay;
  for (int axis = 0; axis < 6; ++axis) {
    const auto moved = [&](double by) {
      State state = event.before;
      double* const number[] = {&state.position.x(), &state.position.y(), &state.angle,
                                &state.velocity.x(), &state.velocity.y(), &state.spin};
      *number[axis] += by;
      return tension(state);
    };
    const double step = part * (axis < 2 ? shortest_length(case_) : 1.0);
    delay[axis] = -(moved(step) - moved(-step)) / (2.0 * step) / fall;
  }
  const double rounding =
      8 * one_rounding * case_.body.mass * acceleration_scale(case_, event.before) / -fall;  // [s]
  const double error = bound(delay, now_.topLeftCorner<6, 6>()) + rounding;
  const double from = before_->start;
  if (!(error <= trusted_part * (event.time - from)) && before_->taut != taut_) {
    return false;
  }
  now_ = delayed(now_, delay, rate_);
  now_(6, 6) += rounding * rounding;
  now_.topLeftCorner<6, 6>() += rounding * rounding * rate_ * rate_.transpose();
  return true;
}

/// True where no cable that stays slack along the arc before `event` might have been hit.
bool ErrorTracker::order_is_sure(const Event& event) const {
  const double dt = before_->end - before_->start;
  const StateMatrix squares = now_.topLeftCorner<6, 6>();
  for (std::size_t index = 0; index < case_.cables.size(); ++index) {
    if (event.cables.contains(index) || before_->taut.contains(index)) {
      continue;
    }
    const Cable& cable = case_.cables[index];
    const double least = least_gap(gap(cable, before_->initial), gap_rate(cable, before_->initial),
                                   gap(cable, event.before), gap_rate(cable, event.before), dt);
    const double rounding = bound_margin * 2 * one_rounding * gap_scale(case_, index, event.before);
    if (!(bound(gap_row(cable, event.before), squares) + rounding <= least)) {
      return false;
    }
  }
  return true;
}

/// True while errors are small against the system.
bool ErrorTracker::is_sure() const {
  if (!now_.allFinite()) {
    return false;
  }
  const State errors = bounds(now_.topLeftCorner<6, 6>());
  return errors.position.maxCoeff() <= largest_part * shortest_length(case_) &&
         (is_point_mass(case_) || errors.angle <= largest_part);
}

/// What the impact's results gain per unit of the state before: in closed form for one cable.
BasicReboundSlopes<double> ErrorTracker::slopes_of(const Event& event) const {
  const Cable& cable = case_.cables[*event.cables.begin()];
  if (event.cables.size() > 1 || depends_on_speed(cable) || !(event.impulses[0] > 0.0)) {
    return rebound_slopes(case_, options_.law, event, taut_);
  }
  // impulse = -(1 + e) rate / G; G = J M^-1 J^T, whose derivative is 2 M^-1 J^T times that of J
  const Eigen::Matrix<double, 3, 1> weight = inverse_mass(case_.body);
  const Eigen::Matrix<double, 3, 1> gradient = gap_gradient(cable, event.before);
  const Eigen::Matrix3d curvature = gap_curvature(cable, event.before);
  const Eigen::Matrix<double, 3, 1> weighted = weight.cwiseProduct(gradient);
  const double g = gradient.dot(weighted);
  StateRow impulse = -(1.0 + cable.restitution) / g * rate_row(cable, event.before);
  impulse.head<3>() -= 2.0 * event.impulses[0] / g * (curvature * weighted).transpose();
  BasicReboundSlopes<double> result{StateMatrix::Identity(), impulse};
  result.after.bottomRows<3>() += weighted * impulse;
  result.after.bottomLeftCorner<3, 3>() += event.impulses[0] * weight.asDiagonal() * curvature;
  return result;
}

EventErrors ErrorTracker::take_impact(const Event& event) {
  const StateMatrix squares = now_.topLeftCorner<6, 6>();
  EventErrors errors{
      bound(now_(6, 6)), 0.0, CableVector(event.impulses.size()), bounds(squares), {}};
  const double unit = 2 * one_rounding * std::max(fastest_, speed_scale(case_, event.before));
  double fastest = 0.0;
  for (const std::size_t index : event.cables) {
    const Cable& cable = case_.cables[index];
    if (const double rate = -gap_rate(cable, event.before); rate >= fastest) {
      fastest = rate;
      errors.rate = bound(rate_row(cable, event.before), squares, curvature_) + bound_margin * unit;
    }
  }
  const auto slopes = slopes_of(event);
  const CableMatrix g = delassus(case_, event.before, event.cables);
  for (Eigen::Index row = 0; row < event.impulses.size(); ++row) {
    errors.impulses[row] =
        bound(StateRow(slopes.impulses.row(row)), squares, curvature_) +
        bound_margin * (one_rounding * std::abs(event.impulses[row]) + unit / g(row, row));
  }
  now_ = mapped(now_, slopes.after);
  // what rounding of the rates makes of the velocities
  const Eigen::Matrix<double, 3, 1> weight = inverse_mass(case_.body);
  StateVector rounding = StateVector::Zero();
  Eigen::Index row = 0;
  for (const std::size_t index : event.cables) {
    rounding.tail<3>() +=
        unit / g(row, row) *
        gap_gradient(case_.cables[index], event.before).cwiseProduct(weight).cwiseAbs();
    ++row;
  }
  if (row > 1) {  // nearly dependent cables share it out by large impulses that almost cancel
    const CableSet rows = basis(case_, event.before, event.cables);
    rounding /= std::max(delassus(case_, event.before, rows).ldlt().rcond(), epsilon<double>());
  }
  add_errors(now_, rounding);
  errors.after = bounds(now_.topLeftCorner<6, 6>());
  return errors;
}

EventErrors ErrorTracker::take_taut(const Event& event) {
  EventErrors errors{bound(now_(6, 6)),
                     0.0,
                     CableVector::Zero(event.impulses.size()),
                     bounds(now_.topLeftCorner<6, 6>()),
                     {}};
  taut_ = taut_ | event.cables;
  now_ = mapped(now_, projection_derivative(case_, event.before, taut_));
  if (const Accumulation* const accumulation = completed_by(event)) {
    // what the limit lies after the event is as wrong as the last bounce is long
    const double last = event.time - before_->start;
    const double remaining = accumulation->time - accumulation->start;
    const double relative = last > 0.0 ? errors.time / last : 0.0;
    errors.time += accumulation->uncertainty + remaining * std::min(relative, 1.0);
  }
  StateVector rounding = arc_rounding(case_, event.before, event.after, 0.0);
  const double completed = options_.completion.error * speed_scale(case_, event.after);
  rounding.tail<3>().array() += completed;
  add_errors(now_, rounding);
  errors.after = bounds(now_.topLeftCorner<6, 6>());
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
  const State same = bounds(now_.topLeftCorner<6, 6>());
  return {bound(now_(6, 6)), 0.0, CableVector::Zero(event.impulses.size()), same, same};
}

/// Carries the errors along `arc`.
void ErrorTracker::follow(const Arc& arc) {
  const double dt = arc.end - arc.start;
  if (dt > 0.0) {
    const State last = arc.after(dt, case_.gravity);
    now_ = mapped(now_, arc_flow(case_, arc, dt));
    add_errors(now_, arc_rounding(case_, arc.initial, last, dt));
    fastest_ = std::max({fastest_, speed_scale(case_, arc.initial), speed_scale(case_, last)});
    rate_ = state_rate(arc, dt, case_.gravity);
    if (!is_sure()) {
      lose();
    }
  }
}

/// From here on the solution is one of many.
void ErrorTracker::lose() {
  lost_ = true;
  meeting_ = meeting();
  const double from = before_ != nullptr && next_ > 0 ? solution_.events()[next_ - 1].time : 0.0;
  result_.unsure_.push_back({from, std::numeric_limits<double>::infinity()});
}

}  // namespace tautline
