// What a picture of a motion shows, and its geometry.

#include "bench/plot/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/plot/svg.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Coordinates are cut here: differences and squares of them stay finite [m].
constexpr double largest_coordinate = 1e150;

/// [rad], of what moves on a line that bends little within an arc.
constexpr auto no_turn = [](const auto& /*arc*/) { return 0.0; };

constexpr std::size_t path_points = 40'000;  // half a megabyte: more would be a smear

/// A path in rising time: a chord of it lies less than the width of its line from the motion,
/// however long that is. It ends early where it has more points than a picture can show.
template <class Point>
struct Path {
  std::vector<Point> points;
  double end;  // [s]
};
/// It has `most` points, `least` [m] apart, each of them `place(arc, time since its start)`, which
/// turns by no more than `turn(arc)` [rad].
template <class TheCase, class Place, class Turn>
auto path_of(const BasicSolution<TheCase>& solution, const Place& place, std::size_t most,
             double least, const Turn& turn) {
  using Point = VectorOf<TheCase>;
  const auto& arcs = solution.arcs();
  const std::size_t count = arcs.size();  // what repeats lies on its first period
  const auto position = [&](const BasicArc<TheCase>& arc, double part) -> Point {
    return place(arc, part * (arc.end - arc.start));
  };
  BasicExtent<dimensions_of<TheCase>> extent;
  for (std::size_t index = 0; index < count; ++index) {
    extent.add(position(arcs[index], 0.0));
    extent.add(position(arcs[index], 0.5));
    extent.add(position(arcs[index], 1.0));
  }
  // [-], of the path's size: a sixth of a pixel; the panels of space are half as wide
  constexpr double sharpness = dimensions_of<TheCase> == 2 ? 4000.0 : 2000.0;
  const double chord = std::max(extent.size().maxCoeff(), 1e-300) / sharpness;
  Path<Point> result{{position(arcs.front(), 0.0)}, arcs.front().start};
  for (std::size_t index = 0; index < count && result.points.size() < most; ++index) {
    const BasicArc<TheCase>& arc = arcs[index];
    const Point first = position(arc, 0.0);
    const Point last = position(arc, 1.0);
    double deepest = 0.0;  // [m], of the arc's chord: that of n parts is smaller by n^2
    for (const double part : {0.25, 0.5, 0.75}) {
      deepest =
          std::max(deepest, (position(arc, part) - (1.0 - part) * first - part * last).norm());
    }
    constexpr double most_parts = 500.0;  // of one flight, or where its numbers are too large
    constexpr double finest = 0.3;        // [rad]: places between may hide a turn
    const double wanted = std::ceil(std::max(std::sqrt(deepest / chord), turn(arc) / finest));
    const int parts =
        std::isfinite(wanted) ? static_cast<int>(std::clamp(wanted, 1.0, most_parts)) : 1;
    for (int k = 1; k <= parts; ++k) {
      Point point = position(arc, static_cast<double>(k) / parts);
      if (!((point - result.points.back()).norm() < least)) {
        result.points.push_back(std::move(point));
      }
    }
    result.end = arc.end;
  }
  if (result.points.size() < most) {
    result.end = solution.end_time();
  }
  return result;
}

/// The unit vector down; where nothing pulls, down on the sheet.
template <class Vector>
Vector down_by(const Vector& gravity) {
  const double size = gravity.norm();
  return size > 0.0 ? Vector(gravity / size) : Vector(-Vector::Unit(gravity.size() - 1));
}

/// Says of each part of a cable of `length` [m] where it is lowest if it hangs slack. The parts
/// share the length as they share the way.
template <int D>
void let_hang(BasicDrawnCable<D>& cable, double length, const BasicVector<double, D>& down) {
  double chords = 0.0;
  for (std::size_t i = 1; i < cable.points.size(); ++i) {
    chords += (cable.points[i] - cable.points[i - 1]).norm();
  }
  for (std::size_t i = 1; i < cable.points.size(); ++i) {
    const BasicVector<double, D>& from = cable.points[i - 1];
    const BasicVector<double, D>& to = cable.points[i];
    const double chord = (to - from).norm();
    const bool straight = cable.points.size() == 2;
    const double part = straight || !(chords > 0.0) ? length : length * chord / chords;
    cable.lowest.push_back(0.5 * (from + to) + sag(part, chord) * down);
  }
}

