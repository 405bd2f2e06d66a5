// What a picture of a motion shows, and its geometry.

#include "bench/plot/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/base/text.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Coordinates are cut here: differences and squares of them stay finite [m].
constexpr double largest_coordinate = 1e150;

constexpr std::size_t path_points = 40'000;  // half a megabyte: more would be a smear

/// The path in rising time: a chord of it lies less than the width of its line from the motion,
/// however long that is. It ends early where it has more points than a picture can show.
struct Path {
  std::vector<Vec2> points;
  double end;  // [s]
};
/// It has `most` points, each of them `place(arc, time since its start)`.
template <class TheCase, class Place>
Path path_of(const BasicSolution<TheCase>& solution, const Place& place, std::size_t most) {
  const auto& arcs = solution.arcs();
  const std::size_t count = arcs.size();  // what repeats lies on its first period
  const auto position = [&](const BasicArc<TheCase>& arc, double part) {
    return place(arc, part * (arc.end - arc.start));
  };
  Extent extent;
  for (std::size_t index = 0; index < count; ++index) {
    extent.add(position(arcs[index], 0.0));
    extent.add(position(arcs[index], 0.5));
    extent.add(position(arcs[index], 1.0));
  }
  constexpr double sharpness = 4000.0;  // [-], of the path's size: a sixth of a pixel
  const double chord = std::max(extent.size().maxCoeff(), 1e-300) / sharpness;
  Path result{{position(arcs.front(), 0.0)}, arcs.front().start};
  for (std::size_t index = 0; index < count && result.points.size() < most; ++index) {
    const BasicArc<TheCase>& arc = arcs[index];
    const Vec2 first = position(arc, 0.0);
    const Vec2 last = position(arc, 1.0);
    double deepest = 0.0;  // [m], of the arc's chord: that of n parts is smaller by n^2
    for (const double part : {0.25, 0.5, 0.75}) {
      deepest =
          std::max(deepest, (position(arc, part) - (1.0 - part) * first - part * last).norm());
    }
    constexpr double most_parts = 500.0;  // of one flight, or where its numbers are too large
    const double wanted = std::ceil(std::sqrt(deepest / chord));
    const int parts =
        std::isfinite(wanted) ? static_cast<int>(std::clamp(wanted, 1.0, most_parts)) : 1;
    for (int k = 1; k <= parts; ++k) {
      result.points.push_back(position(arc, static_cast<double>(k) / parts));
    }
    result.end = arc.end;
  }
  if (result.points.size() < most) {
    result.end = solution.end_time();
  }
  return result;
}

/// The unit vector down; where nothing pulls, down on the sheet.
Vec2 down_by(const Vec2& gravity) {
  const double size = gravity.norm();
  return size > 0.0 ? Vec2(gravity / size) : Vec2(0.0, -1.0);
}

Pose pose_of(const Case& the_case, const State& state, CableSet taut) {
  Pose result{{{state.position, {}}}, {}};
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const Cable& cable = the_case.cables[index];
    const Vec2 end = attachment_point(state, cable);
    result.bodies.front().points.push_back(end);
    result.cables.push_back(
        {index,
         {cable.anchor, end},
         cable.length,
         taut.contains(index) || gap(cable, state) <= gap_rounding * cable.length});
  }
  return result;
}

Pose pose_of(const System& system, const SystemState& state, CableSet taut) {
  Pose result;
  for (const State& body : state.bodies) {
    result.bodies.push_back({body.position, {}});
  }
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const CableOfSystem& cable = system.cables[index];
    DrawnCable drawn{index, {}, cable.length.at(state.time)[0], false};
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      drawn.points.push_back(moving_point(cable.end(i), state).position);
      if (cable.end(i).body) {
        result.bodies[*cable.end(i).body].points.push_back(drawn.points.back());
      }
    }
    if (cable.acts_at(state.time)) {
      drawn.taut = taut.contains(index) || gap(cable, state) <= gap_rounding * drawn.length;
      result.cables.push_back(std::move(drawn));
    }
  }
  return result;
}

/// The places of the bodies that the cables of an event hold.
std::vector<Vec2> places_of(const Case& /*the_case*/, const Event& event) {
  return {event.before.position};
}

