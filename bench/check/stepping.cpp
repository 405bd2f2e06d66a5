#include "bench/check/stepping.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "bench/check/measure.hpp"

namespace tautline::bench {

void run(Simulation& simulation, double step, double end,
         const std::function<void(const Moment&)>& look) {
  const auto steps = static_cast<long>(std::llround(end / step));
  for (long k = 1; k <= steps; ++k) {
    const State before = simulation.state();
    simulation.step(step);
    const auto stop = simulation.stopped();
    look({stop ? stop->time : static_cast<double>(k) * step, before, simulation.state()});
    if (stop) {
      return;
    }
  }
}

void run_whole(Simulation& simulation, double step, double end,
               const std::function<void(const Moment&)>& look) {
  run(simulation, step, end, look);
  if (const auto stop = simulation.stopped()) {
    const std::string time = std::isfinite(stop->time) ? fmt::format("{:.4g}", stop->time)
                                                       : std::string(not_finite(stop->time));
    throw RunStopped(fmt::format("the run stopped at t = {}: {}", time, stop->reason));
  }
}

}  // namespace tautline::bench
