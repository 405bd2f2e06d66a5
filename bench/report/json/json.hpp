#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/report/record.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

// The one place in which a report becomes JSON and is read back. Motions are rounded here, and
// thinned to what a page can hold, and nowhere before; they have been sampled by motion.hpp.

/// `report` as bench/report/report.schema.json describes it, a line for every row.
[[nodiscard]] std::string report_json(const Report& report);

/// The same on one line and without what only tools read: verdicts and output. For a page's script.
[[nodiscard]] std::string page_json(const Report& report);

/// A report, or in sentences what `text` has that is none. `name` of its file stands before each.
struct ReportReading {
  std::optional<Report> report;  // present exactly when `problems` is empty
  std::vector<std::string> problems;
};
[[nodiscard]] ReportReading report_from(std::string_view text, const std::string& name);

/// The schema of a report, whose part on metrics follows from the list of them.
[[nodiscard]] std::string report_schema_json();

/// One run as the report has it, indented.
[[nodiscard]] std::string run_json(const RunRow& run);

/// What a model is run with: its settings that are not the engine's defaults. Indented.
[[nodiscard]] std::string settings_json(const EngineInfo& engine, const Model& model, double step);

/// All that a run left, with every digit, for `record_from` alone.
[[nodiscard]] std::string record_json(const RunRecord& record, const std::string& fingerprint);

/// A record written with this fingerprint; none where `text` is no such thing.
[[nodiscard]] std::optional<RunRecord> record_from(std::string_view text,
                                                   const std::string& fingerprint);

}  // namespace tautline::bench