std::vector<Vec2> places_of(const System& system, const BasicEvent<System>& event) {
  std::vector<bool> held(system.bodies.size());
  for (const std::size_t index : event.cables) {
    const CableOfSystem& cable = system.cables[index];
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      if (cable.end(i).body) {
        held[*cable.end(i).body] = true;
      }
    }
  }
  std::vector<Vec2> result;
  for (std::size_t body = 0; body < held.size(); ++body) {
    if (held[body]) {
      result.push_back(event.before.bodies[body].position);
    }
  }
  return result;
}

/// Paths, impacts and poses: what cases and systems share.
template <class TheCase>
PlotMotion drawn_motion(const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  PlotMotion result;
  result.name = the_case.name;
  result.end_time = solution.end_time();
  result.ending = solution.ending();
  result.path_end = result.end_time;
  const std::size_t bodies = bodies_of(the_case.initial).size();
  for (std::size_t body = 0; body < bodies; ++body) {
    Path path = path_of(
        solution,
        [&](const BasicArc<TheCase>& arc, double dt) {
          return bodies_of(arc.after(dt, solution.gravity()))[body].position;
        },
        path_points / bodies);
    result.paths.push_back(std::move(path.points));
    result.path_end = std::min(result.path_end, path.end);
  }
  result.marks = impact_marks(the_case, solution);
  for (std::size_t index = 0; index < std::min(faint_bodies, result.marks.size()); ++index) {
    const auto& event = solution.events()[result.marks[index].event];
    result.fastest.push_back(pose_of(the_case, event.before, {}));
  }
  result.start = pose_of(the_case, the_case.initial, solution.arcs().front().taut);
  result.end = pose_of(the_case, solution.at(result.end_time), solution.arcs().back().taut);
  const std::size_t cables = the_case.cables.size();
  result.subject =
      fmt::format("{} on {} cable{}", bodies == 1 ? "a body" : fmt::format("{} bodies", bodies),
                  cables, cables == 1 ? "" : "s");
  return result;
}

}  // namespace

void Extent::add(const Vec2& point) {
  if (!point.allFinite()) {
    return;
  }
  const Vec2 inside = point.cwiseMax(-largest_coordinate).cwiseMin(largest_coordinate);
  low_ = empty_ ? inside : Vec2(low_.cwiseMin(inside));
  high_ = empty_ ? inside : Vec2(high_.cwiseMax(inside));
  empty_ = false;
}

Extent Extent::with_margin() const {
  constexpr double margin = 0.06;    // around the points, as a share of the larger side [-]
  constexpr double thinnest = 0.25;  // of the larger side: a motion on a line needs room too [-]
  const double scale = std::max({low_.cwiseAbs().maxCoeff(), high_.cwiseAbs().maxCoeff(), 1e-150});
  // a body that does not move has no extent; below this, coordinates are not told apart
  const double larger = std::max(size().maxCoeff(), 1e-9 * scale);
  Extent result = *this;
  for (int axis = 0; axis < 2; ++axis) {
    const double missing = std::max(0.0, thinnest * larger - size()[axis]);
    result.low_[axis] -= 0.5 * missing + margin * larger;
    result.high_[axis] += 0.5 * missing + margin * larger;
  }
  return result;
}

double sag(double length, double chord) {
  return chord < length ? std::sqrt(3.0 / 16.0) * std::sqrt((length - chord) * (length + chord))
                        : 0.0;
}

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vec2> hull;
  // points of one line, which rounding has moved off it, stay on it [m^2]
  const double in_line =
      points.empty() ? 0.0 : 1e-9 * (points.back() - points.front()).squaredNorm();
  const auto go_round = [&](auto first, auto last) {  // Andrew's monotone chain, one half
    const std::size_t start = hull.size();
    for (; first != last; ++first) {
      while (hull.size() >= start + 2 &&
             cross<double>(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= in_line) {
        hull.pop_back();
      }
      hull.push_back(*first);
    }
    hull.pop_back();  // begins the other half
  };
  if (points.size() < 3) {
    return points;
  }
  go_round(points.begin(), points.end());
  go_round(points.rbegin(), points.rend());
  return hull;
}

