#include "bench/report/html/stills_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

constexpr double still_width = 220.0;  // [px] of a still
constexpr double height = 190.0;       //
constexpr double rim = 16.0;           //

/// A gap below this, of the length, is drawn taut: about a pixel [-].
constexpr double looks_taut = 5e-3;

/// From metres to the pixels of a still.
struct Place {
  double scale;  // [px/m]
  Vec2 middle;   // [m]

  [[nodiscard]] Vec2 operator()(const Vec2& at) const {
    return {0.5 * still_width + scale * (at.x() - middle.x()),
            0.5 * height - scale * (at.y() - middle.y())};
  }
};

/// Points of the way a body came.
constexpr int trail_points = 60;

/// The end of a cable on the body [m].
Vec2 end_of(const CableRow& cable, const Pose& pose) {
  return attachment_point(State{.position = pose.centre, .angle = pose.angle},
                          Cable{.attachment = cable.attachment});
}

/// Room for the anchors and for the body at every still.
Place place_of_stills(const CaseRow& the_case, const DrawnPath& path,
                      const std::array<double, 3>& times) {
  std::vector<Vec2> points;
  for (const CableRow& cable : the_case.geometry) {
    points.push_back(cable.anchor);
    for (const double time : times) {
      points.push_back(end_of(cable, pose_at(path, time)));
      points.push_back(pose_at(path, time).centre);
    }
  }
  Vec2 low = points.front();
  Vec2 high = points.front();
  for (const Vec2& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Vec2 size = (high - low).cwiseMax(1e-9);
  return {std::min((still_width - 2 * rim) / size.x(), (height - 2 * rim) / size.y()),
          0.5 * (low + high)};
}

/// The length of the curve from `from` to `to` that hangs `depth` towards `down` at its control
/// point.
double length_of(const Vec2& from, const Vec2& to, const Vec2& control) {
  constexpr int pieces = 24;
  double sum = 0.0;
  Vec2 before = from;
  for (int piece = 1; piece <= pieces; ++piece) {
    const double t = static_cast<double>(piece) / pieces;
    const Vec2 now = (1 - t) * (1 - t) * from + 2 * t * (1 - t) * control + t * t * to;
    sum += (now - before).norm();
    before = now;
  }
  return sum;
}

/// Where the sagging curve of that length has its control point, by bisection.
Vec2 sag(const Vec2& from, const Vec2& to, double length, const Vec2& gravity) {
  const Vec2 down = gravity.norm() > 0.0 ? Vec2(gravity.normalized()) : Vec2(0.0, -1.0);
  const Vec2 middle = 0.5 * (from + to);
  double low = 0.0;
  double high = 2.0 * length;
  for (int round = 0; round < 40; ++round) {
    const double half = 0.5 * (low + high);
    (length_of(from, to, middle + half * down) < length ? low : high) = half;
  }
  return middle + low * down;
}

std::string cable_svg(const CaseRow& the_case, const CableRow& cable, const Vec2& end,
                      const Place& place, bool struck) {
  const Vec2 from = place(cable.anchor);
  const Vec2 to = place(end);
  const bool is_taut = cable.length - (end - cable.anchor).norm() <= looks_taut * cable.length;
  const std::string look = std::string(is_taut ? "taut" : "slack") + (struck ? " struck" : "");
  if (is_taut) {
    return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"></path>", look,
                       from.x(), from.y(), to.x(), to.y());
  }
  const Vec2 control = place(sag(cable.anchor, end, cable.length, the_case.gravity));
  return fmt::format("<path class=\"{}\" d=\"M{:.1f} {:.1f}Q{:.1f} {:.1f} {:.1f} {:.1f}\"></path>",
                     look, from.x(), from.y(), control.x(), control.y(), to.x(), to.y());
}

std::string anchor_svg(const Vec2& at) {
  return fmt::format(
      "<path class=\"anchor\" d=\"M{:.1f} {:.1f}h14m-14 0l4-5m1 5l4-5m1 5l4-5\"></path>",
      at.x() - 7.0, at.y());
}

std::string body_svg(const CaseRow& the_case, const Pose& pose, const Place& place) {
  const Vec2 centre = place(pose.centre);
  std::string out;
  for (const CableRow& cable : the_case.geometry) {
    const Vec2 end = place(end_of(cable, pose));
    out += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", centre.x(), centre.y(), end.x(), end.y());
  }
  return fmt::format(
      "<path class=\"body\" d=\"{}\"></path><circle class=\"body\" cx=\"{:.1f}\" cy=\"{:.1f}\" "
      "r=\"5\"></circle>",
      out, centre.x(), centre.y());
}

/// The centre from one instant to another.
std::string trail_svg(const DrawnPath& path, double from, double until, const Place& place) {
  std::string points;
  for (int point = 0; point <= trail_points; ++point) {
    const double time = from + (until - from) * point / trail_points;
    const Vec2 at = place(pose_at(path, time).centre);
    points += fmt::format("{}{:.1f} {:.1f}", points.empty() ? "M" : "L", at.x(), at.y());
  }
  return "<path class=\"trail\" d=\"" + points + "\"></path>";
}

}  // namespace

Pose pose_at(const DrawnPath& path, double time) {
  const Eigen::Vector3d pose = path.pose(time);
  return {Vec2(pose.head<2>()), pose[2]};
}

double gap_of(const CableRow& cable, const Pose& pose) {
  return cable.length - (end_of(cable, pose) - cable.anchor).norm();
}

std::string still_svg(const CaseRow& the_case, const DrawnPath& path,
                      const std::array<double, 3>& times, std::size_t still, std::size_t struck) {
  const Place place = place_of_stills(the_case, path, times);
  const Pose pose = pose_at(path, times.at(still));
  std::string out =
      fmt::format("<svg viewBox=\"0 0 {} {}\" aria-hidden=\"true\">", still_width, height) +
      trail_svg(path, times.front(), times.at(still), place);
  for (std::size_t index = 0; index < the_case.geometry.size(); ++index) {
    const CableRow& cable = the_case.geometry[index];
    out += cable_svg(the_case, cable, end_of(cable, pose), place, index == struck) +
           anchor_svg(place(cable.anchor));
  }
  return out + body_svg(the_case, pose, place) + "</svg>";
}

}  // namespace tautline::bench
