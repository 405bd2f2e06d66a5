#include <algorithm>
#include <cmath>

#include "error_flow.hpp"
#include "error_tracker.hpp"
#include "linearised.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// The tension of `cable`, one of the independent cables `pulling` [N].
double tension(const Case& the_case, const State& state, CableSet pulling, std::size_t cable) {
  const CableVector all = tensions(the_case, state, pulling);
  Eigen::Index row = 0;
  for (const std::size_t index : pulling) {
    if (index == cable) {
      break;
    }
    ++row;
  }
  return all[row];
}

/// Differences whose rounding and curvature balance [-].
const double part = root(epsilon<double>(), 3);

/// d value / d state, by differences.
template <class Value>
StateRow row_of(const Case& the_case, const State& state, const Value& value) {
  StateRow result;
  for (int axis = 0; axis < 6; ++axis) {
    const auto moved = [&](double by) {
      State other = state;
      double* const number[] = {&other.position.x(), &other.position.y(), &other.angle,
                                &other.velocity.x(), &other.velocity.y(), &other.spin};
      *number[axis] += by;
      return value(other);
    };
    const double step = part * (axis < 2 ? shortest_length(the_case) : 1.0);
    result[axis] = (moved(step) - moved(-step)) / (2.0 * step);
  }
  return result;
}

/// The rounding of a tension [N] of `pulling`: near a dead point it is a difference of forces that
/// nearly cancel.
double tension_rounding(const Case& the_case, const State& state, CableSet pulling) {
  const double least = pulling.size() > 1 ? independence(the_case, state, pulling) : 1.0;
  const double left = std::min(1.0, least / near_dead_point);  // of them [-]
  return 8 * one_rounding * the_case.body.mass * acceleration_scale(the_case, state) / left;
}

/// The rounding of a sine's square [-].
constexpr double sine_rounding = 8 * one_rounding;

}  // namespace

/// False where rounding decides along the arc of this index whether a cable lets go, as its tension
/// touches zero within the errors, or how taut cables go on from a dead point. `basis_` is that of
/// the arc.
bool ErrorTracker::releases_are_sure(std::size_t index) {
  const Arc& arc = solution_.arcs()[index];
  for (const Touch& touch : touches(case_, solution_, index)) {
    const double dt = std::clamp(touch.time, arc.start, arc.end) - arc.start;
    const State state = arc.after(dt, case_.gravity);
    const Spread there = along(now_, case_, sizes_, arc, basis_, dt, state);
    const bool lets_go = touch.kind == EventKind::slack;
    const auto value = [&](const State& at) {
      return lets_go ? tension(case_, at, basis_, *touch.cables.begin())
                     : independence(case_, at, touch.cables);
    };
    const double rounding = lets_go ? tension_rounding(case_, state, basis_) : sine_rounding;
    const double error =
        bound(row_of(case_, state, value), there.topLeftCorner<6, 6>()) + bound_margin * rounding;
    if (!(error <= trusted_part * std::abs(touch.value))) {
      tie_ = Tie{touch.kind, touch.cables};
      const double width = std::sqrt(2.0 * (error + std::abs(touch.value)) / touch.bend);  // [s]
      sure_to_ = std::max(sure_to_, std::max(touch.time - width, arc.start));
      return false;
    }
  }
  return true;
}

/// Adds the error of the instant at which the tension of the cables of `event` is zero.
bool ErrorTracker::release(const Event& event) {
  const CableSet pulling = basis(case_, event.before, taut_);
  if ((pulling & event.cables).empty()) {
    return true;
  }
  const std::size_t lost = *(pulling & event.cables).begin();
  const double length = before_->end - before_->start;
  const State earlier = before_->after(length * (1.0 - part), case_.gravity);
  const double fall =
      (tension(case_, event.before, pulling, lost) - tension(case_, earlier, pulling, lost)) /
      (length * part);
  if (!(fall < 0.0)) {
    return false;
  }
  const StateRow delay =
      row_of(case_, event.before,
             [&](const State& at) { return tension(case_, at, pulling, lost); }) /
      -fall;
  const double rounding = tension_rounding(case_, event.before, pulling) / -fall;  // [s]
  const double error = bound(delay, now_.topLeftCorner<6, 6>()) + rounding;
  const double force = case_.body.mass * acceleration_scale(case_, event.before);
  if (!(error * -fall <= trusted_part * force)) {
    return false;  // near a dead point, where a small turn changes all of the tension
  }
  const double from = before_->start;
  if (!(error <= trusted_part * (event.time - from)) && before_->taut != taut_) {
    return false;
  }
  const StateVector rate = rate_at(*before_, length, event.before, case_.gravity);
  now_ = delayed(now_, delay, rate);
  now_(6, 6) += rounding * rounding;
  add_late(now_, rounding * rounding, rate);
  return true;
}

}  // namespace tautline
