#include "bench/gate/changes_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/gate/changes_fields.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

using Cells = std::vector<std::string>;

/// Rows of one kind that anyone reads; the JSON has them all.
constexpr std::size_t most_rows = 100;

/// One section: a table whose first `left` columns and last `words` hold words; "" without rows.
template <class Row>
std::string section(const std::string& title, const std::vector<Row>& rows, const Cells& headings,
                    std::size_t left, std::size_t words, Cells (*cells_of)(const Row& row),
                    const TerminalStyle& style) {
  if (rows.empty()) {
    return "";
  }
  Table table(headings, left, words);
  for (std::size_t index = 0; index < std::min(most_rows, rows.size()); ++index) {
    table.add(cells_of(rows[index]));
  }
  const std::string rest =
      rows.size() > most_rows ? fmt::format("and {} more\n", rows.size() - most_rows) : "";
  return fmt::format("{} ({}):\n{}{}\n", title, rows.size(), table.plain(style), rest);
}

Cells run_cells(const RunKey& run) {
  return {printable(run.engine), printable(run.model), printable(run.the_case),
          fmt::format("{:g}", run.step)};
}

Cells version_cells(const VersionChange& change) {
  const auto text = [](const std::optional<std::string>& version) {
    return version ? printable(*version) : "not there";
  };
  return {printable(change.what), text(change.before), text(change.after)};
}

Cells status_cells(const StatusChange& change) {
  Cells cells = run_cells(change.key);
  cells.insert(cells.end(),
               {to_string(change.before), to_string(change.after), printable(change.reason)});
  return cells;
}

Cells metric_cells(const MetricChange& change) {
  const Metric& metric = metric_list()[change.metric];
  const auto text = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.3g}", *value) : "not measured";
  };
  const bool has_factor = change.before && change.after && *change.before > 0.0;
  Cells cells = run_cells(change.key);
  cells.insert(cells.end(),
               {std::string(metric.name), text(change.before), text(change.after),
                has_factor ? fmt::format("{:.3g}", *change.after / *change.before) : dash,
                metric.unit == "1" ? "-" : std::string(metric.unit)});
  return cells;
}

Cells cost_cells(const CostChange& change) {
  return {printable(change.key.engine), printable(change.key.model),
          fmt::format("{:g}", change.key.step), std::to_string(change.cases),
          fmt::format("{:.2f}", change.factor)};
}

std::string status_changes(const std::string& title, const std::vector<StatusChange>& rows,
                           const TerminalStyle& style) {
  return section(title, rows, {"engine", "model", "case", "step", "before", "after", "reason"}, 3,
                 3, status_cells, style);
}

std::string metrics(const std::string& title, const std::vector<MetricChange>& rows,
                    const TerminalStyle& style) {
  return section(title, rows,
                 {"engine", "model", "case", "step", "metric", "before", "after", "factor", "unit"},
                 3, 1, metric_cells, style);
}

/// Runs of one engine and model over some steps and cases.
struct RunGroup {
  std::string engine;
  std::string model;
  std::set<double> steps;       // [s]
  std::set<std::string> cases;  //
  std::size_t runs = 0;
};

std::vector<RunGroup> groups_of(const std::vector<RunKey>& runs) {
  std::map<std::pair<std::string, std::string>, RunGroup> groups;
  for (const RunKey& run : runs) {
    RunGroup& group = groups[{run.engine, run.model}];
    group.engine = run.engine;
    group.model = run.model;
    group.steps.insert(run.step);
    group.cases.insert(run.the_case);
    ++group.runs;
  }
  std::vector<RunGroup> result;
  for (auto& [key, group] : groups) {
    result.push_back(std::move(group));
  }
  return result;
}

/// One that is alone by its name, or how many there are.
Cells group_cells(const RunGroup& group) {
  const std::string steps = fmt::format("{:g}", fmt::join(group.steps, ", "));
  const std::string cases = group.cases.size() == 1 ? printable(*group.cases.begin())
                                                    : std::to_string(group.cases.size());
  return {printable(group.engine), printable(group.model), steps, cases,
          std::to_string(group.runs)};
}

/// How many runs, of which engines, models and steps; one that is alone by its name.
std::string counted_runs(const std::string& title, const std::vector<RunKey>& runs,
                         const TerminalStyle& style) {
  if (runs.empty()) {
    return "";
  }
  Table table({"engine", "model", "steps", "cases", "runs"}, 4);
  const std::vector<RunGroup> groups = groups_of(runs);
  for (std::size_t index = 0; index < std::min(most_rows, groups.size()); ++index) {
    table.add(group_cells(groups[index]));
  }
  const std::string rest =
      groups.size() > most_rows
          ? fmt::format("and {} more engines and models\n", groups.size() - most_rows)
          : "";
  return fmt::format("{} ({}):\n{}{}\n", title, runs.size(), table.plain(style), rest);
}

/// Tables that anyone reads; the JSON has them all.
constexpr std::size_t most_tables = 20;

