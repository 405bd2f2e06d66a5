#include "bench/report/tables/tables.hpp"

#include <fmt/format.h>

#include <map>
#include <utility>
#include <vector>

#include "bench/report/tables/columns.hpp"
#include "bench/report/words.hpp"
#include "bench/solution/cable_words.hpp"

namespace tautline::bench {
namespace {

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
  return lock.permanent ? "swings for good" : "moves on";
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

/// The scatter over the runs of each engine, model and step, in the order of their first runs.
std::vector<std::pair<SetupKey, Scatter>> scatters(const Report& report) {
  std::vector<std::pair<SetupKey, Scatter>> result;
  std::map<SetupKey, std::size_t> places;
  for (const RunRow& run : report.runs) {
    if (!run.scatter) {
      continue;
    }
    const auto [place, added] = places.emplace(setup_of(run.key), result.size());
    if (added) {
      result.emplace_back(setup_of(run.key), *run.scatter);
    } else {
      Scatter& all = result[place->second].second;
      all = pooled(all, *run.scatter);
    }
  }
  return result;
}

}  // namespace

Table cases_table(const Report& report) {
  Table table(cases_columns(report));
  for (const CaseRow& row : report.cases) {
    table.add(cells_of(row));
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
  for (const Cause cause : causes) {
    columns.push_back(number_column(in_words(to_string(cause)), "", "share of the parts",
                                    std::string(to_string(cause))));
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
    for (const double share : *causes_row.shares) {
      row.cells.push_back(number_cell(share, fixed(3)));
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

Table scatter_table(const Report& report) {
  std::vector<Column> columns = setup_columns();
  const std::string group = "e off by";
  for (const Column& column :
       {number_column("impacts", "", "", "impacts"), number_column("mean", "", group, "mean"),
        number_column("standard deviation", "", group, "deviation"),
        number_column("smallest", "", group, "smallest"),
        number_column("largest", "", group, "largest")}) {
    columns.push_back(column);
  }
  Table table(std::move(columns));
  for (const auto& [key, scatter] : scatters(report)) {
    std::vector<Cell> cells = setup_cells(key);
    cells.push_back(count_cell(scatter.count));
    for (const double number :
         {scatter.mean, scatter.standard_deviation, scatter.smallest, scatter.largest}) {
      cells.push_back(number_cell(number, fixed(4)));
    }
    table.add(std::move(cells));
  }
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
    if (!did_its_work(run.status)) {
      table.add({word_cell(run.key.engine), word_cell(run.key.model), word_cell(run.key.the_case),
                 number_cell(run.key.step, as_count), sentence_cell(run.reason)});
    }
  }
  return table;
}

Table settings_table(const Model& model) {
  Table table({word_column("setting", ""), word_column("value", ""), word_column("reason", "")});
  for (const Setting& setting : model.settings) {
    table.add({word_cell(setting.name), word_cell(setting.value), sentence_cell(setting.reason)});
  }
  return table;
}

}  // namespace tautline::bench
