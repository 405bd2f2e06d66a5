#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/judge/step_needed.hpp"
#include "bench/store/plan.hpp"

namespace tautline::bench {

/// The largest step with which a model holds what is asked of it, confirmed by a run with that
/// step.
struct StepFound {
  std::string engine;
  std::string model;
  std::optional<double> step;  // [s]; none: `why`
  double error = 0.0;          // [-], of the shortest cable, with that step
  double cost = 0.0;           // [s], processor time of a simulated second with it
  std::string why;             // why no step was found
};

/// For every model of `options`, on the case of `reference`, in the order of the plan; `needed`
/// says what is asked. Tries 1, 2 and 5 times powers of ten, from 0.01 s or `typical`, whichever is
/// longer, down to a tenth of `safe`; from there on ends where the error does not fall with the
/// step. Fewer where the program is interrupted.
[[nodiscard]] std::vector<StepFound> search_steps(const SuiteOptions& options,
                                                  const ReferenceCase& reference,
                                                  const StepNeeded& needed);

/// The result in sentences and a table, the cheapest first.
[[nodiscard]] std::string steps_text(const ReferenceCase& reference, const StepNeeded& needed,
                                     std::vector<StepFound> found);

}  // namespace tautline::bench
