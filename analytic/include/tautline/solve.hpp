#pragma once

#include <cstddef>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline {

struct SolveOptions {
  /// A rebound slower than this may be the start of the end of an accumulation [m/s]. Projecting
  /// the velocity there changes the later motion by about the cube of it: 1e-18 for the default.
  double capture_speed = 1e-6;

  /// The run ends with Ending::event_limit after this many events.
  std::size_t max_events = 1'000'000;
};

/// The exact motion of `the_case` from time 0. Never throws on a case without `problems`; a case
/// with problems is a caller's mistake and throws std::invalid_argument with the first of them.
[[nodiscard]] Solution solve(const Case& the_case, const SolveOptions& options = {});

}  // namespace tautline
