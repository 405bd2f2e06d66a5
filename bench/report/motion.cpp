#include "bench/report/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "bench/measure/impact_match.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// The body at `time` [s], with the energy of `moving` there.
void add(Path& path, const Case& the_case, double time, const State& state, const State& moving) {
  const double energy_there = energy(the_case, moving);
  if (!std::isfinite(energy_there) || !state.position.allFinite()) {
    return;  // the last of a run that diverged
  }
  path.time.push_back(time);
  path.x.push_back(state.position.x());
  path.y.push_back(state.position.y());
  path.angle.push_back(state.angle);
  path.energy.push_back(energy_there);
}

/// The `index`-th of `count` indices spread evenly over 0 .. size - 1, ends included.
std::size_t spread(std::size_t index, std::size_t count, std::size_t size) {
  return count < 2 ? 0 : index * (size - 1) / (count - 1);
}

/// Leaves the `most_impacts` of `events` that are largest by `speed`, in the order they had.
template <class Event, class Speed>
void keep_fastest(std::vector<Event>& events, const Speed& speed) {
  if (events.size() <= most_impacts) {
    return;
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t index = 0; index < events.size(); ++index) {
    order.emplace_back(-speed(events[index]), index);
  }
  std::sort(order.begin(), order.end());
  order.resize(most_impacts);
  std::sort(order.begin(), order.end(),
            [](const auto& a, const auto& b) { return a.second < b.second; });
  std::vector<Event> kept;
  kept.reserve(order.size());
  for (const auto& entry : order) {
    kept.push_back(events[entry.second]);
  }
  events = std::move(kept);
}

/// The counted impacts that the report has, in rising time.
std::vector<const RecordedImpact*> kept_impacts(const Trajectory& run, double count_speed) {
  std::vector<const RecordedImpact*> impacts = counted(run, count_speed);
  keep_fastest(impacts, [](const RecordedImpact* impact) { return -impact->rate_before; });
  return impacts;
}

/// Closing speed of the fastest cable of an impact [m/s]; none of another event.
std::optional<double> closing_speed(const Case& the_case, const Event& event) {
  if (event.kind != EventKind::impact) {
    return std::nullopt;
  }
  double fastest = 0.0;
  for (const std::size_t index : event.cables) {
    fastest = std::max(fastest, -gap_rate(the_case.cables[index], event.before));
  }
  return fastest;
}

/// The events that the report has.
std::vector<const Event*> kept_events(const ReferenceCase& reference) {
  std::vector<const Event*> events;
  for (const Event& event : reference.solution.events()) {
    events.push_back(&event);
  }
  keep_fastest(events, [&](const Event* event) {
    // what is no impact is rare and always kept
    return closing_speed(reference.the_case, *event)
        .value_or(std::numeric_limits<double>::infinity());
  });
  return events;
}

}  // namespace

Path run_path(const Case& the_case, const Trajectory& run, std::size_t samples,
              double count_speed) {
  const auto impacts = kept_impacts(run, count_speed);
  const std::size_t count = std::min(samples, run.points.size());
  Path path;
  auto impact = impacts.begin();
  double latest = -1.0;  // [s], of an impact
  for (std::size_t index = 0; index < count; ++index) {
    const auto& [time, state] = run.points[spread(index, count, run.points.size())];
    for (; impact != impacts.end() && (*impact)->time <= time && index > 0; ++impact) {
      // a push over several steps ends elsewhere: there is no state after it at its time
      const bool jumps = (*impact)->steps <= 1;
      if ((*impact)->time != latest) {
        add(path, the_case, (*impact)->time, (*impact)->before,
            jumps ? (*impact)->after : (*impact)->before);
        latest = (*impact)->time;
      }
    }
    if (time != latest || index + 1 == count) {
      add(path, the_case, time, state, state);
    }
  }
  return path;
}

ImpactColumns run_impacts(const Case& the_case, const Trajectory& run, double count_speed) {
  const auto impacts = kept_impacts(run, count_speed);
  ImpactColumns columns;
  for (const RecordedImpact* impact : impacts) {
    const Cable& cable = the_case.cables[impact->cable];
    const Eigen::Vector3d pull = gap_gradient(cable, impact->before);
    const Vec2 across = perpendicular(Vec2(pull.head<2>()));
    columns.time.push_back(impact->time);
    columns.cable.push_back(impact->cable);
    columns.requested.push_back(restitution(cable, impact->rate_before));
    columns.rate_before.push_back(impact->rate_before);
    columns.rate_after.push_back(impact->rate_after);
    columns.arm.push_back(pull[2]);
    columns.tangential_error.push_back(across.dot(Vec2(impact->stray.head<2>())));
    columns.angular_error.push_back(impact->stray[2]);
    columns.steps.push_back(impact->steps);
  }
  columns.left_out = counted(run, count_speed).size() - impacts.size();
  return columns;
}

Path exact_path(const ReferenceCase& reference) {
  const std::vector<const Event*> events = kept_events(reference);
  const Solution& solution = reference.solution;
  Path path;
  auto event = events.begin();
  for (std::size_t index = 0; index < exact_samples; ++index) {
    const double time = exact_sample_time(solution, index);
    for (; event != events.end() && (*event)->time <= time; ++event) {
      add(path, reference.the_case, (*event)->time, (*event)->after, (*event)->after);
    }
    const State state = solution.at(time);
    add(path, reference.the_case, time, state, state);
  }
  return path;
}

EventColumns exact_events(const ReferenceCase& reference) {
  EventColumns columns;
  for (const Event* event : kept_events(reference)) {
    columns.time.push_back(event->time);
    columns.kind.emplace_back(to_string(event->kind));
    const auto cables = event->cables.indices();
    columns.cables.emplace_back(cables.begin(), cables.end());
    columns.rate.push_back(closing_speed(reference.the_case, *event));
  }
  return columns;
}

}  // namespace tautline::bench
