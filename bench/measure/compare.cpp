#include "bench/measure/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/measure/compare_settling.hpp"
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

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// The impacts up to `end`. Pairs belong to the window of their exact impact: one that the run has
/// a moment after the window is not missed.
ImpactMatch within(const std::vector<CountedImpact>& exact, const std::vector<CountedImpact>& found,
                   const Pairs& pairs, double end) {
  const auto inside = [end](const CountedImpact& impact) { return impact.time <= end; };
  ImpactMatch result;
  result.exact = static_cast<std::size_t>(std::count_if(exact.begin(), exact.end(), inside));
  result.found = static_cast<std::size_t>(std::count_if(found.begin(), found.end(), inside));
  for (const auto& [i, j] : pairs) {
    if (!inside(exact[i])) {
      continue;
    }
    const double error = std::abs(exact[i].time - found[j].time);
    ++result.matched;
    result.worst_time_error = std::max(result.worst_time_error.value_or(0.0), error);
    if (i == 0) {
      result.first_time_error = error;
    }
  }
  return result;
}

/// For each of `from`, the index of the nearest of `to` on the same cable.
std::vector<std::optional<std::size_t>> nearest(const std::vector<CountedImpact>& from,
                                                const std::vector<CountedImpact>& to) {
  std::vector<std::optional<std::size_t>> result(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    // both lists rise in time: walk out from the first not before, to the same cable either side
    const auto later = std::lower_bound(
        to.begin(), to.end(), from[i].time,
        [](const CountedImpact& impact, double time) { return impact.time < time; });
    double best = std::numeric_limits<double>::infinity();
    const auto consider = [&](auto it) {
      const double distance = std::abs(it->time - from[i].time);
      if (distance < best) {
        best = distance;
        result[i] = static_cast<std::size_t>(it - to.begin());
      }
    };
    for (auto it = later; it != to.end(); ++it) {
      if (it->cable == from[i].cable) {
        consider(it);
        break;
      }
    }
    for (auto it = later; it != to.begin();) {
      if ((--it)->cable == from[i].cable) {
        consider(it);
        break;
      }
    }
  }
  return result;
}

std::vector<CountedImpact> counted(const Trajectory& run, double count_speed) {
  std::vector<CountedImpact> result;
  for (const RecordedImpact& impact : run.impacts) {
    if (-impact.rate_before > count_speed) {
      result.push_back({impact.time, impact.cable});
    }
  }
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

std::string_view to_string(Window window) {
  switch (window) {
    case Window::early:
      return "early";
    case Window::horizon:
      return "horizon";
    case Window::whole:
      return "whole";
  }
  return "unknown";
}

std::vector<CountedImpact> counted_impacts(const Case& the_case, const Solution& solution,
                                           double count_speed) {
  std::vector<CountedImpact> result;
  for (const Event& event : solution.events()) {
    for (const std::size_t index : event.cables) {
      if (event.kind == EventKind::impact &&
          -gap_rate(the_case.cables[index], event.before) > count_speed) {
        result.push_back({event.time, index});
      }
    }
  }
  return result;
}

std::vector<std::pair<std::size_t, std::size_t>> match_impacts(
    const std::vector<CountedImpact>& exact, const std::vector<CountedImpact>& found) {
  const auto to_found = nearest(exact, found);
  const auto to_exact = nearest(found, exact);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (to_found[i] && to_exact[*to_found[i]] == i) {
      pairs.emplace_back(i, *to_found[i]);
    }
  }
  return pairs;
}

bool reaches(const Trajectory& run, double time) {
  constexpr double near_enough = 0.98;  // [-]
  const double end = run.stop ? run.stop->time : run.points.back().time;
  return end >= near_enough * time;
}

Metrics compare(const Case& the_case, const Solution& solution, const Settling& settling,
                double horizon, const Trajectory& run, const CompareOptions& options) {
  const double end = solution.end_time();
  const auto exact = counted_impacts(the_case, solution, options.count_speed);
  const auto found = counted(run, options.count_speed);
  const std::array<double, windows.size()> ends = {
      early_end(exact, options.early_impacts, std::min(end, horizon)), std::min(end, horizon), end};
  const Pairs pairs = match_impacts(exact, found);
  Metrics metrics;
  for (std::size_t window = 0; window < windows.size(); ++window) {
    metrics.deviation[window] = deviation(solution, run, ends[window]);
    metrics.impacts[window] = within(exact, found, pairs, ends[window]);
  }
  metrics.last_impacts = match_last_impacts(settling, run, end);
  metrics.swing = match_swing(the_case, solution, settling, run);
  metrics.overstretch = run.overstretch;
  metrics.energy_gain = run.largest_energy - energy(the_case, run.points.front().state);
  const auto last = std::find_if(run.points.rbegin(), run.points.rend(),
                                 [end](const Point& point) { return point.time <= end; });
  metrics.energy_error =
      std::abs(energy(the_case, last->state) - energy(the_case, solution.at(last->time)));
  add_run_impacts(the_case, run, settling.lock ? settling.lock->time : end, options.count_speed,
                  metrics);
  return metrics;
}

}  // namespace tautline::bench
