#pragma once

#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

// The tables of a report: each once, for Markdown, for a terminal and for a page.

/// The answers over all cases, by engine, model and step: every metric of the list that is shown
/// there, impacts, settling, cost, failures and, in a report with verdicts, what they come to. Last
/// come the engines that are not here, and why.
[[nodiscard]] Table answers_table(const Report& report);

/// Every run: its metrics, impacts, settling, restitution, cost, verdict and how it ended.
[[nodiscard]] Table runs_table(const Report& report);

/// The same of one case.
[[nodiscard]] Table runs_table(const Report& report, const std::string& the_case);

/// How far the distributions of every engine, model and step are from those of the exact motion;
/// empty in a report without draws.
[[nodiscard]] Table distributions_table(const Report& report);

/// What was drawn and what the exact motions do, in sentences; "" in a report without draws.
[[nodiscard]] std::string distributions_paragraph(const Report& report);

/// What the exact solutions say of every case.
[[nodiscard]] Table cases_table(const Report& report);

/// The step that each case needs, by its worst and by its mean shift, and until when a model with
/// each of the suite's steps can follow it.
[[nodiscard]] Table steps_table(const Report& report);

/// The control's own errors where it is only sampled, by metric and step; those that are zero
/// throughout are left out.
[[nodiscard]] Table sampled_table(const Report& report);

/// Until when digits of the exact solutions are right; empty where none was compared with many.
[[nodiscard]] Table certified_table(const Report& report);

/// How fast errors shrink with the step.
[[nodiscard]] Table convergence_table(const Report& report);

/// The shares of the causes of deviations, where they are known.
[[nodiscard]] Table causes_table(const Report& report);

/// Engines that failed, and runs that failed or diverged. Engines that are not here are in the
/// table of the answers.
[[nodiscard]] Table failures_table(const Report& report);

/// The settings of a model that are not left alone, and whose choice each is.
[[nodiscard]] Table settings_table(const Model& model);

}  // namespace tautline::bench
