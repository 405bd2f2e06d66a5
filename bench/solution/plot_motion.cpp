#include "bench/solution/plot_motion.hpp"

#include <algorithm>

#include "bench/base/listed.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

constexpr std::size_t path_points = 4000;  // a finer path is not seen

/// Every impact, the fastest first.
std::vector<Mark> marks_of(const Case& the_case, const Solution& solution) {
  std::vector<Mark> marks;
  for (const Event& event : solution.events()) {
    if (event.kind != EventKind::impact) {
      continue;
    }
    double speed = 0.0;
    for (const std::size_t index : event.cables) {
      speed = std::max(speed, -gap_rate(the_case.cables[index], event.before));
    }
    marks.push_back({speed, event.before});
  }
  std::stable_sort(marks.begin(), marks.end(),
                   [](const Mark& a, const Mark& b) { return a.speed > b.speed; });
  return marks;
}

/// Points of the path in rising time: evenly in time, and at the ends of every arc while they fit.
std::vector<Vec2> path_of(const Solution& solution) {
  const double end = solution.end_time();
  std::vector<double> times;
  for (std::size_t index = 0; index <= path_points; ++index) {
    times.push_back(end * static_cast<double>(index) / static_cast<double>(path_points));
  }
  if (solution.arcs().size() <= path_points) {
    for (const Arc& arc : solution.arcs()) {
      times.push_back(std::min(arc.start, end));
    }
  }
  std::sort(times.begin(), times.end());
  return listed(times, [&](double time) { return solution.at(time).position; });
}

/// The unit vector down; where nothing pulls, down on the sheet.
Vec2 down(const Case& the_case) {
  const double size = the_case.gravity.norm();
  return size > 0.0 ? Vec2(the_case.gravity / size) : Vec2(0.0, -1.0);
}

}  // namespace

PlotMotion plot_motion(const Case& the_case, const Solution& solution) {
  return {the_case, solution, path_of(solution), marks_of(the_case, solution),
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
