#pragma once

#include <functional>
#include <optional>
#include <string>

#include "bench/vectors/vector.hpp"
#include "tautline/case.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {

/// What `tautline vector` was asked.
struct VectorOptions {
  ImpactLaw law = ImpactLaw::simultaneous;
  int samples = 40;                          // about this many, at equal intervals
  double slowest = 1e-3;                     // [m/s]: impacts that close slower have no row
  std::function<void(int)> on_attempt = {};  // called with the digits of each solution before it
};

/// The vector of a case, or a sentence that says why there is none.
struct VectorReading {
  std::optional<Vector> vector;  // present exactly when `problem` is empty
  std::string problem;
};

/// Solves `the_case`, which has no `problems`, with numbers of many digits, and then of more, until
/// every number of both solutions is the same double. The vector ends where the last cables become
/// taut, or at the case's duration: from there on a scheme that drifts is not wrong about impacts.
/// Not for several threads: see `Digits`.
[[nodiscard]] VectorReading vector_of(const Case& the_case, const VectorOptions& options);

}  // namespace tautline::bench
