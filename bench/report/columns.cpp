#include "bench/report/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

/// Units that a case of its own units does not have.
const std::set<std::string> physical_units = {"m", "s", "m/s", "rad/s", "J", "N s", "N m s", "kg"};

/// What is counted by the simulated second, where there are no seconds.
const std::map<std::string, std::string> per_unit_of_time = {{"ms/s", "ms per unit of time"},
                                                             {"s/s", "s per unit of time"}};

}  // namespace

Colour colour_of(Word word) {
  switch (word) {
    case Word::problem:
      return Colour::red;
    case Word::listed_problem:
      return Colour::yellow;
    case Word::sound:
      return Colour::green;
    case Word::too_few:
      break;
  }
  return Colour::grey;
}

Column word_column(std::string heading, std::string key) {
  Column column;
  column.heading = std::move(heading);
  column.key = std::move(key);
  column.numbers = false;
  return column;
}

Column number_column(std::string heading, std::string unit, std::string group, std::string key) {
  return number_column(std::move(heading), std::move(unit), std::move(group), std::move(key), "",
                       0);
}

Column number_column(std::string heading, std::string unit, std::string group, std::string key,
                     std::string brief, int rank) {
  return {std::move(heading),
          std::move(unit),
          std::move(group),
          std::move(key),
          std::move(brief),
          true,
          rank};
}

Cell word_cell(std::string_view text) { return printable(text); }

Cell sentence_cell(std::string_view text) { return printable(text, longest_sentence); }

Cell count_cell(std::size_t count) { return number_cell(static_cast<double>(count), as_count); }

std::string word_look(Word word) {
  std::string look = to_string(word);
  std::replace(look.begin(), look.end(), ' ', '-');
  return look;
}

std::string verdict_kind(Word word) { return "verdict " + word_look(word); }

Cell tally_cell(const Tally& tally) {
  Cell cell = tally.runs() == 0 ? dash : tally_text(tally);
  if (tally.runs() > 0) {
    cell.kind = verdict_kind(tally.worst());
    cell.colour = colour_of(tally.worst());
  }
  return cell;
}

std::vector<Column> setup_columns() {
  return {word_column("engine", "engine"), word_column("model", "model"),
          number_column("step", "s", "", "step")};
}

std::vector<Cell> setup_cells(const SetupKey& key) {
  return {word_cell(key.engine), word_cell(key.model), number_cell(key.step, as_count)};
}

std::string shown_unit(const Metric& metric) {
  return metric.unit == "1" ? "" : std::string(metric.unit);
}

std::string shown_unit(const Metric& metric, const Report& report) {
  const std::string unit = shown_unit(metric);
  return is_nondimensional(report) && physical_units.contains(unit) ? "" : unit;
}

Table in_units_of(const Report& report, const Table& table) {
  if (!is_nondimensional(report)) {
    return table;
  }
  std::vector<Column> columns = table.columns();
  for (Column& column : columns) {
    const auto other = per_unit_of_time.find(column.unit);
    column.unit = other != per_unit_of_time.end()        ? other->second
                  : physical_units.contains(column.unit) ? ""
                                                         : column.unit;
    if (const std::string end = " m/s"; column.group.ends_with(end)) {
      column.group.erase(column.group.size() - end.size());
    }
  }
  Table result(std::move(columns));
  for (const Row& row : table.rows()) {
    result.add(row);
  }
  return result;
}

std::string column_key(const Metric& metric) {
  std::string key(metric.name);
  std::replace(key.begin(), key.end(), '_', '-');
  return key;
}

std::string last_impact_heading(const Report& report) {
  if (report.cases.empty() || report.cases.front().settling.last_impacts.empty()) {
    return "last impact";
  }
  return fmt::format("last impact > {:g} m/s",
                     report.cases.front().settling.last_impacts.front().speed);
}

void add_rows(Table& table, std::vector<Row> rows, ControlPlace place) {
  const std::string first = place == ControlPlace::before ? body_of(control) : "";
  std::stable_partition(rows.begin(), rows.end(),
                        [&](const Row& row) { return row.body == first; });
  for (Row& row : rows) {
    table.add(std::move(row));
  }
}

std::string body_of(const std::string& engine) { return engine == control ? "control" : ""; }

}  // namespace tautline::bench
