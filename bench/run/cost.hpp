#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// What one step cost, measured on the processor clock of the worker's thread over several
/// repetitions.
struct Cost {
  double step = 0.0;       // [s], processor time of one step, median
  double memory = 0.0;     // [bytes], the most the worker held at once
  double reference = 0.0;  // [s], of one closed-form flight and its gaps, measured side by side
  double smallest = 0.0;   // [s], of a step in the fastest repetition
  double lower = 0.0;      // [s], its lower quartile
  double upper = 0.0;      // [s], its upper quartile
  double dt = 1.0;         // [s], length of a step: the run's own, or all that is timed
  std::size_t repetitions = 0;
};

/// What an engine uses, as a clock and a gauge.
struct Meter {
  std::function<double()> processor_time;  // [s], since some instant
  std::function<double()> peak_memory;     // [bytes], the most at once
};

/// The meter of an engine that computes in this thread.
[[nodiscard]] Meter own_meter();

/// The motion that is timed [s], from the start of a case and the same at every step: timed over
/// different stretches, a small step could look cheaper than a large one. The first hits of the
/// shipped cases are in it.
inline constexpr double timed_motion = 1.0;

/// The cost of runs of `the_case` that are only stepped. The start of a simulation does not count.
template <class TheCase>  // Case or SpatialSystem
[[nodiscard]] Cost measure_cost(const TheCase& the_case, const Engine& engine,
                                const std::string& model, const RunSettings& settings,
                                const Meter& meter = own_meter());

/// A run of `the_case`, of either kind, with one of the models of `engine`.
[[nodiscard]] inline std::unique_ptr<Simulation> started(const Engine& engine, const Case& the_case,
                                                         const std::string& model,
                                                         const RunSettings& settings) {
  return engine.start(the_case, model, settings);
}
/// Throws std::invalid_argument if the cables of the system are none that the model says it runs.
[[nodiscard]] std::unique_ptr<SystemSimulation> started(const Engine& engine,
                                                        const SpatialSystem& system,
                                                        const std::string& model,
                                                        const RunSettings& settings);

}  // namespace tautline::bench