BasicPose<2> pose_of(const Case& the_case, const State& state, CableSet taut) {
  BasicPose<2> result{{{state.position, {}, {}}}, {}};
  const Vec2 down = down_by(the_case.gravity);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const Cable& cable = the_case.cables[index];
    const Vec2 end = attachment_point(state, cable);
    result.bodies.front().points.push_back(end);
    result.cables.push_back(
        {index,
         {cable.anchor, end},
         {},
         taut.contains(index) || gap(cable, state) <= gap_rounding * cable.length});
    let_hang(result.cables.back(), cable.length, down);
  }
  return result;
}

BasicDrawnBody<2> drawn_body(const BodyOfSystem& /*body*/, const State& state) {
  return {state.position, {}, {}};
}

/// True of a place of `body` where a cable holds it that its picture shows.
bool is_drawn(const BodyOfSystem& /*body*/, const Vec2& /*at*/) { return true; }

/// Half the sides of the solid box that has the mass and the moments of `body` [m]: sides of 2a, 2b
/// and 2c have the moment m (b^2 + c^2) / 3 about the axis of a.
BasicVector<double, 3> half_sides(const SpatialBody& body) {
  using Sides = BasicVector<double, 3>;
  const Sides squares =
      1.5 / body.mass * (Sides::Constant(body.inertia.sum()) - 2.0 * body.inertia);
  return squares.cwiseMax(0.0).cwiseSqrt();
}

/// In space those off its box.
bool is_drawn(const SpatialBody& body, const BasicVector<double, 3>& at) {
  constexpr double rounding = 1e-9;  // [-]
  return ((at.cwiseAbs() - half_sides(body)).array() > rounding * at.norm()).any();
}

BasicDrawnBody<3> drawn_body(const SpatialBody& body, const SpatialState& state) {
  using Point = BasicVector<double, 3>;
  BasicDrawnBody<3> result{state.position, {}, {}};
  result.is_point = !has_inertia(body.inertia);
  const Point half = half_sides(body);
  for (int axis = 0; axis < 3 && !result.is_point; ++axis) {
    for (const double side : {1.0, -1.0}) {
      auto& face = result.faces.emplace_back();
      for (const auto& [u, v] : {std::pair{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
        Point corner;
        corner[axis] = side;
        corner[(axis + 1) % 3] = side * u;
        corner[(axis + 2) % 3] = v;
        face.push_back(state.position + in_the_world(state, half.cwiseProduct(corner)));
      }
    }
  }
  return result;
}

template <int D>
BasicPose<D> pose_of(const BasicSystem<double, D>& system, const BasicSystemState<double, D>& state,
                     CableSet taut) {
  BasicPose<D> result;
  for (std::size_t body = 0; body < system.bodies.size(); ++body) {
    result.bodies.push_back(drawn_body(system.bodies[body], state.bodies[body]));
  }
  const BasicVector<double, D> down = down_by(system.gravity.at(0.0));
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    const auto& cable = system.cables[index];
    const double length = cable.length.at(state.time)[0];
    BasicDrawnCable<D> drawn{index, {}, {}, false};
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      drawn.points.push_back(moving_point(cable.end(i), state).position);
      if (const auto& end = cable.end(i); end.body && is_drawn(system.bodies[*end.body], end.at)) {
        result.bodies[*end.body].points.push_back(drawn.points.back());
      }
    }
    if (cable.acts_at(state.time)) {
      drawn.taut = taut.contains(index) || gap(cable, state) <= gap_rounding * length;
      let_hang(drawn, length, down);
      result.cables.push_back(std::move(drawn));
    }
  }
  return result;
}

/// The places of the bodies that the cables of an event hold.
std::vector<Vec2> places_of(const Case& /*the_case*/, const Event& event) {
  return {event.before.position};
}

template <int D>
auto places_of(const BasicSystem<double, D>& system,
               const BasicEvent<BasicSystem<double, D>>& event) {
  std::vector<bool> held(system.bodies.size());
  for (const std::size_t index : event.cables) {
    const auto& cable = system.cables[index];
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      if (cable.end(i).body) {
        held[*cable.end(i).body] = true;
      }
    }
  }
  std::vector<BasicVector<double, D>> result;
  for (std::size_t body = 0; body < held.size(); ++body) {
    if (held[body]) {
      result.push_back(event.before.bodies[body].position);
    }
  }
  return result;
}

