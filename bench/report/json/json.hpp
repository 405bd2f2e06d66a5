#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/replay/replay.hpp"
#include "bench/report/record.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

// The one place in which a report becomes JSON and is read back. Impacts are rounded here, and
// for a page thinned to what it can hold, and nowhere before. Motions are for the replay alone.

/// `report` with its `replay` as `report_schema_json` describes it, a line for every row, without
/// the motions of its runs.
[[nodiscard]] std::string report_json(const Report& report, const Replay& replay);

/// What the scripts of the report's page read, on one line. `impact_columns` has the names of the
/// columns of which the impacts of a run are a list.
[[nodiscard]] std::string page_json(const Report& report, const Replay& replay);

/// The motions of all runs of a case for a replay, a line each: an array of {engine, model, step,
/// path, impacts}, of which `path` is as in the schema and `impacts` has the columns time [s],
/// cable and speed [m/s], at which it closed. Of the others it says only how many: `left_out`.
[[nodiscard]] std::string motions_json(const Report& report, const Replay& replay,
                                       const std::string& the_case);

/// A report, or in sentences what `text` has that is none. `name` of its file stands before each.
struct ReportReading {
  std::optional<Report> report;  // present exactly when `problems` is empty
  std::vector<std::string> problems = {};
  Replay replay = {};  // of the report, without the paths of its runs
};
[[nodiscard]] ReportReading report_from(std::string_view text, const std::string& name);

/// The schema of a report, which follows from its members and from the list of metrics.
[[nodiscard]] std::string report_schema_json();

/// One run as the report has it, indented.
[[nodiscard]] std::string run_json(const RunRow& run, RunReplay replay);

/// What a model is run with: its settings that are not left alone. Indented.
[[nodiscard]] std::string settings_json(const EngineInfo& engine, const Model& model, double step);

/// All that a run left, with every digit, for `record_from` alone.
[[nodiscard]] std::string record_json(const RunRecord& record, const std::string& fingerprint);

/// A record written with this fingerprint; none where `text` is no such thing.
[[nodiscard]] std::optional<RunRecord> record_from(std::string_view text,
                                                   const std::string& fingerprint);

/// How the rows of `report` contradict each other, as a run of a case that it does not list; empty
/// if they do not.
[[nodiscard]] std::string contradiction(const Report& report);

/// Reads report.json of this version of the program's `bench`. What it gives lists the engine and
/// the case of each of its runs, and no run twice.
[[nodiscard]] ReportReading read_report(const std::filesystem::path& path);

}  // namespace tautline::bench
