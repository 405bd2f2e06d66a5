#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// The report as one page that needs no other file and no network: all of it in plain HTML, and the
/// charts by the page's scripts. Drawn from `report` alone; every number in its tables is one of
/// `report`, and stands in full in the cell's data-value.
[[nodiscard]] std::string report_html(const nlohmann::ordered_json& report,
                                      const PageAssets& assets);

// Its sections, in their order.

/// What was compared and what was found, in a paragraph.
[[nodiscard]] std::string answer_paragraph(const nlohmann::ordered_json& report);

/// Over all cases, by engine, model and step.
[[nodiscard]] std::string answers_section(const nlohmann::ordered_json& report);

/// Every run.
[[nodiscard]] std::string cases_section(const nlohmann::ordered_json& report);

/// How fast errors shrink with the step.
[[nodiscard]] std::string error_section(const nlohmann::ordered_json& report);

/// What was found of thresholds, sleeping and restitution.
[[nodiscard]] std::string audit_section(const nlohmann::ordered_json& report);

/// The causes of the errors and their shares.
[[nodiscard]] std::string attribution_section(const nlohmann::ordered_json& report);

/// How each engine models a cable.
[[nodiscard]] std::string models_section(const nlohmann::ordered_json& report);

/// How to read all of it.
[[nodiscard]] std::string reading_section(const nlohmann::ordered_json& report);

/// What made the page, and how to make it again.
[[nodiscard]] std::string context_section(const nlohmann::ordered_json& report);

}  // namespace tautline::bench