/// The points off the centres of bodies whose paths are drawn: in the plane none, as the picture of
/// a body shows how it turns.
template <int D>
std::vector<BasicEnd<double, D>> traced_points(const BasicSystem<double, D>& system) {
  std::vector<BasicEnd<double, D>> result;
  for (const auto& cable : system.cables) {
    for (std::size_t i = 0; D == 3 && i <= cable.segments(); ++i) {
      const BasicEnd<double, D>& end = cable.end(i);
      if (end.body && !end.at.isZero(0) &&
          std::find(result.begin(), result.end(), end) == result.end()) {
        result.push_back(end);
      }
    }
  }
  return result;
}

/// True of a face whose corners go anticlockwise on the sheet, or that is seen from its edge.
bool is_seen(const std::vector<Vec2>& corners) {
  double twice = 0.0;  // [m^2], its area
  double square = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 side = corners[(i + 1) % corners.size()] - corners[i];
    twice += cross<double>(corners[i] - corners[0], side);
    square += side.squaredNorm();
  }
  constexpr double rounding = 1e-9;  // [-]
  return twice > -rounding * square;
}

/// How far apart the points of a path have to be [m]: in space, where a picture has several sides
/// and the paths of attachments, less than a pixel.
template <int D>
double least_apart(const BasicPlotMotion<D>& motion) {
  BasicPlotMotion<D> poses;
  poses.start = motion.start;
  poses.end = motion.end;
  return D == 2 ? 0.0 : extent_of_bodies(poses).size().maxCoeff() / panel_width;
}

/// Paths of at most `most` points, impacts and poses: what cases and systems share.
template <class TheCase>
auto drawn_motion(const TheCase& the_case, const BasicSolution<TheCase>& solution,
                  std::size_t most) {
  constexpr int dimensions = dimensions_of<TheCase>;
  BasicPlotMotion<dimensions> result;
  result.name = the_case.name;
  result.end_time = solution.end_time();
  result.ending = solution.ending();
  result.path_end = result.end_time;
  const std::size_t bodies = bodies_of(the_case.initial).size();
  result.marks = impact_marks(the_case, solution);
  result.contacts = contact_words(the_case, solution);
  for (std::size_t index = 0; index < std::min(faint_bodies, result.marks.size()); ++index) {
    const auto& event = solution.events()[result.marks[index].event];
    result.fastest.push_back(pose_of(the_case, event.before, {}));
  }
  result.start = pose_of(the_case, the_case.initial, solution.arcs().front().taut);
  result.end = pose_of(the_case, solution.at(result.end_time), solution.arcs().back().taut);
  const double least = least_apart(result);
  for (std::size_t body = 0; body < bodies; ++body) {
    auto path = path_of(
        solution,
        [&](const BasicArc<TheCase>& arc, double dt) {
          return bodies_of(arc.after(dt, solution.gravity()))[body].position;
        },
        most, least, no_turn);
    result.paths.push_back(std::move(path.points));
    result.path_end = std::min(result.path_end, path.end);
  }
  const std::size_t cables = the_case.cables.size();
  result.subject =
      fmt::format("{} on {} cable{}{}", bodies == 1 ? "a body" : fmt::format("{} bodies", bodies),
                  cables, cables == 1 ? "" : "s", dimensions == 3 ? " in space" : "");
  return result;
}

}  // namespace

template <int D>
void BasicExtent<D>::add(const Point& point) {
  if (!point.allFinite()) {
    return;
  }
  const Point inside = point.cwiseMax(-largest_coordinate).cwiseMin(largest_coordinate);
  low_ = empty_ ? inside : Point(low_.cwiseMin(inside));
  high_ = empty_ ? inside : Point(high_.cwiseMax(inside));
  empty_ = false;
}

