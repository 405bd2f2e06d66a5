#pragma once

#include <vector>

#include "bench/solution/samples.hpp"
#include "tautline/detail/swing.hpp"

namespace tautline::bench {

/// A tension and when it is reached.
struct TensionAt {
  Bounded tension;  // [N]
  Bounded time;     // [s]
};

/// A stretch of time in which one cable stays taut.
struct TautPhase {
  std::size_t cable;
  Bounded from;        // [s]
  Bounded until;       // [s], the end of the solution at most
  TensionAt least;     // the first time, where it is reached again
  TensionAt largest;   // the same
  bool indeterminate;  // statics do not determine its share: redundant cables are taut with it
};

/// Those of every cable, by time and then by cable. A cable that is taut for an instant has none.
[[nodiscard]] std::vector<TautPhase> taut_phases(const Case& the_case, const Solution& solution,
                                                 const Uncertainty& uncertainty);

/// The extremes of a cable's tension over a period.
struct PeriodTension {
  std::size_t cable;
  Bounded least;    // [N]
  Bounded largest;  // [N]
};

/// Those of `cables` in the periodic motion `swing` on them, in which the body of `the_case` is at
/// `state`. Its energy may be off by `energy_error` [J]; a motion of a little more energy shows
/// what that does. None where numbers are too large to solve that one.
[[nodiscard]] std::vector<PeriodTension> period_tensions(const Case& the_case, const State& state,
                                                         CableSet cables, const Swing& swing,
                                                         double energy_error);

}  // namespace tautline::bench
