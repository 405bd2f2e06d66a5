#pragma once

#include <vector>

#include "tautline/case.hpp"

namespace tautline::bench {

/// A rectangle of the world that holds every point it was told of.
class Extent {
 public:
  /// A point that is not finite is left out.
  void add(const Vec2& point);

  /// At least `smallest` wide and high, and a little more than the points on every side.
  [[nodiscard]] Extent with_margin() const;

  [[nodiscard]] Vec2 low() const { return low_; }
  [[nodiscard]] Vec2 size() const { return high_ - low_; }

 private:
  bool empty_ = true;
  Vec2 low_ = Vec2::Zero();
  Vec2 high_ = Vec2::Zero();
};

/// Round numbers in [low, low + size]: 3 to 8 of them, 1, 2 or 5 times a power of ten apart.
[[nodiscard]] std::vector<double> ticks(double low, double size);

/// The largest of 1, 2 or 5 times a power of ten that is at most `length` > 0.
[[nodiscard]] double round_below(double length);

/// How far a slack line of `length` between points `chord` apart hangs below their middle: that of
/// a parabola that is not deep, 8 sag^2 / (3 chord) longer than its chord.
[[nodiscard]] double sag(double length, double chord);

/// The corners of the smallest convex polygon that holds `points`, anticlockwise.
[[nodiscard]] std::vector<Vec2> convex_hull(std::vector<Vec2> points);

}  // namespace tautline::bench
