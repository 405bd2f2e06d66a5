#pragma once

#include <cstddef>
#include <vector>

#include "bench/measure/attribution/chain.hpp"
#include "bench/measure/attribution/segments.hpp"
#include "bench/run/trajectory.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

// How a run of a system in space is cut, and the chains of its segments.
//
//     exact                the exact flight or impact, restarted from the segment's start
//   + event_lag            the exact rebound rates, but at the instant and pose of the run's jumps
//   + late_rate            the restitution of the rates there
//   + solver_residual      the run's own jumps of velocity; restitution_ignored where none rebounds
//   + rotation_in_flight   the run's own orientations and spins
//   + flight_bias          the run's own state
//
// A flight has the last two alone. No rule is read from the run as in the plane: a threshold and a
// correction of the position that is done by velocity are in solver_residual, one by a shift in
// flight_bias. An impact that ends a stretch on taut cables is in taut_drift.

class SystemReading {
 public:
  /// Both must outlive this. `run` is not thinned.
  SystemReading(const SpatialSystem& system, const SystemTrajectory& run);

  /// Cuts the run at its points 0 to [`last`].
  [[nodiscard]] std::vector<BasicSegment<SpatialSystem>> segments(std::size_t last) const;

  /// The chain of `segment`; `exact` is the motion restarted from its start, with times from there.
  [[nodiscard]] BasicChain<SpatialSystem> chain(const BasicSegment<SpatialSystem>& segment,
                                                const BasicSolution<SpatialSystem>& exact) const;

 private:
  const SpatialSystem& system_;
  const SystemTrajectory& run_;
  bool ignores_;  // no impact of the run rebounds
};

}  // namespace tautline::bench
