#pragma once

#include <string>
#include <vector>

#include "bench/chapter/figures/figures.hpp"

namespace tautline::bench {

/// What a plot draws: a line, or points where nothing lies between them.
struct Curve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// A curve is thinned to at most so many points; a plot is not wider in pixels.
inline constexpr std::size_t most_points = 600;

/// One curve of a motion, thinned without losing what can be seen; of impacts the points of each
/// cable, the fastest of them.
[[nodiscard]] std::vector<Curve> figure_curves(const ChapterFigure& figure);

/// What bounds the region from below while the body is not turned, thinned.
[[nodiscard]] Curve boundary_curve(const Boundary& boundary);

}  // namespace tautline::bench
