#pragma once

#include <cstddef>
#include <type_traits>

#include "bench/run/trajectory.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

struct RecordOptions {
  /// More steps than this are thinned to every second, every third, ...; impacts, overstretch and
  /// energy are still taken from every step.
  std::size_t most_points = std::size_t{1} << 18U;

  /// Impacts that close slower than this are only counted [m/s]: near an accumulation and on a taut
  /// cable there is no end of them.
  double slowest = 1e-3;
};

/// Steps `simulation` of `the_case`, a `Case` or a `SpatialSystem`, to the case's duration and
/// records it. The one impact detector for all engines is in here: a simulation that locates its
/// impacts is believed; else a run of consecutive steps with an impulse of one cable is one impact
/// of that cable. A simulation that tells of its tensions (`TensionImpulses`) has them recorded.
/// Throws std::runtime_error if the simulation says what makes no sense: too few impulses, an event
/// of a cable that is not there, a time outside the run.
template <class TheCase>
[[nodiscard]] BasicTrajectory<TheCase> record(
    const TheCase& the_case, std::type_identity_t<BasicSimulation<TheCase>>& simulation,
    double step, const RecordOptions& options = {});

/// The laws of the cables of `simulation`, one for each; empty where they are no springs and
/// dampers. Throws std::runtime_error if the simulation gives laws that make no sense.
template <class TheCase>
[[nodiscard]] std::vector<SoftRow> soft_rows_of(const TheCase& the_case,
                                                const BasicSimulation<TheCase>& simulation);

/// The speed that a system makes likely at most [m/s]: of a fall by its longest cable, of its
/// start, and of what moves its ends and hauls its cables.
[[nodiscard]] double likely_speed(const SpatialSystem& system);

/// True where `run` goes on to `time` [s]. It may stop where impacts accumulate, and rounding moves
/// that instant: a little before is near enough.
template <class TheCase>
[[nodiscard]] bool reaches(const BasicTrajectory<TheCase>& run, double time) {
  constexpr double near_enough = 0.98;  // [-]
  const double end = run.stop ? run.stop->time : run.points.back().time;
  return end >= near_enough * time;
}

/// More steps than this in one run are refused: at a microsecond each they take 15 minutes.
inline constexpr double most_steps = 1e9;

/// Steps needed for `duration` [s]; the last may be shorter.
[[nodiscard]] std::size_t step_count(double duration, double step);

}  // namespace tautline::bench
