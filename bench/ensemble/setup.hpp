#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/ensemble/spec.hpp"
#include "bench/run/registry.hpp"
#include "tautline/case.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// Who solves all draws of an ensemble, and how.
struct EnsembleSetup {
  std::string name;                   // "exact", "sequential", "ode event 0.001"
  ExactVariant exact;                 // of an engine the motion that it is to follow
  std::optional<std::size_t> engine;  // index into the engines; none: the exact solver
  std::string model;                  // of it
  double step = 0.0;                  // [s], of it
};

/// The exact motion first, its variants, then each engine with each model and step. Requires
/// engines that have answered what they are.
[[nodiscard]] std::vector<EnsembleSetup> setups_of(const EnsembleSpec& spec,
                                                   const std::vector<RegisteredEngine>& engines);

/// How the exact motion of `setup` is solved.
[[nodiscard]] SolveOptions options_of(const EnsembleSetup& setup);

/// The case that `setup` solves for draw `index`.
[[nodiscard]] AnyCase case_of(const EnsembleSpec& spec, const EnsembleSetup& setup,
                              std::size_t index);

/// The same, its name followed by which draw it is and by its point of the grids, if there are any:
/// "standard, draw 17: spin = 2".
[[nodiscard]] AnyCase named_case_of(const EnsembleSpec& spec, const EnsembleSetup& setup,
                                    std::size_t index);

}  // namespace tautline::bench
