#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::bench {

/// A side from which a motion is seen: the plane has one, space has three.
struct View {
  const char* name;   // "front", of a world in which z is up; "" in the plane
  const char* along;  // what it is called in another one
  std::size_t right;  // the axis of the world that goes to the right on the sheet
  std::size_t up;     // the one that goes up

  template <class Point>
  [[nodiscard]] Vec2 of(const Point& point) const {
    return {point[static_cast<Eigen::Index>(right)], point[static_cast<Eigen::Index>(up)]};
  }
};

/// How many numbers a point of a kind of case has.
template <class TheCase>
inline constexpr int dimensions_of = VectorOf<TheCase>::RowsAtCompileTime;

/// The sides from which a motion of D dimensions is drawn.
template <int D>
[[nodiscard]] constexpr auto views() {
  if constexpr (D == 2) {
    return std::array{View{"", "", 0, 1}};
  } else {
    return std::array{View{"front", "seen along y", 0, 2}, View{"side", "seen along x", 1, 2},
                      View{"top", "seen along z", 0, 1}};
  }
}

/// A rectangle of the plane, or a box of space, that holds every point it was told of.
template <int D>
class BasicExtent {
 public:
  using Point = BasicVector<double, D>;

  /// A point that is not finite is left out.
  void add(const Point& point);
  void add(const std::vector<Point>& points) {
    for (const Point& point : points) {
      add(point);
    }
  }

  /// A little more than the points on every side, and no side far thinner than the largest.
  [[nodiscard]] BasicExtent with_margin() const;

  /// Its two sides that `view` shows.
  [[nodiscard]] BasicExtent<2> seen(const View& view) const {
    BasicExtent<2> result;
    result.add(view.of(low_));
    result.add(view.of(high_));
    return result;
  }

  [[nodiscard]] Point low() const { return low_; }
  [[nodiscard]] Point size() const { return high_ - low_; }

 private:
  bool empty_ = true;
  Point low_ = Point::Zero();
  Point high_ = Point::Zero();
};
using Extent = BasicExtent<2>;

/// The bodies that are drawn faintly: those at the fastest impacts.
inline constexpr std::size_t faint_bodies = 8;

/// So many of the fastest impacts are marked in a picture: more is a smear.
inline constexpr std::size_t marked_impacts = 400;

/// An impact that is drawn.
template <int D>
struct BasicMark {
  double speed;                                // [m/s], of the fastest closing cable
  double time;                                 // [s]
  std::size_t event;                           // index
  std::vector<BasicVector<double, D>> places;  // of the centres of its bodies
};

/// A cable at one instant.
template <int D>
struct BasicDrawnCable {
  std::size_t index;                           // in its case
  std::vector<BasicVector<double, D>> points;  // its ends, and its rings between them
  std::vector<BasicVector<double, D>> lowest;  // of each part between them, where it hangs slack
  bool taut;
};

/// A body at one instant.
template <int D>
struct BasicDrawnBody {
  using Point = BasicVector<double, D>;

  Point centre;
  std::vector<Point> points;  // where cables hold it; in space those off its box
  /// Those of the solid box that has the mass and the moments of a rigid body in space, their
  /// corners anticlockwise from outside.
  std::vector<std::vector<Point>> faces;
  bool is_point = false;  // a point mass in space
};

/// All that is drawn of one instant.
template <int D>
struct BasicPose {
  std::vector<BasicDrawnBody<D>> bodies;
  std::vector<BasicDrawnCable<D>> cables;  // those that act then
};

/// All that a picture shows of a motion of D dimensions, of a case or of a system.
template <int D>
struct BasicPlotMotion {
  using Point = BasicVector<double, D>;
  using Line = std::vector<Point>;

  std::string name;
  std::string subject;                // "a body on 2 cables"
  std::vector<std::string> bodies;    // their names; none of one alone
  bool numbers_cables = false;        // as the tensions name them
  bool z_is_up = true;                // in space; else another axis is nearer to it
  std::string side;                   // as it is seen, where there are several sides
  std::vector<Line> paths;            // of each centre of mass, in rising time
  double path_end = 0.0;              // [s], to which paths are drawn
  std::vector<Line> traces;           // in space the paths of attachments off the centres
  std::vector<Line> moving;           // paths of ends and rings in the world
  Line anchors;                       // ends in the world, at the end
  Line rings;                         // at the end
  std::vector<BasicMark<D>> marks;    // the fastest first
  std::string contacts;               // as `contact_words` has them
  std::vector<BasicPose<D>> fastest;  // at the first of them
  BasicPose<D> start;
  BasicPose<D> end;
  double end_time = 0.0;  // [s]
  Ending ending = Ending::reached_duration;
};
using PlotMotion = BasicPlotMotion<2>;  // in the plane, or as one side of space shows it
[[nodiscard]] PlotMotion plot_motion(const Case& the_case, const Solution& solution);
template <int D>
[[nodiscard]] BasicPlotMotion<D> plot_motion(const BasicSystem<double, D>& system,
                                             const BasicSolution<BasicSystem<double, D>>& solution);

