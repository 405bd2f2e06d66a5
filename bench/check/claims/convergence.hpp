#pragma once

#include <vector>

#include "bench/check/measure.hpp"
#include "bench/check/subject.hpp"

namespace tautline::bench {

// Whether smaller steps bring a model to the exact motion, and how near.
[[nodiscard]] Measure measure_convergence(const Subject& subject);

/// How far a model is from the exact motion of the standard breakwater with e = 0.9 in two seconds.
struct Convergence {
  std::vector<double> steps;       // [s]
  std::vector<double> deviations;  // [m], the largest distance of the centre of mass
  double slope = 0.0;              // of log(deviation) over log(step)
  bool exact = false;              // at every step: only rounding is left, and no slope
};
[[nodiscard]] Convergence convergence(const Subject& subject);

}  // namespace tautline::bench
