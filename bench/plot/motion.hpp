#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::bench {

/// A rectangle of the world that holds every point it was told of.
class Extent {
 public:
  /// A point that is not finite is left out.
  void add(const Vec2& point);

  /// A little more than the points on every side, and neither side far thinner than the other.
  [[nodiscard]] Extent with_margin() const;

  [[nodiscard]] Vec2 low() const { return low_; }
  [[nodiscard]] Vec2 size() const { return high_ - low_; }

 private:
  bool empty_ = true;
  Vec2 low_ = Vec2::Zero();
  Vec2 high_ = Vec2::Zero();
};

/// The bodies that are drawn faintly: those at the fastest impacts.
inline constexpr std::size_t faint_bodies = 8;

/// So many of the fastest impacts are marked in a picture: more is a smear.
inline constexpr std::size_t marked_impacts = 400;

/// An impact that is drawn.
struct Mark {
  double speed;              // [m/s], of the fastest closing cable
  double time;               // [s]
  std::size_t event;         // index
  std::vector<Vec2> places;  // of the centres of its bodies
};

/// A cable at one instant.
struct DrawnCable {
  std::size_t index;         // in its case
  std::vector<Vec2> points;  // its ends, and its rings between them
  double length;             // [m]
  bool taut;
};

/// A body at one instant.
struct DrawnBody {
  Vec2 centre;
  std::vector<Vec2> points;  // where cables hold it
};

/// All that is drawn of one instant.
struct Pose {
  std::vector<DrawnBody> bodies;
  std::vector<DrawnCable> cables;  // those that act then
};

/// All that a picture shows of a motion in the plane, of a case or of a system.
struct PlotMotion {
  std::string name = {};
  std::string subject = {};                    // "a body on 2 cables"
  std::vector<std::string> bodies = {};        // their names; none of one alone
  bool numbers_cables = false;                 // as the tensions name them
  Vec2 down = Vec2(0.0, -1.0);                 // where slack cables hang to
  std::vector<std::vector<Vec2>> paths = {};   // of each centre of mass, in rising time
  double path_end = 0.0;                       // [s], to which paths are drawn
  std::vector<std::vector<Vec2>> moving = {};  // paths of ends and rings in the world
  std::vector<Vec2> anchors = {};              // ends in the world, at the end
  std::vector<Vec2> rings = {};                // at the end
  std::vector<Mark> marks = {};                // the fastest first
  std::vector<Pose> fastest = {};              // at the first of them
  Pose start = {};
  Pose end = {};
  double end_time = 0.0;  // [s]
  Ending ending = Ending::reached_duration;
};
[[nodiscard]] PlotMotion plot_motion(const Case& the_case, const Solution& solution);
[[nodiscard]] PlotMotion plot_motion(const System& system, const BasicSolution<System>& solution);

/// The bodies of a state.
[[nodiscard]] inline std::vector<State> bodies_of(const State& state) { return {state}; }
[[nodiscard]] inline const std::vector<State>& bodies_of(const SystemState& state) {
  return state.bodies;
}

/// The name of a body in a legend.
[[nodiscard]] std::string body_name(const BodyOfSystem& body, std::size_t index);

/// Every impact, the fastest first.
template <class TheCase>
[[nodiscard]] std::vector<Mark> impact_marks(const TheCase& the_case,
                                             const BasicSolution<TheCase>& solution);

/// The lowest point of a line of `length` that hangs between two points.
[[nodiscard]] Vec2 lowest_point(const Vec2& from, const Vec2& to, double length, const Vec2& down);

/// The parts of a cable between its points, each with the length that it takes, for `use`.
template <class Use>
void each_part(const DrawnCable& cable, const Use& use) {
  double chords = 0.0;
  for (std::size_t i = 1; i < cable.points.size(); ++i) {
    chords += (cable.points[i] - cable.points[i - 1]).norm();
  }
  for (std::size_t i = 1; i < cable.points.size(); ++i) {
    const double chord = (cable.points[i] - cable.points[i - 1]).norm();
    const bool straight = cable.points.size() == 2;
    use(cable.points[i - 1], cable.points[i],
        straight || !(chords > 0.0) ? cable.length : cable.length * chord / chords);
  }
}

/// The extent of the paths and bodies that are drawn, and the same with their cables; without a
/// margin.
[[nodiscard]] Extent extent_of_bodies(const PlotMotion& motion);
[[nodiscard]] Extent extent_of_all(const PlotMotion& motion);

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

/// The motion of a system, for a picture. All of it must outlive this.
struct SystemMotion {
  const System& system;
  const BasicSolution<System>& solution;
  const SystemSettling& settling;
  std::optional<double> horizon;  // [s]: from here on the motion is one of many
};

/// "; one of many motions from t = 3 s on", where it is so.
[[nodiscard]] std::string horizon_words(const SystemMotion& motion);

/// These pictures of a system: with the paths of all bodies and of ends that move, with rings, and
/// the first one with the tensions over time below it.
[[nodiscard]] std::string plot_svg(const SystemMotion& motion);
[[nodiscard]] std::string plot_motion_svg(const SystemMotion& motion);

/// The panel of tensions over time, from `top` [px] down.
struct TensionPanel {
  std::string drawn;
  double bottom;  // [px]
};
[[nodiscard]] TensionPanel tension_panel(const SystemMotion& motion, double top);

}  // namespace tautline::bench
