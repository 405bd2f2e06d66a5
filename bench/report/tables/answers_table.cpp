#include "bench/report/tables/answers_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

// Ranks of the columns that go first where there is no room; those of metrics are in their list.
constexpr int seldom_missed = 1;
constexpr int beside_the_median = 9;

/// What the verdict on a run comes to, the worst first.
enum class Standing { failed, flagged, known, unsupported, informative, pass, none };
constexpr std::array word_names = {"failed",      "flagged", "known", "unsupported",
                                   "informative", "pass",    ""};

bool all_known(const Verdict& verdict) {
  return std::all_of(verdict.checks.begin(), verdict.checks.end(),
                     [](const Check& check) { return check.holds || check.known; });
}

Standing standing_of(const RunRow& run) {
  if (!did_its_work(run.status)) {
    return Standing::failed;
  }
  if (!run.verdict) {
    return Standing::none;
  }
  switch (run.verdict->word) {
    case Word::pass:
      return Standing::pass;
    case Word::informative:
      return Standing::informative;
    case Word::unsupported:
      return Standing::unsupported;
    case Word::flagged:
      break;
  }
  return all_known(*run.verdict) ? Standing::known : Standing::flagged;
}

Colour colour_of(Standing standing) {
  switch (standing) {
    case Standing::failed:
    case Standing::flagged:
      return Colour::red;
    case Standing::known:
      return Colour::yellow;
    case Standing::pass:
      return Colour::green;
    case Standing::unsupported:
    case Standing::informative:
    case Standing::none:
      break;
  }
  return Colour::grey;
}

/// The worst that some runs come to, and how many of them.
struct Tally {
  Standing worst = Standing::none;
  std::size_t count = 0;
  std::size_t runs = 0;

  void add(Standing standing) {
    count = standing == worst ? count + 1 : standing < worst ? 1 : count;
    worst = std::min(worst, standing);
    ++runs;
  }
};
using Tallies = std::map<SetupKey, Tally>;

Tallies tallies(const Report& report) {
  Tallies result;
  for (const RunRow& run : report.runs) {
    result[setup_of(run.key)].add(standing_of(run));
  }
  return result;
}

/// "pass", or "flagged 3/21".
Cell tally_cell(const Tally& tally) {
  const std::string name = word_names.at(static_cast<std::size_t>(tally.worst));
  Cell cell =
      tally.count == tally.runs ? name : fmt::format("{} {}/{}", name, tally.count, tally.runs);
  cell.kind = "verdict " + name;
  cell.colour = colour_of(tally.worst);
  return cell;
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
  if (report.limits) {
    columns.push_back(word_column("verdict", "verdict"));
  }
  return columns;
}

Row answers_row(const SummaryRow& summary, std::optional<double> cost) {
  Row row = {setup_cells(summary.key), "", body_of(summary.key.engine)};
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
    rows.push_back(
        answers_row(summary, cost != costs.end() ? std::optional(cost->second) : std::nullopt));
    if (report.limits) {
      rows.back().cells.push_back(tally_cell(verdicts[summary.key]));
    }
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
