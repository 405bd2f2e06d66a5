#pragma once

#include <Eigen/Core>

#include <vector>

#include "bench/replay/path.hpp"
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

/// How near a drawing is to what was recorded.
struct Nearness {
  double bound = 0.0;   // [m], centre and attachments may be off by it
  double reach = 0.0;   // [m], of the attachments from the centre
  double lever = 0.0;   // [m], >= reach: an angle may be off by bound / lever
  double energy = 0.0;  // [J], the energy may be off by it
};

/// More pieces than this are not drawn: where a run shakes by more than the bound at every step,
/// the bound is doubled until they suffice. `Path::error` says what came of it.
inline constexpr std::size_t most_pieces = 3000;

/// Draws the motion of `samples`, which are not empty, into `path`: few knots, and a cubic between
/// two that is as near to the samples as `nearness` asks.
void draw_motion(const std::vector<Sample>& samples, const Nearness& nearness, Path& path);

/// The same of its energy, with straight lines.
void draw_energy(const std::vector<Sample>& samples, const Nearness& nearness, Path& path);

}  // namespace tautline::bench
