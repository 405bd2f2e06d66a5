#pragma once

#include <functional>
#include <stdexcept>
#include <type_traits>

#include "tautline/engine.hpp"

namespace tautline::bench {

/// What most claims are measured with [s].
inline constexpr double usual_step = 1e-3;

/// A time at which a simulation was looked at, and its state there.
template <class TheCase>
struct BasicMoment {
  double time;              // [s]
  StateOf<TheCase> before;  // the latest step
  StateOf<TheCase> after;   // it
};
using Moment = BasicMoment<Case>;
using SystemMoment = BasicMoment<SpatialSystem>;

/// Called at each moment.
template <class TheCase>
using Look = std::type_identity_t<std::function<void(const BasicMoment<TheCase>&)>>;

/// Steps `simulation` of a `Case` or a `SpatialSystem` with `step` until `end` [s] or until it
/// stops, and shows every step to `look`, the one in which it stops included.
template <class TheCase>
void run(BasicSimulation<TheCase>& simulation, double step, double end, const Look<TheCase>& look);

/// A run that says it cannot go on, where it must.
class RunStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The same, to the end: throws RunStopped with the reason if the simulation stops before.
template <class TheCase>
void run_whole(BasicSimulation<TheCase>& simulation, double step, double end,
               const Look<TheCase>& look);

}  // namespace tautline::bench
