#include "bench/measure/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/base/listed.hpp"
#include "bench/measure/contact_match.hpp"
#include "bench/measure/impact_errors.hpp"
#include "bench/measure/impact_match.hpp"
#include "bench/measure/settling_match.hpp"
#include "bench/measure/tension_match.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/model_table.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// How far a body is from where it should be: [m], [rad], [m/s].
struct Distance {
  double position = 0.0;
  double angle = 0.0;
  double velocity = 0.0;
};
Distance distance(const State& state, const State& exact) {
  return {(state.position - exact.position).norm(), std::abs(state.angle - exact.angle),
          (state.velocity - exact.velocity).norm()};
}
/// In a system the largest of each counts; a point mass has no angle.
Distance distance(const SpatialSystemState& state, const SpatialSystemState& exact) {
  Distance result;
  for (std::size_t index = 0; index < state.bodies.size(); ++index) {
    const SpatialState& body = state.bodies[index];
    const SpatialState& right = exact.bodies[index];
    result.position = std::max(result.position, (body.position - right.position).norm());
    result.angle = std::max(result.angle, turn_between(body, right));
    result.velocity = std::max(result.velocity, (body.velocity - right.velocity).norm());
  }
  return result;
}

template <class TheCase>
Deviation deviation(const BasicSolution<TheCase>& solution, const BasicTrajectory<TheCase>& run,
                    double until) {
  Deviation result;
  result.until = until;
  double integral = 0.0;  // [m], of the velocity's distance
  double previous_time = 0.0;
  double previous_distance = 0.0;
  for (const BasicPoint<TheCase>& point : run.points) {
    if (point.time > until) {
      break;
    }
    const Distance off = distance(point.state, solution.at(point.time));
    integral += 0.5 * (off.velocity + previous_distance) * (point.time - previous_time);
    previous_time = point.time;
    previous_distance = off.velocity;
    result.position = std::max(result.position, off.position);
    result.angle = std::max(result.angle, off.angle);
  }
  result.covered = previous_time;
  result.velocity = previous_time > 0.0 ? integral / previous_time : 0.0;
  return result;
}

/// Adds what the run's counted impacts say: restitution up to `end` [s], and what there is besides.
template <class TheCase>
void add_run_impacts(const TheCase& the_case, const BasicTrajectory<TheCase>& run, double end,
                     double count_speed, Metrics& metrics) {
  MeasuredRestitution result;
  result.smallest = std::numeric_limits<double>::infinity();
  result.largest = -result.smallest;
  double sum = 0.0;
  for (const BasicRecordedImpact<TheCase>& impact : run.impacts) {
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

/// All but the swing.
template <class TheCase, class TheSettling>
Metrics compared(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                 const TheSettling& settling, double horizon, const BasicTrajectory<TheCase>& run,
                 const CompareOptions& options) {
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
  metrics.overstretch = run.overstretch;
  metrics.energy_gain = keeps_energy(the_case)
                            ? run.largest_energy - energy(the_case, run.points.front().state)
                            : std::numeric_limits<double>::quiet_NaN();
  const auto last = std::find_if(run.points.rbegin(), run.points.rend(),
                                 [end](const auto& point) { return point.time <= end; });
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

}  // namespace

bool keeps_energy(const SpatialSystem& system) {
  bool all_constant = true;
  each_function(
      system, [&](const auto& function) { all_constant = all_constant && function.is_constant(); });
  return all_constant && std::all_of(system.bodies.begin(), system.bodies.end(),
                                     [](const SpatialBody& body) { return body.moment.empty(); });
}

Metrics compare(const Case& the_case, const Solution& solution, const Settling& settling,
                double horizon, const Trajectory& run, const CompareOptions& options) {
  Metrics metrics = compared(the_case, solution, settling, horizon, run, options);
  metrics.swing = match_swing(the_case, solution, settling, run);
  return metrics;
}

Metrics compare(const SpatialSystem& system, const BasicSolution<SpatialSystem>& solution,
                const SystemSettling& settling, double horizon, const SystemTrajectory& run,
                const CompareOptions& options) {
  Metrics metrics = compared(system, solution, settling, horizon, run, options);
  if (first_elastic(system)) {
    const auto cuts = listed(system.cables, [](const SpatialCable& cable) {
      return cable.cut_at.value_or(std::numeric_limits<double>::infinity());
    });
    metrics.contacts = match_contacts(
        elastic_contacts(solution), run.contacts,
        {options.count_speed, 2.0 * run.step, std::min(solution.end_time(), horizon), cuts});
  }
  return metrics;
}

}  // namespace tautline::bench