template <int D>
BasicExtent<D> BasicExtent<D>::with_margin() const {
  constexpr double margin = 0.06;    // around the points, as a share of the largest side [-]
  constexpr double thinnest = 0.25;  // of the largest side: a motion on a line needs room too [-]
  const double scale = std::max({low_.cwiseAbs().maxCoeff(), high_.cwiseAbs().maxCoeff(), 1e-150});
  // a body that does not move has no extent; below this, coordinates are not told apart
  const double largest = std::max(size().maxCoeff(), 1e-9 * scale);
  BasicExtent result = *this;
  for (int axis = 0; axis < D; ++axis) {
    const double missing = std::max(0.0, thinnest * largest - size()[axis]);
    result.low_[axis] -= 0.5 * missing + margin * largest;
    result.high_[axis] += 0.5 * missing + margin * largest;
  }
  return result;
}
template class BasicExtent<2>;
template class BasicExtent<3>;

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

std::string body_name(const std::string& name, std::size_t index) {
  constexpr std::size_t longest = 24;  // [bytes]
  return name.empty() ? fmt::format("body {}", index) : printable(name, longest);
}

std::string horizon_words(const std::optional<double>& horizon) {
  return horizon ? fmt::format("; one of many motions from t = {:.6g} s on", *horizon) : "";
}

template <class TheCase>
std::vector<BasicMark<dimensions_of<TheCase>>> impact_marks(
    const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  std::vector<BasicMark<dimensions_of<TheCase>>> marks;
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
                   [](const auto& a, const auto& b) { return a.speed > b.speed; });
  return marks;
}
template <class TheCase>
std::string contact_words(const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  if constexpr (!std::is_same_v<TheCase, Case>) {
    if (first_elastic(the_case)) {
      const std::size_t contacts = elastic_contacts(solution).size();
      return fmt::format(", {} contact{} of elastic cables", contacts, contacts == 1 ? "" : "s");
    }
  }
  return "";
}
template std::string contact_words(const Case&, const Solution&);
template std::string contact_words(const System&, const BasicSolution<System>&);
template std::string contact_words(const SpatialSystem&, const BasicSolution<SpatialSystem>&);

template std::vector<BasicMark<2>> impact_marks(const Case&, const Solution&);
template std::vector<BasicMark<2>> impact_marks(const System&, const BasicSolution<System>&);
template std::vector<BasicMark<3>> impact_marks(const SpatialSystem&,
                                                const BasicSolution<SpatialSystem>&);

PlotMotion plot_motion(const Case& the_case, const Solution& solution) {
  PlotMotion result = drawn_motion(the_case, solution, path_points);
  for (const Cable& cable : the_case.cables) {
    result.anchors.push_back(cable.anchor);
  }
  return result;
}

template <int D>
BasicPlotMotion<D> plot_motion(const BasicSystem<double, D>& system,
                               const BasicSolution<BasicSystem<double, D>>& solution) {
  const auto traced = traced_points(system);
  const std::size_t most = path_points / views<D>().size() / (system.bodies.size() + traced.size());
  BasicPlotMotion<D> result = drawn_motion(system, solution, most);
  const double least = least_apart(result);
  for (const BasicEnd<double, D>& end : traced) {
    auto path = path_of(
        solution,
        [&](const BasicArc<BasicSystem<double, D>>& arc, double dt) {
          return moving_point(end, arc.after(dt, solution.gravity())).position;
        },
        most, least,
        [&](const BasicArc<BasicSystem<double, D>>& arc) {
          return (arc.end - arc.start) * spin_size(arc.initial.bodies[*end.body]);
        });
    result.traces.push_back(std::move(path.points));
    result.path_end = std::min(result.path_end, path.end);
  }
  for (std::size_t index = 0; system.bodies.size() > 1 && index < system.bodies.size(); ++index) {
    result.bodies.push_back(body_name(system.bodies[index].name, index));
  }
  result.numbers_cables = system.cables.size() > 1;
  const BasicVector<double, D> gravity = system.gravity.at(0.0);
  result.z_is_up = D == 2 || !(gravity.cwiseAbs().maxCoeff() > std::abs(gravity[D - 1]));
  const BasicSystemState<double, D> last = solution.at(result.end_time);
  for (const auto& cable : system.cables) {
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      const BasicEnd<double, D>& end = cable.end(i);
      const bool ring = i > 0 && i < cable.segments();
      if (!end.body || ring) {
        (ring ? result.rings : result.anchors).push_back(moving_point(end, last).position);
      }
      if (!end.body && !end.motion.empty()) {
        const auto place = [&](const BasicArc<BasicSystem<double, D>>& arc, double dt) {
          return moving_point(end, BasicSystemState<double, D>{arc.start + dt, {}}).position;
        };
        const std::size_t points = path_points / views<D>().size() / max_bodies;
        result.moving.push_back(path_of(solution, place, points, 0.0, no_turn).points);
      }
    }
  }
  return result;
}
template BasicPlotMotion<2> plot_motion(const System&, const BasicSolution<System>&);
template BasicPlotMotion<3> plot_motion(const SpatialSystem&, const BasicSolution<SpatialSystem>&);

