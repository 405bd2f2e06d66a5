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
#include "tautline/system_geometry.hpp"

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

/// The columns of the plane.
void put(std::vector<CurveColumns<3>> bodies, Path& path) {
  CurveColumns<3>& one = bodies.front();
  path.error = one.error;
  path.time = std::move(one.time);
  path.x = std::move(one.places[0]);
  path.y = std::move(one.places[1]);
  path.angle = std::move(one.places[2]);
  path.x_bends = std::move(one.bends[0]);
  path.y_bends = std::move(one.bends[1]);
  path.angle_bends = std::move(one.bends[2]);
}
/// Those of space.
void put(std::vector<BodyPath> bodies, Path& path) {
  for (const BodyPath& body : bodies) {
    path.error = std::max(path.error, body.error);
  }
  path.bodies = std::move(bodies);
}

/// A path through `bodies`, the samples of each; without columns where one has none.
template <int N>
Path drawn(const std::vector<std::vector<Sample<N>>>& bodies, const Nearness& nearness) {
  Path path;
  if (std::any_of(bodies.begin(), bodies.end(), [](const auto& one) { return one.empty(); })) {
    return path;
  }
  std::vector<CurveColumns<N>> columns;
  for (std::size_t body = 0; body < bodies.size(); ++body) {
    columns.push_back(drawn_motion(bodies[body], nearness.bound, nearness.bodies[body],
                                   most_pieces / bodies.size()));
  }
  put(std::move(columns), path);
  DrawnLine line = drawn_line(energies(bodies.front()), nearness.energy, most_pieces);
  path.energy_time = std::move(line.line.time);
  path.energy = std::move(line.line.value);
  path.energy_error = line.error;
  return path;
}

/// The counted impacts that the report has, in rising time.
template <class TheCase>
std::vector<const BasicRecordedImpact<TheCase>*> kept_impacts(const BasicTrajectory<TheCase>& run,
                                                              double count_speed) {
  std::vector<const BasicRecordedImpact<TheCase>*> impacts = counted(run, count_speed);
  keep_fastest(impacts, most_impacts, [](const auto* impact) { return -impact->rate_before; });
  return impacts;
}

/// Closing speed of the fastest cable of an impact [m/s]; none of another event.
template <class TheCase>
std::optional<double> impact_speed(const TheCase& the_case, const BasicEvent<TheCase>& event) {
  if (event.kind != EventKind::impact) {
    return std::nullopt;
  }
  return closing_speed(the_case, event.cables, event.before);
}

