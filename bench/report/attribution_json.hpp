#pragma once

#include <nlohmann/json.hpp>

#include "bench/base/table.hpp"
#include "bench/measure/attribution/attribution.hpp"

namespace tautline::bench {

/// A run's "attribution" of bench/report/report.schema.json.
[[nodiscard]] nlohmann::ordered_json attribution_json(const Attribution& attribution);

/// By engine, model and step over the cases of the rows in `runs`: the median share of each cause.
[[nodiscard]] nlohmann::ordered_json attribution_summary_json(const nlohmann::ordered_json& runs);

/// The summary as a table, drawn from `report` alone.
[[nodiscard]] Table attribution_table(const nlohmann::ordered_json& report);

/// How to read that table, for the report.
[[nodiscard]] const char* attribution_reading();

}  // namespace tautline::bench