std::string reports_text(const Trend& trend, const TerminalStyle& style) {
  Table table({"report", "runs", "tautline", "started", "file"}, 0, 3);
  for (std::size_t index = 0; index < trend.reports.size(); ++index) {
    const TrendReport& report = trend.reports[index];
    table.add({std::to_string(index + 1), std::to_string(report.runs), printable(report.version),
               printable(report.started), printable(report.name)});
  }
  return table.plain(style);
}

/// A line for each report; the metric stands at the first.
void add_points(Table& table, const TrendRow& row) {
  const Metric& metric = metric_list()[row.metric];
  for (std::size_t index = 0; index < row.points.size(); ++index) {
    const std::string name = index == 0 ? metric_heading(metric) : "";
    const std::string number = std::to_string(index + 1);
    const std::optional<TrendPoint>& point = row.points[index];
    if (!point) {
      table.add({name, number, "no runs"});
      continue;
    }
    table.add(
        {name, number, printable(point->version), number_text(point->median, metric.digits),
         number_text(point->low, metric.digits) + " to " + number_text(point->high, metric.digits),
         std::to_string(row.cases), count_or_dash(point->worse), count_or_dash(point->better)});
  }
}

}  // namespace

std::string metric_heading(const Metric& metric) {
  return std::string(metric.brief) +
         (metric.unit == "1" ? "" : " [" + std::string(metric.unit) + "]");
}

std::string count_or_dash(std::size_t count) {
  return count == 0 ? std::string(dash) : std::to_string(count);
}

std::string changes_sentence(const Changes& changes) {
  const std::size_t bad = changes.count_worse();
  const std::size_t good = changes.count_better();
  const std::string beyond =
      fmt::format("beyond noise and a tolerance of {:g} %", 100.0 * changes.noise.tolerance);
  if (bad + good == 0) {
    return fmt::format("{} compared: nothing changed {}.", counted(changes.compared, "run"),
                       beyond);
  }
  const std::string gone =
      changes.only_before.empty()
          ? ""
          : fmt::format(" ({} of them runs that are gone)", changes.only_before.size());
  return fmt::format("{} compared: {} for the worse{}, {} for the better. A changed number is {}.",
                     counted(changes.compared, "run"), counted(bad, "change"), gone, good, beyond);
}

std::string missing_text(const Changes& changes, const TerminalStyle& style) {
  return status_changes("New failures", changes.new_failures, style) +
         counted_runs("Runs that are gone", changes.only_before, style);
}

std::string changes_text(const Changes& changes, const TerminalStyle& style) {
  return section("Versions that differ", changes.versions, {"what", "before", "after"}, 3, 0,
                 version_cells, style) +
         status_changes("New failures", changes.new_failures, style) +
         metrics("Worse", changes.got_worse, style) +
         counted_runs("Runs that are gone", changes.only_before, style) +
         status_changes("Failures that are gone", changes.recovered, style) +
         metrics("Better", changes.got_better, style) +
         counted_runs("New runs", changes.only_after, style) +
         counted_runs("Not compared, the case is not the same", changes.other_case, style) +
         section("Costs of a step, which are noisy and judge nothing", changes.costs,
                 {"engine", "model", "step", "cases", "factor"}, 2, 0, cost_cells, style) +
         wrapped(changes_sentence(changes), style.text);
}

std::string trend_text(const Trend& trend, bool all, const TerminalStyle& style) {
  const Cells headings = {"metric",    "report", "version", "median",
                          "quartiles", "cases",  "worse",   "better"};
  std::map<SetupKey, Table> tables;
  std::size_t moving = 0;
  for (const TrendRow& row : trend.rows) {
    moving += row.moves() ? 1U : 0U;
    if (all || row.moves()) {
      Table& table = tables.try_emplace(row.key, headings, 3).first->second;
      add_points(table, row);
    }
  }
  std::string result = reports_text(trend, style) + "\n";
  std::size_t shown = 0;
  for (const auto& [key, table] : tables) {
    if (!all && ++shown > most_tables) {
      result +=
          fmt::format("and {} more tables: --all prints them\n\n", tables.size() - most_tables);
      break;
    }
    result += fmt::format("{} {}, step {:g} s\n{}\n", printable(key.engine), printable(key.model),
                          key.step, table.plain(style));
  }
  const std::string counted = fmt::format(
      "{} of {} metrics of an engine, model and step move from one report to the next{}. Worse and "
      "better are runs since the report before.",
      moving, trend.rows.size(), all || moving == trend.rows.size() ? "" : "; --all prints all");
  return result + missing_text(trend.latest, style) + wrapped(counted, style.text) +
         wrapped(fmt::format("From report {} to {}: {}", trend.reports.size() - 1,
                             trend.reports.size(), changes_sentence(trend.latest)),
                 style.text);
}

std::string changes_json(const Changes& changes) { return text_of(json_of(changes)); }

std::string trend_json(const Trend& trend) { return text_of(json_of(trend)); }

std::string compare_schema_json() {
  return text_of(
      headed("What `tautline compare --json` writes",
             "Of two reports what changed beyond noise and tolerance, runs told apart by "
             "case, engine, model and step; of more a trend: "
             "how every engine, model and step does from report to report, each metric "
             "over the cases that all of them could measure.",
             {{"anyOf", {schema_of(Changes()), schema_of(Trend())}}}));
}

}  // namespace tautline::bench
