#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "bench/measure/attribution/cause.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

// Where a run's deviation comes from.
//
// Let s_k be the run's own states at instants t_0 = 0 < t_1 < ... < t_n = T and F(T, t; s) the
// position at T of the exact motion restarted from s at t. The deviation telescopes exactly:
//
//     D(T) = s_n - F(T, 0; s_0) = sum_k [F(T, t_k; s_k) - F(T, t_k-1; s_k-1)]
//
// Each term is what the run did wrong between t_k-1 and t_k, the local defect of one segment,
// carried to T by the exact motion. A segment is one flight, one impact, or one stretch on taut
// cables (segments.hpp). The defect of a flight or an impact is split again by a chain
// of hypothetical states, each with one cause more (chain.hpp); their carried
// differences telescope too. A part is the sum of these differences for one cause, projected on the
// unit vector of D(T); so the parts add up to |D(T)|.
//
// Amplification. Let e be a link's carried difference, d the difference of the two states before
// it is carried, and A, B the derivatives of F at either. To first order |e| <= max(|A d|, |B d|):
// what e has beyond that is not the cause's but the motion's, and counts as amplification:
//
//     cause: w e,  amplification: (1 - w) e,  w = min(1, max(|A d|, |B d|) / |e|)
//
// So does all of a segment whose defect is no larger than the noise of the engine's numbers.
//
// The larger of the two derivatives counts, as neither is the one: amplification is what not even
// that explains.
//
// What is not told apart: parts are what is left at T. Where the exact motion settles, it forgets
// impacts; and a model without restitution that pushes overstretch out rebounds by that instead:
// up to two fifths of its parts are position_correction. An impact that ends a taut stretch is
// looked for from a step or two before the cable is overstretched; a taut stretch so far behind
// that the exact motion has the impact before that counts it as its own, as taut_drift.
//
// T is one of these: the middles after the exact impacts 1, 2, 4, 8 and 16, and, if they are fewer,
// the run's last sample before the horizon. It is the last at which amplification of defects above
// the noise is no more than a tenth of all; if there is none, the first at which it is no more than
// half.

// Soft cables. Where the engine tells that its cables are springs and dampers (`SoftRow`), a third
// motion, `soft`, is made by these springs and dampers (soft_motion.hpp), and at T
//
//     D = (run - soft) + (soft - exact) = step + model,
//
// both along D: what shorter steps would take away, and what they would leave.

struct AttributionOptions {
  ImpactLaw law = ImpactLaw::simultaneous;

  /// Defects up to this size, against the lengths and speeds of the case, are the noise of the
  /// engine's numbers [-].
  double noise = 1e-9;

  /// Slower impacts of the exact motion do not divide the time [m/s]; as CompareOptions.
  double count_speed = 1e-2;
};

/// The noise of an engine [-]: iterations leave some 1e-10 in double; in float a hundred roundings.
[[nodiscard]] double noise_of(std::string_view precision);

/// The parts of the deviation of a run with soft cables [m], signed, along D(T).
struct SoftParts {
  double model = 0.0;  // springs and dampers in place of the cables of the case
  double step = 0.0;   // what else the engine does: its steps, and what it does not tell
};

struct Attribution {
  double until = 0.0;               // [s], T
  double covered = 0.0;             // [-], T as a part of the horizon, or of a shorter exact motion
  double deviation = 0.0;           // [m], |D(T)|
  std::optional<CauseParts> parts;  // [m], signed, along D(T); none where `reason` says why
  double remainder = 0.0;           // [m], |D(T)| minus the parts
  std::size_t arcs = 0;             // flights and taut stretches up to T
  std::size_t impacts = 0;          // impact segments up to T
  std::optional<SoftParts> soft;    // where the cables are soft, and both motions are found
  std::string reason;  // why there are no parts, why T is before the horizon, or no `soft`; or ""
};

/// Attributes the deviation of `run` from `solution`, both of `the_case`, before `horizon` [s].
[[nodiscard]] Attribution attribute(const Case& the_case, const Solution& solution, double horizon,
                                    const Trajectory& run, const AttributionOptions& options = {});
/// Attributes the run of a system: D is of the body that is the farthest off at T (systems.hpp).
[[nodiscard]] Attribution attribute(const SpatialSystem& system,
                                    const BasicSolution<SpatialSystem>& solution, double horizon,
                                    const SystemTrajectory& run,
                                    const AttributionOptions& options = {});

}  // namespace tautline::bench
