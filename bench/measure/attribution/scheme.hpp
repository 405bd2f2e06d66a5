#pragma once

#include <cstddef>
#include <vector>

#include "bench/run/record.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

// How a run resolves its impacts: one rule for the whole run, read from all its impacts at once. A
// rule is a closed form; nothing is fitted to a single impact, and what no closed form explains is
// left to the solver.

/// An impact of a run as a jump of velocity alone: gravity's part of the step is taken away.
struct Jump {
  double time;             // [s], where the velocity jumps
  std::size_t first_step;  // the step it is in, or the first of them
  std::size_t last_step;   //
  std::size_t cable;       //
  State before;            // where it jumps
  Eigen::Vector3d change;  // of x velocity, y velocity [m/s] and spin [rad/s]
  double overstretch;      // [m], >= 0, before
  double dt;               // [s], the step
  bool located;            // the simulation named the instant
  double rebound;          // [m/s], gap rate after the last of its steps, as recorded
  bool lost = false;       // it did not rebound, as all slow ones of the run, or as all
};

/// Which gap rate the bounce is taken from and what it becomes. y is the state where the velocity
/// jumps, r its gap rate, c < 0 what gravity adds to the rate per second, e the restitution.
enum class BounceRule {
  as_is,          // e |r|
  with_gravity,   // e |r| - c dt: the velocity after the step bounces, gravity included
  after_gravity,  // e |r + c dt|, gravity's part of the step first
  after_both,     // e |r + c dt| - c dt
  end_of_step,    // e times the rate one step of flight later
  at_contact,     // e times the rate where the flight has zero gap, although it is not there
};

/// How an overstretch g < 0 raises the rebound: by -k g / dt, or to it where that is faster.
enum class CorrectionRule { none, added, at_least };

/// The rules of one run.
struct Scheme {
  BounceRule bounce = BounceRule::as_is;
  CorrectionRule correction = CorrectionRule::none;
  double corrected = 0.0;  // [-], k
  double size = 1.0;       // [-], of all rebounds against what they should be: the solver's
  bool ignores = false;    // no impact rebounds, at any speed
  double threshold = 0.0;  // [m/s], impacts up to this do not rebound; 0: all do, or none
  double instant = 0.0;    // [-], 0 to 1: where in a step the velocity jumps
};

/// The jumps of `run`, which is not thinned, in rising time.
[[nodiscard]] std::vector<Jump> jumps_of(const Case& the_case, const Trajectory& run);

/// Finds the rules of the run, and marks the jumps that are lost to its threshold.
[[nodiscard]] Scheme find_scheme(const Case& the_case, std::vector<Jump>& jumps,
                                 const Trajectory& run);

/// The gap rate [m/s] after the bounce of `jump` if it happened at `state`, without a correction;
/// its `bounces` false: as if restitution were 0.
[[nodiscard]] double bounced_rate(const Case& the_case, BounceRule rule, const Jump& jump,
                                  const State& state, bool bounces = true);

/// `rate` [m/s] raised by the correction of the overstretch of `jump`; `bounced_rate` by
/// `rule` gave it.
[[nodiscard]] double corrected_rate(const Case& the_case, const Scheme& scheme, const Jump& jump,
                                    const State& state, double rate);

}  // namespace tautline::bench