/// `motion` as `view` shows it.
template <int D>
[[nodiscard]] PlotMotion seen(const BasicPlotMotion<D>& motion, const View& view);

/// The bodies of a state.
[[nodiscard]] inline std::vector<State> bodies_of(const State& state) { return {state}; }
template <int D>
[[nodiscard]] const auto& bodies_of(const BasicSystemState<double, D>& state) {
  return state.bodies;
}

/// The name of a body in a legend.
[[nodiscard]] std::string body_name(const std::string& name, std::size_t index);

/// Every impact, the fastest first.
template <class TheCase>
[[nodiscard]] std::vector<BasicMark<dimensions_of<TheCase>>> impact_marks(
    const TheCase& the_case, const BasicSolution<TheCase>& solution);

/// ", 8 contacts of elastic cables"; "" where no cable is elastic.
template <class TheCase>
[[nodiscard]] std::string contact_words(const TheCase& the_case,
                                        const BasicSolution<TheCase>& solution);

/// The extent of the paths and bodies that are drawn, and the same with their cables; without a
/// margin.
template <int D>
[[nodiscard]] BasicExtent<D> extent_of_bodies(const BasicPlotMotion<D>& motion);
template <int D>
[[nodiscard]] BasicExtent<D> extent_of_all(const BasicPlotMotion<D>& motion);

/// How far a slack line of `length` between points `chord` apart hangs below their middle: that of
/// a parabola that is not deep, 8 sag^2 / (3 chord) longer than its chord.
[[nodiscard]] double sag(double length, double chord);

/// The corners of the smallest convex polygon that holds `points`, anticlockwise.
[[nodiscard]] std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// A picture of one motion as an SVG file of its own, legible on light and dark paper: the path of
/// the centre of mass, the body and its cables at the start and the end, the body at its fastest
/// impacts, a mark at each impact, axes and a scale bar in [m].
[[nodiscard]] std::string plot_svg(const Case& the_case, const Solution& solution);

/// A picture of one motion over time as an SVG file of its own, legible on light and dark paper: a
/// panel each for x, y, the angle, the gaps and the tensions, with a line at each impact. Where
/// more happens within a pixel than it can show, it shows the least and the largest value there.
[[nodiscard]] std::string plot_motion_svg(const Case& the_case, const Solution& solution);

/// The motion of a system of D dimensions, for a picture. All of it must outlive this.
template <int D>
struct BasicSystemMotion {
  const BasicSystem<double, D>& system;
  const BasicSolution<BasicSystem<double, D>>& solution;
  const SystemSettling& settling;
  std::optional<double> horizon;  // [s]: from here on the motion is one of many
};
using SystemMotion = BasicSystemMotion<2>;
using SpatialMotion = BasicSystemMotion<3>;

/// "; one of many motions from t = 3 s on", where it is so.
[[nodiscard]] std::string horizon_words(const std::optional<double>& horizon);

/// These pictures of a system: with the paths of all bodies and of ends that move, with rings, and
/// the first one with the tensions over time below it.
[[nodiscard]] std::string plot_svg(const SystemMotion& motion);
[[nodiscard]] std::string plot_motion_svg(const SystemMotion& motion);
/// Likewise in space: the first one from the front, the side and the top, with the paths of
/// attachments; the second with the angle by which each body has turned from its start, and the
/// energy.
[[nodiscard]] std::string plot_svg(const SpatialMotion& motion);
[[nodiscard]] std::string plot_motion_svg(const SpatialMotion& motion);

/// The panel of tensions over time, from `top` [px] down.
struct TensionPanel {
  std::string drawn;
  double bottom;  // [px]
};
template <int D>
[[nodiscard]] TensionPanel tension_panel(const BasicSystemMotion<D>& motion, double top);

}  // namespace tautline::bench
