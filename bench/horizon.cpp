#include "bench/horizon.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// Sets one of the six initial values of a case off by `apart`.
using Nudge = std::function<void(State&, double)>;

const std::array<Nudge, 6> nudges = {
    [](State& state, double apart) { state.position.x() += apart; },
    [](State& state, double apart) { state.position.y() += apart; },
    [](State& state, double apart) { state.angle += apart; },
    [](State& state, double apart) { state.velocity.x() += apart; },
    [](State& state, double apart) { state.velocity.y() += apart; },
    [](State& state, double apart) { state.spin += apart; },
};

/// The first instant at which two solutions are `visible` apart, or the end of the shorter one.
double first_apart(const Solution& one, const Solution& other, double visible) {
  // positions are smooth between events: sampling every arc of `one` catches a growing difference,
  // for `other` leaves those arcs only near its own events, which a small difference keeps close
  constexpr int samples_per_arc = 16;
  const double end = std::min(one.end_time(), other.end_time());
  for (const Arc& arc : one.arcs()) {
    for (int sample = 0; sample < samples_per_arc; ++sample) {
      const double time = arc.start + (arc.end - arc.start) * sample / samples_per_arc;
      if (time > end) {
        return end;
      }
      if ((one.at(time).position - other.at(time).position).norm() > visible) {
        return time;
      }
    }
  }
  return end;
}

}  // namespace

double predictability_horizon(const Case& the_case, const Solution& solution, double apart,
                              double visible) {
  double horizon = solution.end_time();
  for (const Nudge& nudge : nudges) {
    for (const double sign : {-1.0, 1.0}) {
      Case nearby = the_case;
      nudge(nearby.initial, sign * apart);
      if (problems(nearby).empty()) {
        horizon = std::min(horizon, first_apart(solution, solve(nearby), visible));
      }
    }
  }
  return horizon;
}

}  // namespace tautline::bench