template <int D>
PlotMotion seen(const BasicPlotMotion<D>& motion, const View& view) {
  const auto line = [&](const auto& points) {
    return listed(points, [&](const auto& point) { return view.of(point); });
  };
  const auto pose = [&](const BasicPose<D>& one) {
    BasicPose<2> result;
    for (const BasicDrawnBody<D>& body : one.bodies) {
      result.bodies.push_back({view.of(body.centre), line(body.points), {}, body.is_point});
      for (const auto& face : body.faces) {
        std::vector<Vec2> corners = line(face);
        if (is_seen(corners)) {
          result.bodies.back().faces.push_back(std::move(corners));
        }
      }
    }
    for (const BasicDrawnCable<D>& cable : one.cables) {
      result.cables.push_back({cable.index, line(cable.points), line(cable.lowest), cable.taut});
    }
    return result;
  };
  PlotMotion result;
  result.name = motion.name;
  result.subject = motion.subject;
  result.side = motion.z_is_up ? view.name : view.along;
  result.bodies = motion.bodies;
  result.numbers_cables = motion.numbers_cables;
  result.paths = listed(motion.paths, line);
  result.path_end = motion.path_end;
  result.traces = listed(motion.traces, line);
  result.moving = listed(motion.moving, line);
  result.anchors = line(motion.anchors);
  result.rings = line(motion.rings);
  for (const BasicMark<D>& mark : motion.marks) {
    result.marks.push_back({mark.speed, mark.time, mark.event, line(mark.places)});
  }
  result.contacts = motion.contacts;
  result.fastest = listed(motion.fastest, pose);
  result.start = pose(motion.start);
  result.end = pose(motion.end);
  result.end_time = motion.end_time;
  result.ending = motion.ending;
  return result;
}
template PlotMotion seen(const BasicPlotMotion<2>&, const View&);
template PlotMotion seen(const BasicPlotMotion<3>&, const View&);

template <int D>
BasicExtent<D> extent_of_bodies(const BasicPlotMotion<D>& motion) {
  BasicExtent<D> result;
  const auto add = [&](const auto& lines) {
    for (const auto& line : lines) {
      result.add(line);
    }
  };
  add(motion.paths);
  add(motion.traces);
  const auto add_bodies = [&](const BasicPose<D>& pose) {
    for (const BasicDrawnBody<D>& body : pose.bodies) {
      result.add(body.points);
      add(body.faces);
    }
  };
  add_bodies(motion.start);
  add_bodies(motion.end);
  std::for_each(motion.fastest.begin(), motion.fastest.end(), add_bodies);
  return result;
}
template BasicExtent<2> extent_of_bodies(const BasicPlotMotion<2>&);
template BasicExtent<3> extent_of_bodies(const BasicPlotMotion<3>&);

template <int D>
BasicExtent<D> extent_of_all(const BasicPlotMotion<D>& motion) {
  BasicExtent<D> result = extent_of_bodies(motion);
  for (const BasicPose<D>* pose : {&motion.start, &motion.end}) {
    for (const BasicDrawnCable<D>& cable : pose->cables) {
      result.add(cable.points);
      result.add(cable.lowest);
    }
  }
  result.add(motion.anchors);
  result.add(motion.rings);
  for (const auto& path : motion.moving) {
    result.add(path);
  }
  return result;
}
template BasicExtent<2> extent_of_all(const BasicPlotMotion<2>&);
template BasicExtent<3> extent_of_all(const BasicPlotMotion<3>&);

}  // namespace tautline::bench
