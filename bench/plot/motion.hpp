#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"

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
  double speed;  // [m/s], of the fastest closing cable
  double time;   // [s]
  State pose;
};

/// Every impact, the fastest first.
[[nodiscard]] std::vector<Mark> impact_marks(const Case& the_case, const Solution& solution);

/// What a picture shows of a motion. The case and its solution must outlive it.
struct PlotMotion {
  const Case& the_case;
  const Solution& solution;
  std::vector<Vec2> path;  // of the centre of mass, in rising time
  double path_end;         // [s], to which the path is drawn; what repeats itself is drawn once
  std::vector<Mark> marks;
  State end;
};
[[nodiscard]] PlotMotion plot_motion(const Case& the_case, const Solution& solution);

/// The lowest point of a cable that hangs.
[[nodiscard]] Vec2 lowest_point(const Case& the_case, const Cable& cable, const State& state);

/// What holds the path and the bodies that are drawn, and what holds their cables too; without a
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

}  // namespace tautline::bench
