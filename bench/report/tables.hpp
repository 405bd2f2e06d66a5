#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/base/table.hpp"

namespace tautline::bench {

// The tables of a report, each drawn from the report alone.

/// The answers over all cases, by engine, model and step.
[[nodiscard]] Table summary_table(const nlohmann::ordered_json& report);

[[nodiscard]] Table convergence_table(const nlohmann::ordered_json& report);

/// What the exact solutions say of every case.
[[nodiscard]] Table cases_table(const nlohmann::ordered_json& report);

/// Every run of the case `name` that there is something to say of.
[[nodiscard]] Table case_table(const nlohmann::ordered_json& report,
                               const nlohmann::ordered_json& name);

/// Engines that are not here and runs that failed or diverged.
[[nodiscard]] Table failures_table(const nlohmann::ordered_json& report);

/// What the words of the tables mean, as a Markdown list.
[[nodiscard]] std::string how_to_read(const nlohmann::ordered_json& report);

/// Says which models stopped before their end, each with its first reason, and that this is no
/// failure; "" without one.
[[nodiscard]] std::string stopped_sentence(const nlohmann::ordered_json& report);

/// Effective less requested restitution over all cases, by engine, model and step.
[[nodiscard]] Table scatter_table(const nlohmann::ordered_json& report);

/// What the models do to impacts, as a Markdown list.
[[nodiscard]] std::string findings_list(const nlohmann::ordered_json& report);

/// The checks of a verdict that matter: those that do not hold, or else the one that is nearest to
/// not holding. They are `verdict`'s own.
[[nodiscard]] std::vector<const nlohmann::ordered_json*> telling_checks(
    const nlohmann::ordered_json& verdict);

/// A string of the report, safe to print.
[[nodiscard]] std::string report_text(const nlohmann::ordered_json& value);

}  // namespace tautline::bench
