#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/elastic_contacts.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

// A run is one of a `Case` or of a `SpatialSystem`.

/// One recorded instant of a run.
template <class TheCase>
struct BasicPoint {
  double time;  // [s]
  StateOf<TheCase> state;
};

/// One impact of a run, as the detector saw it.
template <class TheCase>
struct BasicRecordedImpact {
  double time = 0.0;  // [s], when the velocity jumps: exact if located, else the start of the step
  std::size_t cable;  //
  double impulse = 0.0;  // [N s], > 0
  double rate_before;    // [m/s], gap rate just before; negative when closing
  double rate_after;     // [m/s], just after, at the same pose
  std::size_t steps;  // consecutive steps with an impulse; 0 if the simulation located the impact
  StateOf<TheCase> before;  // where the jump starts
  StateOf<TheCase> after;   // the pose at `ended`, and the velocity that the jump gave
  /// Change of momentum (x, y, angle) over the impact that neither gravity nor the impulses along
  /// the cables explain [N s, N s, N m s]; of the plane alone.
  Eigen::Vector3d stray = Eigen::Vector3d::Zero();
  double ended = time;  // [s], start of the last of those steps: where `after` is
  bool shared = false;  // another cable pulled in its steps: the velocity jump is of both
  /// [N s], of the impact alone: where a cable goes on taut, `impulse` has its tension, too.
  double snap = impulse;
  double rate_first = 0.0;  // [m/s], after the first of those steps, at the same pose
};

/// What one run did.
template <class TheCase>
struct BasicTrajectory {
  double step = 0.0;                        // [s]
  std::size_t stride = 1;                   // every stride-th step is in `points`
  std::vector<BasicPoint<TheCase>> points;  // the first is the start, the last the end of the run
  /// The mean tension [N] of each cable between every point and the one before, point after point;
  /// no number at the start. Without that of located impacts. Empty: the engine tells of none.
  std::vector<double> tensions;
  std::vector<SoftRow> soft_rows;  // of its cables, where the engine has such; else empty
  std::vector<BasicRecordedImpact<TheCase>> impacts;  // in rising time, all but the slow ones
  std::size_t slow_impacts = 0;  // the others: chatter of a cable that is as good as taut
  /// Those of elastic cables, by rising entry: entry and exit are starts of steps, the first in
  /// which a cable pulls and the first in which it does not; tensions are means over a step.
  std::vector<ElasticContact> contacts;
  double overstretch = 0.0;       // [m], the largest of inextensible cables, over every step
  double largest_energy = 0.0;    // [J], over every step
  std::optional<StopOfRun> stop;  // set when the simulation could not go on
  bool diverged = false;          // the state left every reasonable range, or is not finite
};

using Point = BasicPoint<Case>;
using RecordedImpact = BasicRecordedImpact<Case>;
using Trajectory = BasicTrajectory<Case>;                 // in the plane
using SystemTrajectory = BasicTrajectory<SpatialSystem>;  // of a system in space

}  // namespace tautline::bench
