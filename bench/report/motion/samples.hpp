#pragma once

#include <Eigen/Core>
#include <vector>

#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// What is known of a motion at one instant. At an impact, velocity and energy jump.
struct Sample {
  double time;               // [s]
  Eigen::Vector3d pose;      // x, y [m], angle [rad]
  Eigen::Vector3d arriving;  // velocity before [m/s, m/s, rad/s]
  Eigen::Vector3d leaving;   // velocity after
  double energy_before;      // [J]
  double energy_after;       // [J]
};

/// All that was recorded of `run`, in rising time, up to where it is not finite: its points and its
/// impacts. The velocities are the simulation's own where it located its impacts. Else a step moves
/// the body by one velocity while it stores another, and they are those of the way between points.
[[nodiscard]] std::vector<Sample> samples_of(const Case& the_case, const Trajectory& run);

/// The exact motion, finer than it can be drawn, with both sides of every event.
[[nodiscard]] std::vector<Sample> samples_of(const Case& the_case, const Solution& solution);

}  // namespace tautline::bench
