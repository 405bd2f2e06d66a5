#pragma once

#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

// What the page answers first.

/// A sentence for each engine, the worst first.
[[nodiscard]] std::string verdict_paragraph(const Report& report);

/// A row for each model: restitution and position in words, verdict, error and cost.
[[nodiscard]] std::string scorecards_section(const Report& report);

/// Why the reference can be believed, and what the comparison itself costs.
[[nodiscard]] std::string trust_section(const Report& report);

/// A part that few readers want, folded.
[[nodiscard]] std::string folded(const std::string& summary, const std::string& html);

/// A command to be copied.
[[nodiscard]] std::string command_html(const std::string& command);

/// What was compared and what was found, in a paragraph and a list of the main findings.
[[nodiscard]] std::string answer_paragraph(const Report& report);

// The sections of the report's page, in their order.

/// Over all cases, by engine, model and step.
[[nodiscard]] std::string answers_section(const Report& report);

/// Every run.
[[nodiscard]] std::string runs_section(const Report& report);

/// How fast errors shrink with the step.
[[nodiscard]] std::string error_section(const Report& report);

/// Settling over many draws; "" without draws.
[[nodiscard]] std::string distributions_section(const Report& report);

/// What was found of thresholds, sleeping and restitution.
[[nodiscard]] std::string audit_section(const Report& report);

/// The causes of the errors and their shares.
[[nodiscard]] std::string causes_section(const Report& report);

/// How each engine models a cable.
[[nodiscard]] std::string models_section(const Report& report);

/// How to read all of it.
[[nodiscard]] std::string reading_section(const Report& report);

/// What made the page, and how to make it again.
[[nodiscard]] std::string context_section(const Report& report);

}  // namespace tautline::bench
