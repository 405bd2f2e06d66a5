#pragma once

#include <optional>

#include "bench/check/subject.hpp"

namespace tautline::bench {

/// What the first hit on cable 0 did. A contact may take several steps.
struct Hit {
  State before;    // at the pose of its first solve
  State after;     // at the pose of its last one, with the velocity it left
  double impulse;  // [N s], all of it
  int steps;       // that it took; 0 if the simulation located it
};

/// The first hit of a run of `the_case` up to `end` [s]; none if no impulse is reported.
[[nodiscard]] std::optional<Hit> first_hit(const Subject& subject, const Case& the_case,
                                           double step, double end);

}  // namespace tautline::bench
