#include "bench/gate/changes_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

using Cells = std::vector<std::string>;

/// Rows of one kind that anyone reads; the JSON has them all.
constexpr std::size_t most_rows = 100;

/// One section: a table whose first `left` columns and last `words` hold words; "" without rows.
template <class Row>
std::string section(const std::string& title, const std::vector<Row>& rows, const Cells& headings,
                    std::size_t left, std::size_t words, Cells (*cells_of)(const Row& row)) {
  if (rows.empty()) {
    return "";
  }
  Table table(headings, left, words);
  for (std::size_t index = 0; index < std::min(most_rows, rows.size()); ++index) {
    table.add(cells_of(rows[index]));
  }
  const std::string rest =
      rows.size() > most_rows ? fmt::format("and {} more\n", rows.size() - most_rows) : "";
  return fmt::format("{} ({}):\n{}{}\n", title, rows.size(), table.plain(), rest);
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

std::string runs(const std::string& title, const std::vector<RunKey>& rows) {
  return section(title, rows, {"engine", "model", "case", "step"}, 3, 0, run_cells);
}

std::string statuses(const std::string& title, const std::vector<StatusChange>& rows) {
  return section(title, rows, {"engine", "model", "case", "step", "before", "after", "reason"}, 3,
                 3, status_cells);
}

std::string metrics(const std::string& title, const std::vector<MetricChange>& rows) {
  return section(title, rows,
                 {"engine", "model", "case", "step", "metric", "before", "after", "factor", "unit"},
                 3, 1, metric_cells);
}

std::string last_line(const Changes& changes) {
  const std::size_t bad =
      changes.new_failures.size() + changes.got_worse.size() + changes.only_before.size();
  const std::size_t good = changes.recovered.size() + changes.got_better.size();
  if (bad + good == 0) {
    return fmt::format("{} runs compared: nothing changed beyond noise.\n", changes.compared);
  }
  return fmt::format("{} runs compared: {} changes for the worse, {} for the better.\n",
                     changes.compared, bad, good);
}

}  // namespace

std::string changes_text(const Changes& changes) {
  return section("Versions that differ", changes.versions, {"what", "before", "after"}, 3, 0,
                 version_cells) +
         statuses("New failures", changes.new_failures) + metrics("Worse", changes.got_worse) +
         runs("Runs that are gone", changes.only_before) +
         statuses("Failures that are gone", changes.recovered) +
         metrics("Better", changes.got_better) + runs("New runs", changes.only_after) +
         runs("Not compared, the case is not the same", changes.other_case) +
         section("Costs of a step, which are noisy and judge nothing", changes.costs,
                 {"engine", "model", "step", "cases", "factor"}, 2, 0, cost_cells) +
         last_line(changes);
}

}  // namespace tautline::bench
