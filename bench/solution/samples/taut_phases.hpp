#pragma once

#include <vector>

#include "bench/solution/samples/samples.hpp"

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

}  // namespace tautline::bench
