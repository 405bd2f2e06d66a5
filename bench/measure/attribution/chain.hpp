#pragma once

#include <array>
#include <vector>

#include "bench/measure/attribution/cause.hpp"
#include "bench/measure/attribution/scheme.hpp"
#include "bench/measure/attribution/segments.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {

// One segment's way from the exact motion to the run's own state. Every state belongs to the
// segment's end, and all are flown there by the exact parabola, through the cable or back in time
// where need be: at an impact that is late by a little, equal times are on different sides of the
// jump, and only the continued flights are near each other.
//
//     exact                the exact impact, restarted from the segment's start
//   + event_lag            the exact rebound rate, but at the instant and pose of the run's jump
//   + late_rate            the rebound of the run's rule (BounceRule) at that pose
//   + position_correction  raised by the run's correction (CorrectionRule)
//   + threshold            the rebound lost, as that of all slow impacts
//   + solver_residual      the run's own jump of velocity
//   + position_correction  the pose shifted out along the cable
//   + flight_bias          the run's own state
//   + event_lag            put back onto the cable, if a taut stretch follows overstretched
//
// Where no impact of the run rebounds, restitution_ignored replaces late_rate and threshold: the
// rebound is lost before it is corrected.

/// A hypothetical state at the end of a segment, and the cause that it has beyond the one before.
template <class TheCase>
struct BasicLink {
  Cause cause;
  StateOf<TheCase> state;
};

template <class TheCase>
struct BasicChain {
  StateOf<TheCase> exact;                 // without any of the causes
  std::vector<BasicLink<TheCase>> links;  // the last is the end of the segment
};
using PlanarChain = BasicChain<Case>;

/// `state` with impulses on `cables` that give them the gap rates `wanted` [m/s], by cable.
template <class TheCase>
[[nodiscard]] StateOf<TheCase> with_rates(const TheCase& the_case, const StateOf<TheCase>& state,
                                          CableSet cables,
                                          const std::array<double, max_cables>& wanted) {
  if (cables.empty()) {
    return state;
  }
  CableVector change = -gap_rates(the_case, state, cables);
  Eigen::Index row = 0;
  for (const std::size_t cable : cables) {
    change[row++] += wanted.at(cable);
  }
  return with_impulses(the_case, state, cables, multipliers(the_case, state, cables, change));
}

/// The chain of `segment`; `exact` is the motion restarted from its start, with times from there.
[[nodiscard]] PlanarChain chain_of(const Case& the_case, const Trajectory& run,
                                   const PlanarSegment& segment, const std::vector<Jump>& jumps,
                                   const Scheme& scheme, const Solution& exact);

}  // namespace tautline::bench
