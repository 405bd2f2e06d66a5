#include "bench/report/tables/tables.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

// Ranks of the columns that go first where there is no room; those of metrics are in their list.
constexpr int seldom_missed = 1;
constexpr int beside_the_median = 9;

using Tallies = std::map<SetupKey, Tally>;

Tallies tallies(const Report& report) {
  Tallies result;
  for (const RunRow& run : report.runs) {
    result[setup_of(run.key)].add(run);
  }
  return result;
}

bool is_shown_over_cases(const Metric& metric) {
  return metric.shown == Shown::by_run_and_over_cases && metric.aggregate != Aggregate::none;
}

/// Median and worst of a metric, or the worst alone.
void add_columns(std::vector<Column>& columns, const Metric& metric) {
  const std::string key = column_key(metric);
  const std::string name = in_words(metric.name);
  const std::string brief(metric.brief.empty() ? name : metric.brief);
  const std::string heading(metric.heading);
  const int rank = metric.brief.empty() ? of_a_page : metric.rank;
  if (metric.aggregate == Aggregate::extreme) {
    columns.push_back(number_column("worst " + heading, shown_unit(metric), "", key, brief, rank));
    return;
  }
  columns.push_back(number_column("median", shown_unit(metric), name, key, brief, rank));
  columns.push_back(number_column("worst", shown_unit(metric), name, key + "-worst",
                                  "worst " + brief, std::max(rank, beside_the_median)));
}

void add_cells(std::vector<Cell>& cells, const Metric& metric,
               const std::optional<MedianAndWorst>& value) {
  if (metric.aggregate == Aggregate::typical) {
    cells.push_back(number_cell(value ? value->median : std::nullopt, metric.digits));
  }
  cells.push_back(number_cell(value ? std::optional(value->worst) : std::nullopt, metric.digits));
}

std::vector<Column> columns_of(const Report& report) {
  std::vector<Column> columns = setup_columns();
  if (report.limits) {
    columns.push_back(word_column("verdict", "verdict"));
  }
  for (const Metric& metric : metric_list()) {
    if (is_shown_over_cases(metric)) {
      add_columns(columns, metric);
    }
  }
  const std::string impacts = "impacts to the horizon";
  const std::string last = last_impact_heading(report);
  // without verdicts a terminal has no other word of failures
  const int failures = report.limits ? beside_the_median : 0;
  for (Column& column : std::vector<Column>{
           number_column("matched", "", impacts, "matched", "match", seldom_missed),
           number_column("exact", "", impacts, "exact", "of", seldom_missed),
           number_column("found", "", impacts, "found", "found", beside_the_median),
           number_column("exact", "cases", last, "last-impact-exact", "exact settled", of_a_page),
           number_column("found", "cases", last, "last-impact-found", "found settled", of_a_page),
           number_column("cost", "flights", "", "cost", "cost", of_a_page),
           number_column("failed", "", "runs", "failed", "failed", failures),
           number_column("all", "", "runs", "runs", "runs", of_a_page)}) {
    columns.push_back(std::move(column));
  }
  return columns;
}

/// `verdict` is null in a report without.
Row answers_row(const SummaryRow& summary, const Tally* verdict, std::optional<double> cost) {
  Row row = {setup_cells(summary.key), "", body_of(summary.key.engine)};
  if (verdict != nullptr) {
    row.cells.push_back(tally_cell(*verdict));
  }
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    if (is_shown_over_cases(metric_list()[place])) {
      add_cells(row.cells, metric_list()[place], summary.metrics.at(place));
    }
  }
  for (const std::size_t count : {summary.matched, summary.exact, summary.found,
                                  summary.exact_settled, summary.found_settled}) {
    row.cells.push_back(count_cell(count));
  }
  row.cells.push_back(number_cell(cost, fixed(1)));
  row.cells.push_back(count_cell(summary.failed));
  row.cells.push_back(count_cell(summary.cases));
  return row;
}

/// An engine of which there are no runs.
Row missing_row(const EngineRow& engine) {
  Cell reason = sentence_cell((engine.missing ? "not here: " : "") + *engine.problem);
  reason.colour = Colour::grey;
  return {{word_cell(engine.name), reason}, "", "missing"};
}

}  // namespace

Table answers_table(const Report& report) {
  std::map<SetupKey, double> costs;
  for (const CostRow& cost : report.context.costs) {
    costs.emplace(cost.key, cost.cost_ratio);
  }
  Tallies verdicts = tallies(report);
  std::vector<Row> rows;
  for (const SummaryRow& summary : report.summary) {
    const auto cost = costs.find(summary.key);
    rows.push_back(answers_row(summary, report.limits ? &verdicts[summary.key] : nullptr,
                               cost != costs.end() ? std::optional(cost->second) : std::nullopt));
  }
  Table table(columns_of(report));
  add_rows(table, std::move(rows), ControlPlace::after);
  for (const EngineRow& engine : report.engines) {
    if (engine.problem) {
      table.add(missing_row(engine));
    }
  }
  return table;
}

}  // namespace tautline::bench
