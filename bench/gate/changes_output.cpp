#include "bench/gate/changes_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "bench/base/document.hpp"
#include "bench/base/html.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/gate/changes_fields.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

using Cells = std::vector<std::string>;

/// Rows of one kind that anyone reads; the JSON has them all.
constexpr std::size_t most_rows = 100;

/// Adds `rows`, of which there are `count`, in a table whose first `left` columns and last `words`
/// hold words. `what` they are, if there are more.
template <class Row>
void add(Document& out, const std::string& title, std::size_t count, const std::vector<Row>& rows,
         const Cells& headings, std::size_t left, std::size_t words,
         Cells (*cells_of)(const Row& row), const std::string& what = "") {
  Table table(headings, left, words);
  for (const Row& row : rows) {
    table.add(cells_of(row));
  }
  table.cut(most_rows, what);
  out.titled(std::move(table), "", fmt::format("{} ({})", title, count));
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

void add_statuses(Document& out, const std::string& title, const std::vector<StatusChange>& rows) {
  add(out, title, rows.size(), rows,
      {"engine", "model", "case", "step", "before", "after", "reason"}, 3, 3, status_cells);
}

void add_metrics(Document& out, const std::string& title, const std::vector<MetricChange>& rows) {
  add(out, title, rows.size(), rows,
      {"engine", "model", "case", "step", "metric", "before", "after", "factor", "unit"}, 3, 1,
      metric_cells);
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
void add_runs(Document& out, const std::string& title, const std::vector<RunKey>& runs) {
  add(out, title, runs.size(), groups_of(runs), {"engine", "model", "steps", "cases", "runs"}, 4, 0,
      group_cells, " engines and models");
}

/// Tables that anyone reads; the JSON has them all.
constexpr std::size_t most_tables = 20;

Table reports_table(const Trend& trend) {
  Table table({"report", "runs", "tautline", "started", "file"}, 0, 3);
  for (std::size_t index = 0; index < trend.reports.size(); ++index) {
    const TrendReport& report = trend.reports[index];
    table.add({std::to_string(index + 1), std::to_string(report.runs), printable(report.version),
               printable(report.started), printable(report.name)});
  }
  return table;
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

void add_missing(Document& out, const Changes& changes) {
  add_statuses(out, "New failures", changes.new_failures);
  add_runs(out, "Runs that are gone", changes.only_before);
}

std::string changes_text(const Changes& changes, const TerminalStyle& style) {
  Document out;
  add(out, "Versions that differ", changes.versions.size(), changes.versions,
      {"what", "before", "after"}, 3, 0, version_cells);
  add_statuses(out, "New failures", changes.new_failures);
  add_metrics(out, "Worse", changes.got_worse);
  add_runs(out, "Runs that are gone", changes.only_before);
  add_statuses(out, "Failures that are gone", changes.recovered);
  add_metrics(out, "Better", changes.got_better);
  add_runs(out, "New runs", changes.only_after);
  add_runs(out, "Not compared, the case is not the same", changes.other_case);
  add(out, "Costs of a step, which are noisy and judge nothing", changes.costs.size(),
      changes.costs, {"engine", "model", "step", "cases", "factor"}, 2, 0, cost_cells);
  return out.paragraph(changes_sentence(changes)).plain(style);
}

std::string trend_text(const Trend& trend, bool all, const TerminalStyle& style) {
  const Cells headings = {"metric",    "report", "version", "median",
                          "quartiles", "cases",  "worse",   "better"};
  std::map<SetupKey, Table> tables;
  std::size_t moving = 0;
  for (const TrendRow& row : trend.rows) {
    moving += row.moves() ? 1U : 0U;
    if (all || row.moves()) {
      add_points(tables.try_emplace(row.key, headings, 3).first->second, row);
    }
  }
  Document out;
  out.table(reports_table(trend), "", "");
  std::size_t shown = 0;
  for (auto& [key, table] : tables) {
    if (!all && ++shown > most_tables) {
      out.paragraph(
          fmt::format("and {} more tables: --all prints them", tables.size() - most_tables));
      break;
    }
    out.heading(2, verbatim(fmt::format("{} {}, step {:g} s", key.engine, key.model, key.step)));
    out.table(std::move(table), "", "");
  }
  add_missing(out, trend.latest);
  out.list({fmt::format("{} of {} metrics of an engine, model and step move from one report to the "
                        "next{}. Worse and better are runs since the report before.",
                        moving, trend.rows.size(),
                        all || moving == trend.rows.size() ? "" : "; --all prints all"),
            fmt::format("From report {} to {}: {}", trend.reports.size() - 1, trend.reports.size(),
                        changes_sentence(trend.latest))});
  return out.plain(style);
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