/// The events that the report has.
template <class TheCase>
std::vector<const BasicEvent<TheCase>*> kept_events(const TheCase& the_case,
                                                    const BasicSolution<TheCase>& solution) {
  std::vector<const BasicEvent<TheCase>*> events;
  for (const BasicEvent<TheCase>& event : solution.events()) {
    events.push_back(&event);
  }
  keep_fastest(events, most_drawn, [&](const auto* event) {
    // what is no impact is rare and always kept
    return impact_speed(the_case, *event).value_or(std::numeric_limits<double>::infinity());
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

double length_at(const Cable& cable, double /*time*/) { return cable.length; }
double length_at(const SpatialCable& cable, double time) { return cable.length.at(time)[0]; }

/// For every cable of a run, when it is taut, as the recorded points tell.
template <class TheCase>
std::vector<TautColumns> taut_columns(const TheCase& the_case,
                                      const BasicTrajectory<TheCase>& run) {
  std::vector<TautColumns> result;
  for (const auto& cable : the_case.cables) {
    std::vector<Stretch> stretches;
    Stretch now;
    const auto end_stretch = [&] {
      if (long_enough(now)) {
        stretches.push_back(std::move(now));
      }
      now = {};
    };
    for (const BasicPoint<TheCase>& point : run.points) {
      const Gap here{point.time, gap(cable, point.state)};
      if (!(here.value <= taut_part * length_at(cable, point.time))) {
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

/// The instants of an arc at which a page shows a gap or a tension [s], from its start.
template <class TheCase>
std::vector<double> shown_instants(const BasicArc<TheCase>& arc, double end_time) {
  constexpr double fine = 1000.0;  // parts of the whole motion
  const double length = arc.end - arc.start;
  const std::size_t parts = 1 + static_cast<std::size_t>(fine * length / end_time);
  std::vector<double> result;
  for (std::size_t part = 0; part <= parts; ++part) {
    result.push_back(length * static_cast<double>(part) / static_cast<double>(parts));
  }
  return result;
}

/// The same of the exact motion, as its taut and slack events tell.
template <class TheCase>
std::vector<TautColumns> taut_columns(const TheCase& the_case,
                                      const BasicSolution<TheCase>& solution) {
  std::vector<TautColumns> result;
  const auto arcs = solution.arcs_until(solution.end_time());
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const auto& cable = the_case.cables[index];
    std::vector<Stretch> stretches;
    bool held = false;  // at the end of the arc before
    for (const BasicArc<TheCase>& arc : arcs) {
      if (!arc.taut.contains(index)) {
        held = false;
        continue;
      }
      if (!std::exchange(held, true)) {
        stretches.emplace_back();
      }
      for (const double dt : shown_instants(arc, solution.end_time())) {
        stretches.back().push_back({arc.start + dt, gap(cable, arc.after(dt, solution.gravity()))});
      }
    }
    result.push_back(columns_of(stretches, solution.end_time()));
  }
  return result;
}

/// The tensions of each cable over the exact motion [N].
std::vector<std::vector<Level>> tensions_of(const SpatialSystem& system,
                                            const BasicSolution<SpatialSystem>& solution) {
  std::vector<std::vector<Level>> result(system.cables.size());
  for (const BasicArc<SpatialSystem>& arc : solution.arcs_until(solution.end_time())) {
    for (const double dt : arc.taut.empty() ? std::vector<double>{0.0, arc.end - arc.start}
                                            : shown_instants(arc, solution.end_time())) {
      CableVector now = CableVector::Zero(static_cast<Eigen::Index>(result.size()));
      if (!arc.taut.empty()) {
        now = solution.tensions(arc, dt);
      }
      for (std::size_t index = 0; index < result.size(); ++index) {
        const double tension = now[static_cast<Eigen::Index>(index)];
        result[index].push_back({arc.start + dt, std::isfinite(tension) ? tension : 0.0});
      }
    }
  }
  return result;
}

/// The tensions of a run as its engine tells them; none if it does not.
std::vector<std::vector<Level>> tensions_of(const SpatialSystem& system,
                                            const SystemTrajectory& run) {
  std::vector<std::vector<Level>> result;
  const std::size_t cables = system.cables.size();
  for (std::size_t index = 0; index < (run.tensions.empty() ? 0 : cables); ++index) {
    std::vector<Level>& levels = result.emplace_back();
    for (std::size_t point = 1; point < run.points.size(); ++point) {
      const double tension = run.tensions[point * cables + index];
      if (std::isfinite(tension)) {
        levels.push_back({run.points[point].time, tension});
      }
    }
  }
  return result;
}

void draw_tensions(const std::vector<std::vector<Level>>& tensions, double bound, Path& path) {
  for (std::size_t index = 0; index < tensions.size() && bound > 0.0; ++index) {
    if (!tensions[index].empty()) {
      path.cables[index].tension = drawn_line(tensions[index], bound, most_tension_pieces).line;
    }
  }
}

/// The taut cables of a motion, in space with their tensions.
void draw_cables(const Case& the_case, const auto& motion, const Nearness& /*nearness*/,
                 Path& path) {
  path.cables = taut_columns(the_case, motion);
}
void draw_cables(const SpatialSystem& system, const auto& motion, const Nearness& nearness,
                 Path& path) {
  path.cables = taut_columns(system, motion);
  draw_tensions(tensions_of(system, motion), nearness.tension, path);
}

/// Adds the numbers of an impact that are known in the plane alone.
void put_arm(const Cable& cable, const RecordedImpact& impact, ImpactColumns& columns) {
  const Eigen::Vector3d pull = gap_gradient(cable, impact.before);
  const Vec2 across = perpendicular(Vec2(pull.head<2>()));
  columns.arm.push_back(pull[2]);
  columns.tangential_error.push_back(across.dot(Vec2(impact.stray.head<2>())));
  columns.angular_error.push_back(impact.stray[2]);
}
void put_arm(const SpatialCable& /*cable*/, const BasicRecordedImpact<SpatialSystem>& /*impact*/,
             ImpactColumns& columns) {
  for (auto* column : {&columns.arm, &columns.tangential_error, &columns.angular_error}) {
    column->push_back(std::numeric_limits<double>::quiet_NaN());
  }
}

/// The exact motion now and then, and the state after every event.
std::vector<Point> points_of(const ReferenceCase& reference) { return samples(reference); }
std::vector<BasicPoint<SpatialSystem>> points_of(const ReferenceSystem& reference) {
  const auto& solution = reference.solution;
  std::vector<BasicPoint<SpatialSystem>> points;
  for (const auto& event : solution.events()) {
    points.push_back({event.time, event.after});
  }
  for (std::size_t index = 0; index < exact_samples; ++index) {
    const double time =
        solution.end_time() * std::min(1.0, static_cast<double>(index) / (exact_samples - 1));
    points.push_back({time, solution.at(time)});
  }
  return points;
}

/// How far the picture of each body reaches from its centre [m].
std::vector<double> reaches(const Case& the_case) { return {attachment_radius(the_case)}; }
std::vector<double> reaches(const SpatialSystem& system) {
  std::vector<double> result;
  for (const SpatialBody& body : system.bodies) {
    result.push_back(box_radius(body));
  }
  for (const SpatialCable& cable : system.cables) {
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      if (const SpatialEnd& end = cable.end(i); end.body) {
        result[*end.body] = std::max(result[*end.body], end.at.norm());
      }
    }
  }
  return result;
}

/// Calls `use` with every point that a picture has to show: the anchors, and the ends of boxes
/// around the bodies of the exact motion.
void each_shown(const ReferenceCase& reference, const auto& use) {
  for (const Cable& cable : reference.the_case.cables) {
    use(cable.anchor);
  }
  const Vec2 reach = Vec2::Constant(attachment_radius(reference.the_case));
  for (const Point& point : samples(reference)) {
    use(Vec2(point.state.position - reach));
    use(Vec2(point.state.position + reach));
  }
}
void each_shown(const ReferenceSystem& reference, const auto& use) {
  const std::vector<double> reach = reaches(reference.the_case);
  for (const auto& point : points_of(reference)) {
    for (const SpatialCable& cable : reference.the_case.cables) {
      for (std::size_t i = 0; i <= cable.segments(); ++i) {
        if (!cable.end(i).body) {
          use(moving_point(cable.end(i), point.state).position);
        }
      }
    }
    for (std::size_t body = 0; body < reach.size(); ++body) {
      const Eigen::Vector3d& centre = point.state.bodies[body].position;
      use(Eigen::Vector3d(centre - Eigen::Vector3d::Constant(reach[body])));
      use(Eigen::Vector3d(centre + Eigen::Vector3d::Constant(reach[body])));
    }
  }
}

/// How far each body turns over `points` [rad].
std::vector<double> turns(const std::vector<Point>& points) {
  Covered angle;
  for (const Point& point : points) {
    angle.take(point.state.angle);
  }
  return {angle.width()};
}
std::vector<double> turns(const std::vector<BasicPoint<SpatialSystem>>& points) {
  std::vector<double> result(points.front().state.bodies.size(), 0.0);
  for (const auto& point : points) {
    for (std::size_t body = 0; body < result.size(); ++body) {
      result[body] = std::max(
          result[body], turn_between(point.state.bodies[body], points.front().state.bodies[body]));
    }
  }
  return result;
}

/// The largest tension of the exact motion of a system [N].
double largest_tension(const ReferenceCase& /*reference*/) { return 0.0; }
double largest_tension(const ReferenceSystem& reference) {
  double largest = 0.0;
  for (const auto& levels : tensions_of(reference.the_case, reference.solution)) {
    for (const Level& level : levels) {
      largest = std::max(largest, level.value);
    }
  }
  return largest;
}

}  // namespace

double box_radius(const SpatialBody& body) {
  return std::sqrt(1.5 * body.inertia.sum() / body.mass);
}

template <class TheCase>
ImpactColumns run_impacts(const TheCase& the_case, const BasicTrajectory<TheCase>& run,
                          double count_speed) {
  const auto impacts = kept_impacts(run, count_speed);
  ImpactColumns columns;
  for (const BasicRecordedImpact<TheCase>* impact : impacts) {
    const auto& cable = the_case.cables[impact->cable];
    columns.time.push_back(impact->time);
    columns.cable.push_back(impact->cable);
    columns.requested.push_back(restitution(cable, impact->rate_before));
    columns.rate_before.push_back(impact->rate_before);
    columns.rate_after.push_back(impact->rate_after);
    put_arm(cable, *impact, columns);
    columns.steps.push_back(impact->steps);
  }
  columns.left_out = counted(run, count_speed).size() - impacts.size();
  return columns;
}
template ImpactColumns run_impacts(const Case&, const Trajectory&, double);
template ImpactColumns run_impacts(const SpatialSystem&, const SystemTrajectory&, double);

template <class TheReference>
double drawn_extent(const TheReference& reference) {
  Eigen::Array3d least = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Array3d largest = -least;
  each_shown(reference, [&](const auto& point) {
    for (Eigen::Index k = 0; k < point.size(); ++k) {
      least[k] = std::min(least[k], point[k]);
      largest[k] = std::max(largest[k], point[k]);
    }
  });
  const double extent = (largest - least).maxCoeff();
  return extent > 0.0 ? extent : 1.0;  // a point mass that stays where it is
}
template double drawn_extent(const ReferenceCase&);
template double drawn_extent(const ReferenceSystem&);

template <class TheReference>
Nearness nearness_of(const TheReference& reference) {
  const auto& the_case = reference.the_case;
  const auto points = points_of(reference);
  Covered energies;
  std::vector<Covered> gaps(the_case.cables.size());
  for (const auto& point : points) {
    energies.take(energy(the_case, point.state));
    for (std::size_t index = 0; index < gaps.size(); ++index) {
      if (const double value = gap(the_case.cables[index], point.state); std::isfinite(value)) {
        gaps[index].take(value);
      }
    }
  }
  Nearness nearness;
  nearness.bound = drawn_part * drawn_extent(reference);
  for (std::size_t index = 0; index < gaps.size(); ++index) {
    // a cable that never leaves its length is told by its state
    if (gaps[index].width() > taut_part * length_at(the_case.cables[index], 0.0)) {
      nearness.bound = std::min(nearness.bound, plotted_part * gaps[index].width());
    }
  }
  constexpr double least_turn = 1e-2;    // [rad]: a motion that turns less is drawn as if it did
  constexpr double least_change = 1e-9;  // [-] of the energy: one that loses less, likewise
  const std::vector<double> angles = turns(points);
  for (const double reach : reaches(the_case)) {
    const double angle = std::max(angles[nearness.bodies.size()], least_turn);
    nearness.bodies.push_back({reach, std::max(reach, nearness.bound / plotted_part / angle)});
  }
  nearness.energy = plotted_part * std::max({energies.width(), least_change * energies.size(),
                                             std::numeric_limits<double>::min() / plotted_part});
  nearness.tension = coloured_part * largest_tension(reference);
  return nearness;
}
template Nearness nearness_of(const ReferenceCase&);
template Nearness nearness_of(const ReferenceSystem&);

template <class TheCase>
Path run_path(const TheCase& the_case, const Nearness& nearness,
              const BasicTrajectory<TheCase>& run) {
  Path path = drawn(samples_of(the_case, run), nearness);
  path.spacing = run.step * static_cast<double>(run.stride);
  draw_cables(the_case, run, nearness, path);
  return path;
}
template Path run_path(const Case&, const Nearness&, const Trajectory&);
template Path run_path(const SpatialSystem&, const Nearness&, const SystemTrajectory&);

template <class TheReference>
CaseReplay exact_replay(const TheReference& reference) {
  const auto& [the_case, solution, settling, horizon, law] = reference;
  const Nearness nearness = nearness_of(reference);
  CaseReplay replay;
  replay.path = drawn(samples_of(the_case, solution), nearness);
  draw_cables(the_case, solution, nearness, replay.path);
  EventColumns& columns = replay.events;
  for (const auto* event : kept_events(the_case, solution)) {
    columns.time.push_back(event->time);
    columns.kind.emplace_back(to_string(event->kind));
    const auto cables = event->cables.indices();
    columns.cables.emplace_back(cables.begin(), cables.end());
    columns.rate.push_back(impact_speed(the_case, *event));
  }
  columns.left_out = solution.events().size() - columns.time.size();
  return replay;
}
template CaseReplay exact_replay(const ReferenceCase&);
template CaseReplay exact_replay(const ReferenceSystem&);

}  // namespace tautline::bench
