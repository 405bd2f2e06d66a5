// What a picture of a motion shows, and its geometry.

#include "bench/plot/motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tautline/geometry.hpp"

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
Path path_of(const Solution& solution) {
  const auto& arcs = solution.arcs();
  const std::size_t count = arcs.size();  // what repeats lies on its first period
  const auto position = [&](const Arc& arc, double part) {
    return arc.after(part * (arc.end - arc.start), solution.gravity()).position;
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
  for (std::size_t index = 0; index < count && result.points.size() < path_points; ++index) {
    const Arc& arc = arcs[index];
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
  if (result.points.size() < path_points) {
    result.end = solution.end_time();
  }
  return result;
}

/// The unit vector down; where nothing pulls, down on the sheet.
Vec2 down(const Case& the_case) {
  const double size = the_case.gravity.norm();
  return size > 0.0 ? Vec2(the_case.gravity / size) : Vec2(0.0, -1.0);
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

std::vector<Mark> impact_marks(const Case& the_case, const Solution& solution) {
  std::vector<Mark> marks;
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    marks.push_back(
        {closing_speed(the_case, event.cables, event.before), event.time, event.before});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.speed > b.speed; });
  return marks;
}

PlotMotion plot_motion(const Case& the_case, const Solution& solution) {
  Path path = path_of(solution);
  return {the_case,
          solution,
          std::move(path.points),
          path.end,
          impact_marks(the_case, solution),
          solution.at(solution.end_time())};
}

Vec2 lowest_point(const Case& the_case, const Cable& cable, const State& state) {
  const Vec2 end = attachment_point(state, cable);
  return 0.5 * (cable.anchor + end) +
         sag(cable.length, (end - cable.anchor).norm()) * down(the_case);
}

Extent extent_of_bodies(const PlotMotion& motion) {
  Extent result;
  for (const Vec2& point : motion.path) {
    result.add(point);
  }
  for (const Cable& cable : motion.the_case.cables) {
    for (const State& state : {motion.the_case.initial, motion.end}) {
      result.add(attachment_point(state, cable));
    }
    for (std::size_t index = 0; index < std::min(faint_bodies, motion.marks.size()); ++index) {
      result.add(attachment_point(motion.marks[index].pose, cable));
    }
  }
  return result;
}

Extent extent_of_all(const PlotMotion& motion) {
  Extent result = extent_of_bodies(motion);
  for (const Cable& cable : motion.the_case.cables) {
    result.add(cable.anchor);
    result.add(lowest_point(motion.the_case, cable, motion.the_case.initial));
    result.add(lowest_point(motion.the_case, cable, motion.end));
  }
  return result;
}

}  // namespace tautline::bench
