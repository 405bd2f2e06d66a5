#include "bench/replay/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "bench/measure/impact_match.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// Leaves the `most` of `events` that are largest by `speed`, in the order they had.
template <class Event, class Speed>
void keep_fastest(std::vector<Event>& events, std::size_t most, const Speed& speed) {
  if (events.size() <= most) {
    return;
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t index = 0; index < events.size(); ++index) {
    order.emplace_back(-speed(events[index]), index);
  }
  std::sort(order.begin(), order.end());
  order.resize(most);
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
  keep_fastest(impacts, most_impacts,
               [](const RecordedImpact* impact) { return -impact->rate_before; });
  return impacts;
}

/// Closing speed of the fastest cable of an impact [m/s]; none of another event.
std::optional<double> impact_speed(const Case& the_case, const Event& event) {
  if (event.kind != EventKind::impact) {
    return std::nullopt;
  }
  return closing_speed(the_case, event.cables, event.before);
}

/// The events that the report has.
std::vector<const Event*> kept_events(const ReferenceCase& reference) {
  std::vector<const Event*> events;
  for (const Event& event : reference.solution.events()) {
    events.push_back(&event);
  }
  keep_fastest(events, most_drawn, [&](const Event* event) {
    // what is no impact is rare and always kept
    return impact_speed(reference.the_case, *event)
        .value_or(std::numeric_limits<double>::infinity());
  });
  return events;
}

/// The gap of a cable at one instant.
struct Gap {
  double time;   // [s]
  double value;  // [m]
};

/// The gaps recorded while a cable was taut, from the first to the last.
using Stretch = std::vector<Gap>;

/// A page shows the gap on a taut cable by this part of the motion [-].
constexpr double shown_part = 1e-2;

/// And the instants where it was so to this part of the motion [-]: a tenth of a pixel.
constexpr double instant_part = 1e-5;

/// Three digits say how large a rest is.
double three_digits(double value) {
  return std::strtod(fmt::format("{:.3g}", value).c_str(), nullptr);
}

TautColumns columns_of(const std::vector<Stretch>& stretches, double duration) {
  std::vector<double> times;
  std::vector<double> gap_times;
  TautColumns columns;
  const auto show = [&](const Gap& gap) {
    gap_times.push_back(gap.time);
    columns.gap.push_back(three_digits(gap.value));
  };
  for (const Stretch& stretch : stretches) {
    times.insert(times.end(), {stretch.front().time, stretch.back().time});
    auto from = stretch.begin();
    while (stretch.back().time - stretch.front().time >= shown_part * duration &&
           from != stretch.end()) {
      const auto to = std::find_if(from, stretch.end(), [&](const Gap& gap) {
        return gap.time - from->time >= shown_part * duration;
      });
      const auto [least, largest] = std::minmax_element(
          from, to, [](const Gap& a, const Gap& b) { return a.value < b.value; });
      show(*std::min(least, largest));
      if (least != largest) {
        show(*std::max(least, largest));
      }
      from = to;
    }
  }
  const double fine = std::max(duration, 1e-300) * 1e-9;  // [s]: no engine steps as finely
  columns.times = on_grid(times, fine);
  columns.gap_times = on_grid(gap_times, instant_part / 1e-9 * fine);
  return columns;
}

bool long_enough(const Stretch& stretch) {
  return stretch.size() > 1 && stretch.back().time - stretch.front().time >= shortest_hold;
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
    columns.rate.push_back(impact_speed(reference.the_case, *event));
  }
  columns.left_out = reference.solution.events().size() - columns.time.size();
  return replay;
}

std::vector<TautColumns> taut_columns(const Case& the_case, const Trajectory& run) {
  std::vector<TautColumns> result;
  for (const Cable& cable : the_case.cables) {
    std::vector<Stretch> stretches;
    Stretch now;
    const auto end_stretch = [&] {
      if (long_enough(now)) {
        stretches.push_back(std::move(now));
      }
      now = {};
    };
    for (const Point& point : run.points) {
      const Gap here{point.time, gap(cable, point.state)};
      if (!(here.value <= taut_part * cable.length)) {
        end_stretch();
      } else if (std::isfinite(here.value)) {
        now.push_back(here);
      }
    }
    end_stretch();
    result.push_back(columns_of(stretches, the_case.duration));
  }
  return result;
}

std::vector<TautColumns> taut_columns(const Case& the_case, const Solution& solution) {
  constexpr double fine = 1000.0;  // parts of the whole motion, each with a gap
  std::vector<TautColumns> result;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const Cable& cable = the_case.cables[index];
    std::vector<Stretch> stretches;
    bool held = false;  // at the end of the arc before
    for (const Arc& arc : solution.arcs_until(solution.end_time())) {
      if (!arc.taut.contains(index)) {
        held = false;
        continue;
      }
      if (!std::exchange(held, true)) {
        stretches.emplace_back();
      }
      const double length = arc.end - arc.start;
      const std::size_t parts = 1 + static_cast<std::size_t>(fine * length / solution.end_time());
      for (std::size_t part = 0; part <= parts; ++part) {
        const double dt = length * static_cast<double>(part) / static_cast<double>(parts);
        stretches.back().push_back({arc.start + dt, gap(cable, arc.after(dt, solution.gravity()))});
      }
    }
    result.push_back(columns_of(stretches, solution.end_time()));
  }
  return result;
}

}  // namespace tautline::bench
