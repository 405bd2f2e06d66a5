#pragma once

#include <cstddef>
#include <vector>

#include "bench/solution/plot_view.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// The bodies that are drawn faintly: those at the fastest impacts.
inline constexpr std::size_t faint_bodies = 8;

/// An impact that is drawn.
struct Mark {
  double speed;  // [m/s], of the fastest closing cable
  State pose;
};

/// What a picture shows of a motion. The case and its solution must outlive it.
struct PlotMotion {
  const Case& the_case;
  const Solution& solution;
  std::vector<Vec2> path;   // of the centre of mass, in rising time
  double path_end;          // [s], to which the path is drawn; what repeats itself is drawn once
  std::vector<Mark> marks;  // every impact, the fastest first
  State end;
};
[[nodiscard]] PlotMotion plot_motion(const Case& the_case, const Solution& solution);

/// The lowest point of a cable that hangs.
[[nodiscard]] Vec2 lowest_point(const Case& the_case, const Cable& cable, const State& state);

/// What holds the path and the bodies that are drawn, and what holds their cables too; without a
/// margin.
[[nodiscard]] Extent extent_of_bodies(const PlotMotion& motion);
[[nodiscard]] Extent extent_of_all(const PlotMotion& motion);

}  // namespace tautline::bench
