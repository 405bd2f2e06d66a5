#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// The number of the report's form: its key `schema`.
inline constexpr int report_schema = 3;

/// What produced a report, apart from its numbers.
struct ReportContext {
  std::string command;          // as it was typed
  std::string started;          // ISO 8601, UTC
  double elapsed = 0.0;         // [s]
  double program_memory = 0.0;  // [bytes], the most this program held at once
  double worker_memory = 0.0;   // [bytes], the most one worker held
  std::size_t kept = 0;         // runs taken from an earlier invocation
};

/// The one product of a suite: an object of bench/report/report.schema.json. Everything that
/// differs between two runs of one suite on one program is under its last key, "context".
[[nodiscard]] nlohmann::ordered_json report_json(const SuiteOptions& options,
                                                 const std::vector<ReferenceCase>& references,
                                                 const SuiteResult& result,
                                                 const ReportContext& context);

/// The answers by engine, model and step over all cases of the runs in `report`.
[[nodiscard]] nlohmann::ordered_json summary_json(const nlohmann::ordered_json& runs);

/// What a step costs over that of a closed-form flight, by engine, model and step: the median of
/// `timing`.
[[nodiscard]] nlohmann::ordered_json costs_json(const nlohmann::ordered_json& timing);

/// How fast errors shrink with the step: by engine and model, the slope of log error over log step.
[[nodiscard]] nlohmann::ordered_json convergence_json(const nlohmann::ordered_json& runs);

/// The report as Markdown, readable as it stands. Drawn from `report` alone.
[[nodiscard]] std::string report_markdown(const nlohmann::ordered_json& report);

/// The answers for a terminal. Drawn from `report` alone.
[[nodiscard]] std::string report_summary(const nlohmann::ordered_json& report,
                                         const TerminalStyle& style = {});

}  // namespace tautline::bench