std::string body_name(const BodyOfSystem& body, std::size_t index) {
  constexpr std::size_t longest = 24;  // [bytes]
  return body.name.empty() ? fmt::format("body {}", index) : printable(body.name, longest);
}

std::string horizon_words(const SystemMotion& motion) {
  return motion.horizon ? fmt::format("; one of many motions from t = {:.6g} s on", *motion.horizon)
                        : "";
}

template <class TheCase>
std::vector<Mark> impact_marks(const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  std::vector<Mark> marks;
  for (std::size_t place = 0; place < solution.events().size(); ++place) {
    const BasicEvent<TheCase>& event = solution.events()[place];
    if (event.kind != EventKind::impact) {
      continue;
    }
    double fastest = 0.0;
    for (const std::size_t index : event.cables) {
      fastest = std::max(fastest, -gap_rate(the_case.cables[index], event.before));
    }
    marks.push_back({fastest, event.time, place, places_of(the_case, event)});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.speed > b.speed; });
  return marks;
}
template std::vector<Mark> impact_marks(const Case& the_case, const Solution& solution);
template std::vector<Mark> impact_marks(const System& system,
                                        const BasicSolution<System>& solution);

PlotMotion plot_motion(const Case& the_case, const Solution& solution) {
  PlotMotion result = drawn_motion(the_case, solution);
  result.down = down_by(the_case.gravity);
  for (const Cable& cable : the_case.cables) {
    result.anchors.push_back(cable.anchor);
  }
  return result;
}

PlotMotion plot_motion(const System& system, const BasicSolution<System>& solution) {
  PlotMotion result = drawn_motion(system, solution);
  result.down = down_by(system.gravity.at(0.0));
  for (std::size_t index = 0; system.bodies.size() > 1 && index < system.bodies.size(); ++index) {
    result.bodies.push_back(body_name(system.bodies[index], index));
  }
  result.numbers_cables = system.cables.size() > 1;
  const SystemState last = solution.at(result.end_time);
  for (const CableOfSystem& cable : system.cables) {
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      const End& end = cable.end(i);
      const bool ring = i > 0 && i < cable.segments();
      if (!end.body || ring) {
        (ring ? result.rings : result.anchors).push_back(moving_point(end, last).position);
      }
      if (!end.body && !end.motion.empty()) {
        const auto place = [&](const BasicArc<System>& arc, double dt) {
          return moving_point(end, SystemState{arc.start + dt, {}}).position;
        };
        result.moving.push_back(path_of(solution, place, path_points / max_bodies).points);
      }
    }
  }
  return result;
}

Vec2 lowest_point(const Vec2& from, const Vec2& to, double length, const Vec2& down) {
  return 0.5 * (from + to) + sag(length, (to - from).norm()) * down;
}

Extent extent_of_bodies(const PlotMotion& motion) {
  Extent result;
  const auto add = [&](const std::vector<Vec2>& points) {
    for (const Vec2& point : points) {
      result.add(point);
    }
  };
  std::for_each(motion.paths.begin(), motion.paths.end(), add);
  for (const Pose* pose : {&motion.start, &motion.end}) {
    for (const DrawnBody& body : pose->bodies) {
      add(body.points);
    }
  }
  for (const Pose& pose : motion.fastest) {
    for (const DrawnBody& body : pose.bodies) {
      add(body.points);
    }
  }
  return result;
}

Extent extent_of_all(const PlotMotion& motion) {
  Extent result = extent_of_bodies(motion);
  for (const Pose* pose : {&motion.start, &motion.end}) {
    for (const DrawnCable& cable : pose->cables) {
      each_part(cable, [&](const Vec2& from, const Vec2& to, double length) {
        result.add(from);
        result.add(to);
        result.add(lowest_point(from, to, length, motion.down));
      });
    }
  }
  for (const auto* points : {&motion.anchors, &motion.rings}) {
    std::for_each(points->begin(), points->end(), [&](const Vec2& one) { result.add(one); });
  }
  for (const std::vector<Vec2>& path : motion.moving) {
    std::for_each(path.begin(), path.end(), [&](const Vec2& one) { result.add(one); });
  }
  return result;
}

}  // namespace tautline::bench
