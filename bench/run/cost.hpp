#pragma once

#include <string>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

/// What one step cost, measured on the processor clock of the worker's thread.
struct Cost {
  double step = 0.0;       // [s], processor time of one step, with its share of the start
  double memory = 0.0;     // [bytes], the most the worker held at once
  double reference = 0.0;  // [s], of one closed-form flight and its gaps, measured side by side
};

/// The cost of a run of `the_case` that is only started and stepped.
[[nodiscard]] Cost measure_cost(const Case& the_case, const Engine& engine,
                                const std::string& model, const RunSettings& settings);

}  // namespace tautline::bench
