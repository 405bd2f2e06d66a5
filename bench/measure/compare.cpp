#include "bench/measure/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/measure/impact_errors.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/measure/settling_match.hpp"
#include "bench/measure/tension_match.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

Deviation deviation(const Solution& solution, const Trajectory& run, double until) {
  Deviation result;
  result.until = until;
  double integral = 0.0;  // [m], of the velocity's distance
  double previous_time = 0.0;
  double previous_distance = 0.0;
  for (const Point& point : run.points) {
    if (point.time > until) {
      break;
    }
    const State exact = solution.at(point.time);
    const double distance = (point.state.velocity - exact.velocity).norm();
    integral += 0.5 * (distance + previous_distance) * (point.time - previous_time);
    previous_time = point.time;
    previous_distance = distance;
    result.position = std::max(result.position, (point.state.position - exact.position).norm());
    result.angle = std::max(result.angle, std::abs(point.state.angle - exact.angle));
  }
  result.covered = previous_time;
  result.velocity = previous_time > 0.0 ? integral / previous_time : 0.0;
  return result;
}

/// Adds what the run's counted impacts say: restitution up to `end` [s], and what there is besides.
void add_run_impacts(const Case& the_case, const Trajectory& run, double end, double count_speed,
                     Metrics& metrics) {
  MeasuredRestitution result;
  result.smallest = std::numeric_limits<double>::infinity();
  result.largest = -result.smallest;
  double sum = 0.0;
  for (const RecordedImpact& impact : run.impacts) {
    if (-impact.rate_before <= count_speed) {
      continue;
    }
    if (impact.time > end) {
      ++metrics.later_impacts;
      continue;
    }
    if (impact.steps > 1) {  // a push over several steps is no rebound
      ++metrics.long_impacts;
      continue;
    }
    const double measured = -impact.rate_after / impact.rate_before;
    const double wanted = restitution(the_case.cables[impact.cable], impact.rate_before);
    ++result.count;
    sum += measured;
    result.smallest = std::min(result.smallest, measured);
    result.largest = std::max(result.largest, measured);
    result.worst = std::max(result.worst, std::abs(measured - wanted));
  }
  if (result.count > 0) {
    result.mean = sum / static_cast<double>(result.count);
    metrics.restitution = result;
  }
}

/// Where the early window ends: halfway to the impact after its last.
double early_end(const std::vector<CountedImpact>& exact, std::size_t impacts, double end) {
  if (exact.size() <= impacts) {
    return end;
  }
  return std::min(end, 0.5 * (exact[impacts - 1].time + exact[impacts].time));
}

}  // namespace

Metrics compare(const Case& the_case, const Solution& solution, const Settling& settling,
                double horizon, const Trajectory& run, const CompareOptions& options) {
  const double end = solution.end_time();
  const auto exact = counted_impacts(the_case, solution, options.count_speed);
  const auto found = counted_impacts(run, options.count_speed);
  const std::array<double, windows.size()> ends = {
      early_end(exact, options.early_impacts, std::min(end, horizon)), std::min(end, horizon), end};
  const ImpactPairs pairs = match_impacts(exact, found);
  Metrics metrics;
  for (std::size_t window = 0; window < windows.size(); ++window) {
    metrics.deviation[window] = deviation(solution, run, ends[window]);
    metrics.impacts[window] = impacts_until(ends[window], exact, found, pairs);
  }
  metrics.last_impacts = match_last_impacts(settling, horizon, run, end);
  metrics.swing = match_swing(the_case, solution, settling, run);
  metrics.overstretch = run.overstretch;
  metrics.energy_gain = run.largest_energy - energy(the_case, run.points.front().state);
  const auto last = std::find_if(run.points.rbegin(), run.points.rend(),
                                 [end](const Point& point) { return point.time <= end; });
  metrics.energy_error =
      std::abs(energy(the_case, last->state) - energy(the_case, solution.at(last->time)));
  add_run_impacts(the_case, run, settling.lock ? settling.lock->time : end, options.count_speed,
                  metrics);
  const ImpactErrors errors = impact_errors(the_case, solution, run, options.count_speed, exact,
                                            pairs, ends[static_cast<std::size_t>(Window::horizon)]);
  metrics.impulse_error = errors.impulse;
  metrics.energy_loss_error = errors.energy_loss;
  const double sure_end = ends[static_cast<std::size_t>(Window::horizon)];
  const TensionMatch tensions = match_tensions(the_case, solution, run, sure_end);
  metrics.rest_tension = tensions.at_rest;
  metrics.largest_tension = tensions.largest;
  metrics.first_impulse =
      match_first_impulse(the_case, solution, run, options.count_speed, sure_end);
  return metrics;
}

}  // namespace tautline::bench
