#include "bench/run/cost.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "bench/base/process.hpp"
#include "bench/base/statistics.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/model_table.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline::bench {
namespace {

/// Repetitions: enough for quartiles, where so many steps are still cheap beside the run itself.
constexpr std::size_t fewest_repetitions = 3;
constexpr std::size_t most_repetitions = 9;
constexpr std::size_t timed_steps = 20'000;

/// Processor time of this thread [s].
double thread_time() { return clock_time(CLOCK_THREAD_CPUTIME_ID); }

/// Steps `simulation` so often, unless it stops; how often that was.
std::size_t take_steps(auto& simulation, std::size_t most, double dt) {
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

/// The bodies of a system fly without a turn.
void take_flights(const SpatialSystem& system, std::size_t count, double dt) {
  double sum = 0.0;
  SpatialSystemState state = system.initial;
  const Eigen::Vector3d gravity = system.gravity.at(0.0);
  for (std::size_t index = 0; index < count; ++index) {
    const double time = static_cast<double>(index) * dt;
    for (std::size_t body = 0; body < state.bodies.size(); ++body) {
      const SpatialState& start = system.initial.bodies[body];
      state.bodies[body].position =
          start.position + time * start.velocity + 0.5 * time * time * gravity;
    }
    for (const SpatialCable& cable : system.cables) {
      sum += gap(cable, state);
    }
  }
  [[maybe_unused]] const volatile double keep = sum;
}

}  // namespace

Meter own_meter() { return {thread_time, peak_memory}; }

std::unique_ptr<SystemSimulation> started(const Engine& engine, const SpatialSystem& system,
                                          const std::string& model, const RunSettings& settings) {
  const EngineInfo info = engine.info();
  const auto listed = std::ranges::find(info.models, model, &Model::name);
  if (listed != info.models.end()) {  // of another model the engine says that there is none
    check_cables_of(*listed, system);
  }
  return engine.start_system(system, model, settings);
}

template <class TheCase>
Cost measure_cost(const TheCase& whole_case, const Engine& engine, const std::string& model,
                  const RunSettings& settings, const Meter& meter) {
  const double motion = std::min(timed_motion, whole_case.duration);
  TheCase the_case = whole_case;
  the_case.duration = motion;  // an engine that computes ahead computes nothing else
  const double dt = std::min(settings.step, motion);
  const auto wanted = static_cast<std::size_t>(std::lround(motion / dt));
  const std::size_t repetitions =
      std::clamp(timed_steps / wanted, fewest_repetitions, most_repetitions);
  std::vector<double> of_step;    // [s]
  std::vector<double> of_flight;  // [s]
  for (std::size_t repetition = 0; repetition < repetitions; ++repetition) {
    const auto simulation = started(engine, the_case, model, settings);
    const double start = meter.processor_time();
    const std::size_t steps = take_steps(*simulation, wanted, dt);
    const double end = meter.processor_time();
    const double flights = thread_time();
    take_flights(the_case, steps, dt);
    const auto count = static_cast<double>(std::max<std::size_t>(1, steps));
    of_step.push_back((end - start) / count);
    of_flight.push_back((thread_time() - flights) / count);
  }
  return {.step = median(of_step),
          .memory = meter.peak_memory(),
          .reference = median(of_flight),
          .smallest = quantile(of_step, 0.0),
          .lower = quantile(of_step, 0.25),
          .upper = quantile(of_step, 0.75),
          .dt = dt,
          .repetitions = repetitions};
}

template Cost measure_cost(const Case&, const Engine&, const std::string&, const RunSettings&,
                           const Meter&);
template Cost measure_cost(const SpatialSystem&, const Engine&, const std::string&,
                           const RunSettings&, const Meter&);

}  // namespace tautline::bench
