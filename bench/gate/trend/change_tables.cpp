#include "bench/gate/trend/change_tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "bench/base/text.hpp"
#include "bench/report/scorecard/scorecards_table.hpp"
#include "bench/report/tables/columns.hpp"

namespace tautline::bench {
namespace {

// Ranks of the columns that go first on a narrow terminal; the page has them all.
constexpr int unit_rank = 1;
constexpr int case_rank = 2;

std::vector<Column> move_columns() {
  std::vector<Column> columns = {word_column("since", ""),
                                 word_column("model", ""),
                                 number_column("step", "s", "", ""),
                                 word_column("metric", ""),
                                 word_column("unit", ""),
                                 word_column("case", ""),
                                 number_column("before", "", "", ""),
                                 number_column("after", "", "", ""),
                                 number_column("factor", "", "", ""),
                                 number_column("runs", "", "", "")};
  columns[4].rank = unit_rank;
  columns[5].rank = case_rank;
  return columns;
}

/// A dash where a factor says nothing.
Cell factor_cell(const MetricChange& change) {
  return brief_cell(std::isfinite(size_of_change(change))
                        ? std::optional(*change.after / *change.before)
                        : std::nullopt);
}

Table moves_table(const std::vector<VersionMove>& moves) {
  Table table(move_columns());
  for (const auto& [version, most, runs] : moves) {
    const Metric& metric = metric_list()[most.metric];
    table.add({word_cell(version), word_cell(most.key.model), number_cell(most.key.step, as_count),
               std::string(metric.name), shown_unit(metric), word_cell(most.key.the_case),
               number_cell(most.before, as_error), number_cell(most.after, as_error),
               factor_cell(most), count_cell(runs)});
  }
  return table;
}

Table costs_table(const Trend& trend) {
  Table table({"since", "model", "step", "cases", "factor"}, 2);
  for (std::size_t index = trend.changes.size(); index > 0; --index) {
    for (const CostChange& change : trend.changes[index - 1].costs) {
      table.add({printable(trend.reports[index].name), printable(change.key.model),
                 fmt::format("{:g}", change.key.step), std::to_string(change.cases),
                 fmt::format("{:.2g}", change.factor)});
    }
  }
  return table;
}

}  // namespace

std::vector<TitledTable> change_tables(const Trend& trend) {
  std::vector<TitledTable> tables = {
      {"Worse", moves_table(worse_moves(trend))},
      {"Better", moves_table(better_moves(trend))},
      {"Costs of a step, which are noisy and judge nothing", costs_table(trend)}};
  std::erase_if(tables, [](const TitledTable& one) { return one.table.empty(); });
  return tables;
}

}  // namespace tautline::bench
