#pragma once

#include <cstddef>
#include <vector>

#include "bench/measure/attribution/scheme.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"

namespace tautline::bench {

/// A stretch of a run between two of its samples from which the exact motion can be restarted.
template <class TheCase>
struct BasicSegment {
  enum class Kind { flight, impact, taut };
  Kind kind;
  std::size_t first;  // index into the points of the run
  std::size_t last;   //
  StateOf<TheCase>
      start;             // the run's; put onto the cables where a body that sticks is overstretched
  StateOf<TheCase> end;  // the next segment's start
  CableSet held;         // taut at the start: a stretch on them is before this one
};
using PlanarSegment = BasicSegment<Case>;

/// Cuts `run`, which is not thinned, at `points`[0] to [`last`]: flights, and between them the
/// steps in which cables act or are overstretched. Of these, a stretch in which the same cable
/// stays at zero rate is taut, and so is one in which jumps follow each other too fast for single
/// flights. A taut stretch ends where another cable has an impact.
[[nodiscard]] std::vector<PlanarSegment> segments(const Case& the_case, const Trajectory& run,
                                                  const std::vector<Jump>& jumps, std::size_t last);

}  // namespace tautline::bench
