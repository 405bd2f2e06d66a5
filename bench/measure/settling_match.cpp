#include "bench/measure/settling_match.hpp"

#include <algorithm>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Fewer samples in a period do not show an amplitude: with n of them the largest angle is missed
/// by up to (pi / n)^2 / 2 of it, here 1 % [-].
constexpr std::ptrdiff_t least_samples = 20;

}  // namespace

std::optional<Swing> measured_swing(const Case& the_case, const Solution& solution,
                                    const std::optional<Lock>& lock) {
  // a solution that ends with a lock would have gone on
  const double end = solution.swing() ? the_case.duration : solution.end_time();
  if (!lock || !lock->permanent || !lock->swing || end - lock->swing->period < lock->time) {
    return std::nullopt;
  }
  return lock->swing;
}

std::optional<SwingMatch> match_swing(const Case& the_case, const Solution& solution,
                                      const Settling& settling, const Trajectory& run) {
  const std::optional<Swing> measured = measured_swing(the_case, solution, settling.lock);
  if (run.diverged || !measured || measured->goes_round) {
    return std::nullopt;
  }
  const Swing& exact = *measured;
  const double until = std::min(run.points.back().time, solution.end_time());
  const double from = until - exact.period;
  if (from < settling.lock->time) {
    return std::nullopt;
  }
  const auto before = [](const Point& point, double time) { return point.time < time; };
  const auto first = std::lower_bound(run.points.begin(), run.points.end(), from, before);
  const auto last =
      std::upper_bound(first, run.points.end(), until,
                       [](double time, const Point& point) { return time < point.time; });
  if (last - first < least_samples) {
    return std::nullopt;
  }
  const double equilibrium = energy(the_case, solution.at(solution.end_time())) - exact.energy;
  double sum = 0.0;  // [J]
  for (auto point = first; point != last; ++point) {
    sum += energy(the_case, point->state) - equilibrium;
  }
  const auto angle = [&](const Point& point) {
    const Cable& cable = the_case.cables[*settling.lock->cables.begin()];
    return exact.angle == SwingAngle::body ? point.state.angle
                                           : cable_angle(cable, point.state, the_case.gravity);
  };
  const auto [least, largest] = std::minmax_element(
      first, last, [&](const Point& one, const Point& other) { return angle(one) < angle(other); });
  return SwingMatch{from,
                    until,
                    {exact.energy, sum / static_cast<double>(last - first)},
                    {exact.amplitude, 0.5 * (angle(*largest) - angle(*least))}};
}

}  // namespace tautline::bench
