#include <cmath>

#include "error_flow.hpp"
#include "error_tracker.hpp"
#include "tautline/geometry.hpp"
#include "tautline/projection.hpp"

namespace tautline {
namespace {

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
  const StateVector rate = rate_at(*before_, length, event.before, case_.gravity);
  now_ = delayed(now_, delay, rate);
  now_(6, 6) += rounding * rounding;
  add_late(now_, rounding * rounding, rate);
  return true;
}

}  // namespace tautline
