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
  std::optional<double> step;     // [s]; none: `why`
  double error = 0.0;             // [-], of the shortest cable, with that step
  double cost = 0.0;              // [s], processor time of a simulated second with it
  std::string why;                // what was tried in vain, where no step was found
  bool measured = false;          // a run came to the end of what is asked
  std::optional<double> located;  // [-], the error at 0.01 s of a model that locates its impacts
};

/// What was found of the models of a case.
struct StepSearch {
  std::vector<StepFound> found;  // in the order of the plan; fewer if the program is interrupted
  std::size_t models = 0;        // that were to be searched

  /// True if a run of some model came to the end.
  [[nodiscard]] bool measured() const;
};

/// Searches for every model of `options`, on the case or system of `reference`; `needed` says what
/// is asked. Tries 1, 2 and 5 times powers of ten, from 0.01 s or `typical`, whichever is longer,
/// down to a tenth of `safe`, or to 0.0001 s if that is not known. It ends before that if the error
/// does not fall with the step, if a run takes too long, or if the model refuses the case.
template <class TheReference>
[[nodiscard]] StepSearch search_steps(const SuiteOptions& options, const TheReference& reference,
                                      const StepNeeded& needed);

/// The result in sentences and a table, the cheapest first.
template <class TheReference>
[[nodiscard]] std::string steps_text(const TheReference& reference, const StepNeeded& needed,
                                     std::vector<StepFound> found);

}  // namespace tautline::bench
