#pragma once

#include <optional>

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

/// What the first hit on cable 0 did. A contact may take several steps.
template <class TheCase>
struct BasicHit {
  StateOf<TheCase> before;  // at the pose of its first solve
  StateOf<TheCase> after;   // at the pose of its last one, with the velocity it left
  double impulse;           // [N s], all of it
  int steps;                // that it took; 0 if the simulation located it
};
using Hit = BasicHit<Case>;
using SystemHit = BasicHit<SpatialSystem>;

/// The first hit of a run of `the_case`, a `Case` or a `SpatialSystem`, up to `end` [s]; empty if
/// no impulse is reported.
template <class TheCase>
[[nodiscard]] std::optional<BasicHit<TheCase>> first_hit(const Subject& subject,
                                                         const TheCase& the_case, double step,
                                                         double end);

/// The measure of a run in which the cable is not hit.
[[nodiscard]] Measure never_hit(double limit);

}  // namespace tautline::bench
