#include "bench/check/stepping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "bench/check/measure.hpp"

namespace tautline::bench {

template <class TheCase>
void run(BasicSimulation<TheCase>& simulation, double step, double end, const Look<TheCase>& look) {
  const auto steps = static_cast<long>(std::llround(end / step));
  for (long k = 1; k <= steps; ++k) {
    const StateOf<TheCase> before = simulation.state();
    simulation.step(step);
    const auto stop = simulation.stopped();
    look({stop ? stop->time : static_cast<double>(k) * step, before, simulation.state()});
    if (stop) {
      return;
    }
  }
}

template <class TheCase>
void run_whole(BasicSimulation<TheCase>& simulation, double step, double end,
               const Look<TheCase>& look) {
  run(simulation, step, end, look);
  if (const auto stop = simulation.stopped()) {
    const std::string time = std::isfinite(stop->time) ? fmt::format("{:.4g}", stop->time)
                                                       : std::string(not_finite(stop->time));
    throw RunStopped(fmt::format("the run stopped at t = {}: {}", time, stop->reason));
  }
}

template void run<Case>(Simulation&, double, double, const Look<Case>&);
template void run<SpatialSystem>(SystemSimulation&, double, double, const Look<SpatialSystem>&);
template void run_whole<Case>(Simulation&, double, double, const Look<Case>&);
template void run_whole<SpatialSystem>(SystemSimulation&, double, double,
                                       const Look<SpatialSystem>&);

}  // namespace tautline::bench
