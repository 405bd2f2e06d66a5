#pragma once

#include <functional>
#include <stdexcept>

#include "tautline/engine.hpp"

namespace tautline::bench {

/// What most claims are measured with [s].
inline constexpr double usual_step = 1e-3;

/// A time at which a simulation was looked at, and its state there.
struct Moment {
  double time;   // [s]
  State before;  // the latest step
  State after;   // it
};

/// Steps `simulation` with `step` until `end` [s] or until it stops, and shows every step to
/// `look`, the one in which it stops included.
void run(Simulation& simulation, double step, double end,
         const std::function<void(const Moment&)>& look);

/// A run that says it cannot go on, where it must.
class RunStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same, to the end: throws RunStopped with the reason if the simulation stops before.
void run_whole(Simulation& simulation, double step, double end,
               const std::function<void(const Moment&)>& look);

}  // namespace tautline::bench
