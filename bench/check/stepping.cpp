#include "bench/check/stepping.hpp"

#include <fmt/format.h>

#include <cmath>

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
    throw RunStopped(fmt::format("the run stopped at t = {:.4g}: {}", stop->time, stop->reason));
  }
}

}  // namespace tautline::bench
