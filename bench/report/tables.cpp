#include "bench/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/report/columns.hpp"
#include "bench/report/scorecard.hpp"
#include "bench/report/words.hpp"
#include "bench/solution/cable_words.hpp"
#include "tautline_bench_report_words.inc"

namespace tautline::bench {
namespace {

using namespace fmt::literals;

/// A member of what may not be there.
template <class Struct>
std::optional<double> member(const std::optional<Struct>& of, double Struct::*number) {
  return of ? std::optional((*of).*number) : std::nullopt;
}

/// What a body does once its final set of cables is taut.
std::string afterwards(const Lock& lock) {
  if (lock.rests) {
    return "rests";
  }
  return lock.permanent ? "swings on" : "moves on";
}

std::vector<Column> cases_columns(const Report& report) {
  std::vector<Column> columns = {word_column("case", "case"),
                                 word_column("title", "title"),
                                 word_column("exact motion ends", "ending"),
                                 number_column("at", "s", "", "end-time"),
                                 number_column("horizon", "s", "", "horizon"),
                                 number_column("counted impacts", "", "", "impacts"),
                                 number_column("start", "J", "energy", "start-energy"),
                                 number_column("end", "J", "energy", "end-energy")};
  if (!report.cases.empty()) {
    for (const LastImpact& last : report.cases.front().settling.last_impacts) {
      columns.push_back(number_column(fmt::format("> {:g} m/s", last.speed), "s", "last impact",
                                      fmt::format("last-impact-{:g}", last.speed)));
    }
  }
  const std::vector<Column> lock = {
      number_column("at", "s", "lock", "lock-time"), word_column("cables", "lock-cables"),
      word_column("then", "lock-then"), number_column("energy", "J", "swing", "swing-energy"),
      number_column("amplitude", "rad", "swing", "swing-amplitude")};
  columns.insert(columns.end(), lock.begin(), lock.end());
  return columns;
}

std::vector<Cell> cells_of(const CaseRow& row) {
  std::vector<Cell> cells = {
      word_cell(row.name),
      word_cell(row.title),
      word_cell(in_words(row.ending)),
      number_cell(row.end_time, fixed(6)),
      number_cell(row.horizon, fixed(3)),
      count_cell(row.counted_impacts),
      number_cell(row.start_energy, fixed(6)),
      number_cell(row.end_energy, fixed(6)),
  };
  for (const LastImpact& last : row.settling.last_impacts) {
    cells.push_back(number_cell(last.time, as_instant));
  }
  const std::optional<Lock>& lock = row.settling.lock;
  const Swing* const swing = lock && lock->swing ? &*lock->swing : nullptr;
  const auto of_swing = [swing](double Swing::*number) {
    return swing != nullptr ? std::optional(swing->*number) : std::nullopt;
  };
  cells.push_back(number_cell(member(lock, &Lock::time), as_instant));
  cells.emplace_back(lock ? cable_list(lock->cables) : dash);
  cells.emplace_back(lock ? afterwards(*lock) : dash);
  cells.push_back(number_cell(of_swing(&Swing::energy), fixed(8)));
  cells.push_back(number_cell(of_swing(&Swing::amplitude), fixed(5)));
  return cells;
}

constexpr Digits as_distance = fixed(2);

/// The statistic that says when a motion has settled: the first of all.
constexpr std::size_t settling = 0;

std::vector<Column> columns_of(const Distributions& distributions) {
  std::vector<Column> columns = setup_columns();
  columns.push_back(word_column("verdict", "verdict"));
  columns.push_back(number_column("differ", "", "", "differ"));
  int rank = 0;  // the last ones go first
  for (const Distributions::Statistic& statistic : distributions.statistics) {
    columns.push_back(number_column(statistic.heading, "", "D", "distance-" + statistic.name,
                                    "D " + in_words(statistic.name), rank++));
  }
  const std::string& unit = distributions.statistics.at(settling).unit;
  columns.push_back(number_column("settled, median", unit, "", "settled", "settled", 1));
  columns.push_back(number_column("failed draws", "", "", "failed-draws", "failed", of_a_page));
  return columns;
}

const DistributionRow* find(const DistributionsRow& row, const std::string& name) {
  return find_by(row.statistics, &DistributionRow::statistic, name);
}

Cell distance_cell(const DistributionRow* row) {
  if (row == nullptr) {
    return dash;
  }
  Cell cell = number_cell(row->distance, as_distance);
  if (!row->differs) {
    cell.text = "(" + cell.text + ")";
  }
  return cell;
}

/// "differs", or what difference could have been seen and was not, or that there is too little.
Cell verdict_cell(const DistributionsRow& row, std::size_t differing, std::size_t draws) {
  if (row.statistics.empty()) {
    return "too few draws";
  }
  double visible = 0.0;
  for (const DistributionRow& one : row.statistics) {
    visible = std::max(visible, one.visible);
  }
  Cell cell = differing > 0 ? std::string("differs")
                            : fmt::format("no difference above D = {:.2f} seen, n = {}", visible,
                                          draws - std::min(draws, row.failed));
  cell.kind = differing > 0 ? "verdict differs" : "verdict too-few-to-tell";
  cell.colour = differing > 0 ? Colour::red : Colour::grey;
  return cell;
}

Row row_of(const Distributions& distributions, const DistributionsRow& of) {
  Row row = {setup_cells(of.key), "", ""};
  const auto differing = static_cast<std::size_t>(
      std::count_if(of.statistics.begin(), of.statistics.end(),
                    [](const DistributionRow& one) { return one.differs; }));
  row.cells.push_back(verdict_cell(of, differing, distributions.draws));
  Cell share = count_cell(differing);
  share.text += fmt::format(" of {}", of.statistics.size());
  row.cells.push_back(std::move(share));
  for (const Distributions::Statistic& statistic : distributions.statistics) {
    row.cells.push_back(distance_cell(find(of, statistic.name)));
  }
  const DistributionRow* settled = find(of, distributions.statistics.at(settling).name);
  row.cells.push_back(number_cell(settled != nullptr ? settled->median : std::nullopt, fixed(3)));
  row.cells.push_back(count_cell(of.failed));
  return row;
}

/// The largest of the smallest distances that would have been called a difference.
double visible_in(const Distributions& distributions) {
  double visible = 0.0;
  for (const DistributionsRow& row : distributions.setups) {
    for (const DistributionRow& one : row.statistics) {
      visible = std::max(visible, one.visible);
    }
  }
  return visible;
}

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
  if (report.listed) {
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
  const int failures = report.listed ? beside_the_median : 0;
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

Table cases_table(const Report& report) {
  Table table(cases_columns(report));
  for (const CaseRow& row : report.cases) {
    table.add(cells_of(row));
  }
  return table;
}

/// A step of StepNeeded, and none below `shortest` [s] was tried: a dash where it is not known.
Cell step_cell(const std::optional<double>& step, double shortest) {
  Cell cell = number_cell(step, as_count);
  if (step && *step < shortest) {
    cell.text = "below " + number_text(shortest, as_count);
  }
  return cell;
}

Table steps_table(const Report& report) {
  std::vector<Column> columns = {word_column("case", "case"),
                                 number_column("safe", "s", "step for 1 %", "safe"),
                                 number_column("typical", "s", "step for 1 %", "typical"),
                                 number_column("until", "s", "step for 1 %", "until")};
  const std::string followed = "can be followed until, with a step of";
  for (const double step : report.options.steps) {
    columns.push_back(number_column(number_text(step, as_count), "s", followed,
                                    "followed-" + number_text(step, as_count)));
  }
  Table table(std::move(columns));
  for (const CaseRow& row : report.cases) {
    std::vector<Cell> cells(4, number_cell(std::nullopt, as_count));
    cells[0] = word_cell(row.name);
    if (const auto& needed = row.step_needed) {
      const double shortest = shortest_needed(row.system.has_value());
      cells[1] = step_cell(needed->known(needed->safe), shortest);
      cells[2] = step_cell(needed->known(needed->typical), shortest);
      cells[3] = number_cell(needed->until, fixed(2));
    }
    for (const double step : report.options.steps) {
      const Predictable* const found = find_by(row.predictable, &Predictable::step, step);
      cells.push_back(
          number_cell(found != nullptr ? std::optional(found->until) : std::nullopt, fixed(2)));
    }
    table.add(std::move(cells));
  }
  return table;
}

/// The model of the control that gives only what a model with fixed steps gives.
constexpr const char* sampled = "sampled";

Table sampled_table(const Report& report) {
  std::map<double, const SummaryRow*, std::greater<>> rows;
  for (const SummaryRow& row : report.summary) {
    if (row.key.engine == control && row.key.model == sampled) {
      rows.emplace(row.key.step, &row);
    }
  }
  std::vector<Column> columns = {word_column("metric", ""), word_column("unit", "")};
  for (const auto& [step, row] : rows) {
    columns.push_back(
        number_column(fmt::format("step {}", number_text(step, as_count)), "", "", ""));
  }
  Table table(std::move(columns));
  for (std::size_t place = 0; place < metric_list().size(); ++place) {
    const Metric& metric = metric_list()[place];
    std::vector<Cell> cells = {in_words(metric.name), shown_unit(metric, report)};
    bool any = false;
    for (const auto& [step, row] : rows) {
      const auto& value = row->metrics.at(place);
      any = any || (value && value->worst != 0.0);
      cells.push_back(
          number_cell(value ? std::optional(value->worst) : std::nullopt, metric.digits));
    }
    if (any) {
      table.add(std::move(cells));
    }
  }
  return table;
}

Table certified_table(const Report& report) {
  std::vector<Column> columns = {word_column("case", "case"),
                                 number_column("ends at", "s", "", "end-time")};
  std::vector<std::vector<Cell>> rows;
  for (const CaseRow& row : report.cases) {
    if (!row.certified) {
      continue;
    }
    std::vector<Cell>& cells = rows.emplace_back();
    cells = {word_cell(row.name), number_cell(row.end_time, fixed(3))};
    for (const CorrectDigits& correct : row.certified->correct) {
      if (rows.size() == 1) {
        columns.push_back(number_column(fmt::format("{} digits", correct.digits), "s",
                                        "right until", fmt::format("digits-{}", correct.digits)));
      }
      cells.push_back(correct.until ? number_cell(correct.until, fixed(3)) : word_cell("the end"));
    }
    cells.push_back(number_cell(row.horizon, fixed(3)));
  }
  columns.push_back(number_column("horizon", "s", "", "horizon"));
  Table table(std::move(columns));
  for (std::vector<Cell>& cells : rows) {
    table.add(std::move(cells));
  }
  return table;
}

Table convergence_table(const Report& report) {
  std::vector<Row> rows;
  for (const ConvergenceRow& row : report.convergence) {
    rows.push_back({{word_cell(row.engine), word_cell(row.model),
                     number_cell(member(row.slope, &Slope::median), fixed(2)),
                     number_cell(member(row.slope, &Slope::smallest), fixed(2)),
                     number_cell(member(row.slope, &Slope::largest), fixed(2)),
                     count_cell(row.cases), count_cell(row.cases_at_rounding)},
                    "",
                    body_of(row.engine)});
  }
  Table table({word_column("engine", "engine"), word_column("model", "model"),
               number_column("median", "", "slope", "median"),
               number_column("smallest", "", "slope", "smallest"),
               number_column("largest", "", "slope", "largest"),
               number_column("with a slope", "", "cases", "cases"),
               number_column("at rounding", "", "cases", "rounding")});
  add_rows(table, std::move(rows), ControlPlace::before);
  return table;
}

Table causes_table(const Report& report) {
  std::vector<Column> columns = setup_columns();
  columns.push_back(number_column("median", "m", "deviation", "median"));
  columns.push_back(number_column("worst", "m", "deviation", "worst"));
  const auto told = causes_of(report.causes);
  for (const Cause cause : told) {
    columns.push_back(number_column(in_words(to_string(cause)), "", "share of the parts",
                                    std::string(to_string(cause))));
  }
  const bool some_soft = std::ranges::any_of(
      report.causes, [](const CausesRow& one) { return one.model_share.has_value(); });
  if (some_soft) {
    columns.push_back(number_column("model", "", "share of soft cables", "model_share"));
  }
  columns.push_back(number_column("covered", "of the horizon", "", "covered"));
  columns.push_back(number_column("remainder", "", "", "remainder"));
  columns.push_back(number_column("cases", "", "", "cases"));
  std::vector<Row> rows;
  for (const CausesRow& causes_row : report.causes) {
    if (!causes_row.shares) {
      continue;
    }
    Row row = {setup_cells(causes_row.key), "", body_of(causes_row.key.engine)};
    const auto& deviation = causes_row.deviation;
    row.cells.push_back(number_cell(deviation ? deviation->median : std::nullopt, as_error));
    row.cells.push_back(number_cell(member(deviation, &MedianAndWorst::worst), as_error));
    for (const Cause cause : told) {
      const double share = (*causes_row.shares)[static_cast<std::size_t>(cause)];
      row.cells.push_back(number_cell(share, fixed(3)));
    }
    if (some_soft) {
      row.cells.push_back(number_cell(causes_row.model_share, fixed(3)));
    }
    row.cells.push_back(number_cell(causes_row.covered, fixed(2)));
    row.cells.push_back(number_cell(causes_row.remainder, as_error));
    row.cells.push_back(count_cell(causes_row.cases));
    rows.push_back(std::move(row));
  }
  Table table(std::move(columns));
  add_rows(table, std::move(rows), ControlPlace::before);
  return table;
}

Table failures_table(const Report& report) {
  Table table({word_column("engine", "engine"), word_column("model", "model"),
               word_column("case", "case"), number_column("step", "s", "", "step"),
               word_column("what happened", "reason")});
  for (const EngineRow& engine : report.engines) {
    if (engine.problem && !engine.missing) {
      table.add({word_cell(engine.name), dash, dash, dash, sentence_cell(*engine.problem)});
    }
  }
  for (const RunRow& run : report.runs) {
    if (!did_its_work(run.status) || run.status == Status::unsupported) {
      table.add({word_cell(run.key.engine), word_cell(run.key.model), word_cell(run.key.the_case),
                 number_cell(run.key.step, as_count), sentence_cell(run.reason)});
    }
  }
  return table;
}

Table settings_table(const Model& model) {
  Table table({word_column("setting", ""), word_column("value", ""), word_column("whose", ""),
               word_column("reason", "")});
  for (const Setting& setting : model.settings) {
    table.add({word_cell(setting.name), word_cell(setting.value), words_of(setting.origin),
               sentence_cell(setting.reason)});
  }
  return table;
}

Table distributions_table(const Report& report) {
  if (!report.distributions || report.distributions->statistics.empty()) {
    return Table({});
  }
  Table table(columns_of(*report.distributions));
  for (const DistributionsRow& row : report.distributions->setups) {
    table.add(row_of(*report.distributions, row));
  }
  return table;
}

std::string distributions_paragraph(const Report& report) {
  if (!report.distributions) {
    return "";
  }
  const Distributions& of = *report.distributions;
  std::string settled;
  if (!of.statistics.empty() && of.statistics.at(settling).median) {
    const Distributions::Statistic& statistic = of.statistics.at(settling);
    settled = fmt::format(" The exact motion settles ({}) at {:.3f} {} in the median.",
                          statistic.heading, *statistic.median, statistic.unit);
  }
  return fmt::format(words::distributions, "draws"_a = of.draws,
                     "the_case"_a = printable(of.the_case), "deviation"_a = of.deviation,
                     "settled"_a = settled, "visible"_a = visible_in(of));
}

Table answers_table(const Report& report) {
  std::map<SetupKey, double> costs;
  for (const CostRow& cost : report.context.costs) {
    costs.emplace(cost.key, cost.cost_ratio);
  }
  Tallies verdicts = tallies(report);
  std::vector<Row> rows;
  for (const SummaryRow& summary : report.summary) {
    const auto cost = costs.find(summary.key);
    rows.push_back(answers_row(summary, report.listed ? &verdicts[summary.key] : nullptr,
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
