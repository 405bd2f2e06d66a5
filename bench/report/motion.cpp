#include "bench/report/motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "bench/measure/impact_match.hpp"
#include "bench/report/motion/samples.hpp"
#include "bench/report/motion/taut.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

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

/// The numbers of a motion's panel.
struct Covered {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();

  void take(double value) {
    least = std::min(least, value);
    largest = std::max(largest, value);
  }
  [[nodiscard]] double width() const { return largest - least; }
  [[nodiscard]] double size() const { return std::max(std::abs(least), std::abs(largest)); }
};

Path drawn(const std::vector<Sample>& samples, const Nearness& nearness) {
  Path path;
  if (!samples.empty()) {
    draw_motion(samples, nearness, path);
    draw_energy(samples, nearness, path);
  }
  return path;
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

double drawn_extent(const ReferenceCase& reference) {
  const double reach = attachment_radius(reference.the_case);
  Vec2 least = reference.the_case.cables.front().anchor;
  Vec2 largest = least;
  for (const Cable& cable : reference.the_case.cables) {
    least = least.cwiseMin(cable.anchor);
    largest = largest.cwiseMax(cable.anchor);
  }
  for (const Point& point : samples(reference)) {
    least = least.cwiseMin(point.state.position - Vec2::Constant(reach));
    largest = largest.cwiseMax(point.state.position + Vec2::Constant(reach));
  }
  return (largest - least).maxCoeff();
}

Nearness nearness_of(const ReferenceCase& reference) {
  const Case& the_case = reference.the_case;
  Covered angle;
  Covered energies;
  std::vector<Covered> gaps(the_case.cables.size());
  for (const Point& point : samples(reference)) {
    angle.take(point.state.angle);
    energies.take(energy(the_case, point.state));
    for (std::size_t index = 0; index < gaps.size(); ++index) {
      gaps[index].take(gap(the_case.cables[index], point.state));
    }
  }
  Nearness nearness;
  nearness.bound = drawn_part * drawn_extent(reference);
  for (std::size_t index = 0; index < gaps.size(); ++index) {
    // a cable that never leaves its length is told by its state
    if (gaps[index].width() > taut_part * the_case.cables[index].length) {
      nearness.bound = std::min(nearness.bound, plotted_part * gaps[index].width());
    }
  }
  constexpr double least_turn = 1e-2;    // [rad]: a motion that turns less is drawn as if it did
  constexpr double least_change = 1e-9;  // [-] of the energy: one that loses less, likewise
  nearness.reach = attachment_radius(the_case);
  nearness.lever =
      std::max(nearness.reach, nearness.bound / plotted_part / std::max(angle.width(), least_turn));
  nearness.energy = plotted_part * std::max({energies.width(), least_change * energies.size(),
                                             std::numeric_limits<double>::min() / plotted_part});
  return nearness;
}

Path run_path(const Case& the_case, const Nearness& nearness, const Trajectory& run) {
  Path path = drawn(samples_of(the_case, run), nearness);
  path.spacing = run.step * static_cast<double>(run.stride);
  path.cables = taut_columns(the_case, run);
  return path;
}

CaseReplay exact_replay(const ReferenceCase& reference) {
  CaseReplay replay;
  replay.path = drawn(samples_of(reference.the_case, reference.solution), nearness_of(reference));
  replay.path.cables = taut_columns(reference.the_case, reference.solution);
  EventColumns& columns = replay.events;
  for (const Event* event : kept_events(reference)) {
    columns.time.push_back(event->time);
    columns.kind.emplace_back(to_string(event->kind));
    const auto cables = event->cables.indices();
    columns.cables.emplace_back(cables.begin(), cables.end());
    columns.rate.push_back(closing_speed(reference.the_case, *event));
  }
  columns.left_out = reference.solution.events().size() - columns.time.size();
  return replay;
}

}  // namespace tautline::bench
