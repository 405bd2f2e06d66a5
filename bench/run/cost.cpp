#include "bench/run/cost.hpp"

#include <algorithm>
#include <ctime>

#include "bench/base/process.hpp"
#include "tautline/flight.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// The most steps that are timed: enough to average over impacts, cheap next to the run itself.
constexpr std::size_t timed_steps = 20'000;

/// Processor time of this thread [s].
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Steps `simulation` as often as is timed; how often that was.
std::size_t take_steps(Simulation& simulation, double duration, double step) {
  const auto whole_steps = static_cast<std::size_t>(duration / step);
  const std::size_t most = std::max<std::size_t>(1, std::min(whole_steps, timed_steps));
  const double dt = std::min(step, duration);
  std::size_t done = 0;
  for (; done < most && !simulation.stopped(); ++done) {
    simulation.step(dt);
  }
  return done;
}

/// As many closed-form flights with their gaps.
void take_flights(const Case& the_case, std::size_t count, double dt) {
  double sum = 0.0;
  for (std::size_t index = 0; index < count; ++index) {
    const State state = fly(the_case.initial, the_case.gravity, static_cast<double>(index) * dt);
    for (const Cable& cable : the_case.cables) {
      sum += gap(cable, state);
    }
  }
  [[maybe_unused]] const volatile double keep = sum;  // the loop must not be optimised away
}

}  // namespace

Cost measure_cost(const Case& the_case, const Engine& engine, const std::string& model,
                  const RunSettings& settings) {
  const double start = processor_time();
  const auto simulation = engine.start(the_case, model, settings);
  const std::size_t steps = take_steps(*simulation, the_case.duration, settings.step);
  const double middle = processor_time();
  take_flights(the_case, steps, std::min(settings.step, the_case.duration));
  const double end = processor_time();
  const auto count = static_cast<double>(std::max<std::size_t>(1, steps));
  return {(middle - start) / count, peak_memory(), (end - middle) / count};
}

}  // namespace tautline::bench
