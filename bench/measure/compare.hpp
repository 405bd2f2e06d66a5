#pragma once

#include <cstddef>

#include "bench/measure/metrics.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::bench {

struct CompareOptions {
  /// An impact slower than this is not counted [m/s]: near an accumulation there are infinitely
  /// many.
  double count_speed = 1e-2;

  /// The early window ends with this impact of the exact solution: before errors have grown.
  std::size_t early_impacts = 5;
};

/// True where nothing but impacts and drag changes the energy.
[[nodiscard]] constexpr bool keeps_energy(const Case& /*the_case*/) { return true; }
[[nodiscard]] bool keeps_energy(const SpatialSystem& system);

/// Holds `run` against `solution`, both of `the_case`; `settling` of the solution, `horizon` [s]
/// from `predictability_horizon`. Of a system what is furthest off of its bodies counts. Windows
/// end where the exact solution says; what a run that ends earlier does not reach, it misses.
[[nodiscard]] Metrics compare(const Case& the_case, const Solution& solution,
                              const Settling& settling, double horizon, const Trajectory& run,
                              const CompareOptions& options = {});
/// A system is compared likewise.
[[nodiscard]] Metrics compare(const SpatialSystem& system,
                              const BasicSolution<SpatialSystem>& solution,
                              const SystemSettling& settling, double horizon,
                              const SystemTrajectory& run, const CompareOptions& options = {});

}  // namespace tautline::bench
