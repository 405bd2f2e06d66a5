#pragma once

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

// The smaller tables of a report: each once, for Markdown, for a terminal and for a page. The large
// ones are in answers_table.hpp and runs_table.hpp.

/// What the exact solutions say of every case.
[[nodiscard]] Table cases_table(const Report& report);

/// Until when digits of the exact solutions are right; empty where none was held against many.
[[nodiscard]] Table certified_table(const Report& report);

/// How fast errors shrink with the step.
[[nodiscard]] Table convergence_table(const Report& report);

/// The shares of the causes of deviations, where they are known.
[[nodiscard]] Table causes_table(const Report& report);

/// Effective less requested restitution over all cases, by engine, model and step.
[[nodiscard]] Table scatter_table(const Report& report);

/// Engines that failed, and runs that failed or diverged. Engines that are not here are in the
/// table of the answers.
[[nodiscard]] Table failures_table(const Report& report);

/// The settings of a model that are not the engine's defaults.
[[nodiscard]] Table settings_table(const Model& model);

}  // namespace tautline::bench
