#include "bench/chapter/json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/base/html.hpp"
#include "bench/chapter/corrections/draws.hpp"
#include "bench/chapter/figures/curves.hpp"
#include "bench/chapter/typeset.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

ordered_json cell_json(const ChapterCell& cell) {
  return std::visit(
      [](const auto& value) -> ordered_json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          return nullptr;
        } else {
          return value;
        }
      },
      cell);
}

ordered_json cells_json(const std::vector<ChapterCell>& cells) {
  ordered_json list = ordered_json::array();
  for (const ChapterCell& cell : cells) {
    list.push_back(cell_json(cell));
  }
  return list;
}

ordered_json table_json(const ChapterTable& table) {
  ordered_json columns = ordered_json::array();
  for (const ChapterColumn& column : table.columns) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}});
  }
  ordered_json rows = ordered_json::array();
  for (const auto& row : table.rows) {
    rows.push_back(cells_json(row));
  }
  return {{"name", table.name}, {"title", table.title},    {"file", table.file},
          {"columns", columns}, {"rows", std::move(rows)}, {"notes", table.notes}};
}

ordered_json marks_json(const std::vector<FigureMark>& marks) {
  ordered_json list = ordered_json::array();
  for (const auto& [time, meaning] : marks) {
    list.push_back({{"time", time}, {"meaning", meaning}});
  }
  return list;
}

ordered_json figure_json(const ChapterFigure& figure) {
  const FigureData& data = figure.data;
  ordered_json result = {{"name", figure.number},
                         {"title", figure.title},
                         {"file", figure.file},
                         {"columns", data.columns},
                         {"x", data.columns[figure.x]},
                         {"y", data.columns[figure.y]},
                         {"cases", ordered_json::array({figure.case_number})},
                         {"marks", marks_json(figure.marks)},
                         {"chapter", figure.chapter},
                         {"truth", figure.truth}};
  if (figure.boundary) {
    result["boundary"] = {{"file", figure.boundary->file},
                          {"columns", figure.boundary->data.columns}};
  }
  return result;
}

ordered_json numbers_json(const NamedNumbers& numbers) {
  ordered_json result = ordered_json::object();
  for (const auto& [name, values] : numbers) {
    result[name] = values.size() == 1 ? cell_json(values.front()) : cells_json(values);
  }
  return result;
}

ordered_json correction_json(const Correction& correction) {
  ordered_json numbers = numbers_json(correction.numbers);
  if (!correction.list.name.empty()) {
    ordered_json& rows = numbers[correction.list.name] = ordered_json::array();
    for (const NamedNumbers& row : correction.list.rows) {
      rows.push_back(numbers_json(row));
    }
  }
  return {{"where", correction.where},     {"holds", correction.holds},
          {"chapter", correction.chapter}, {"right", correction.right},
          {"shown", correction.shown},     {"numbers", std::move(numbers)}};
}

/// Six digits, more than a plot shows.
ordered_json drawn(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) {
    list.push_back(std::stod(fmt::format("{:.6g}", value)));
  }
  return list;
}

ordered_json curve_json(const Curve& curve) {
  return {{"name", curve.name}, {"x", drawn(curve.x)}, {"y", drawn(curve.y)}};
}

ordered_json plot_json(const ChapterFigure& figure) {
  ordered_json curves = ordered_json::array();
  for (const Curve& curve : figure_curves(figure)) {
    curves.push_back(curve_json(curve));
  }
  ordered_json boundary;
  if (figure.boundary) {
    boundary = curve_json(boundary_curve(*figure.boundary));
  }
  return {{"name", figure.number},
          {"x", typeset(figure.data.columns[figure.x])},
          {"y", typeset(figure.data.columns[figure.y])},
          {"curves", std::move(curves)},
          {"boundary", std::move(boundary)},
          {"marks", marks_json(figure.marks)}};
}

}  // namespace

std::string chapter_json(const ChapterReport& report) {
  ordered_json tables = ordered_json::array();
  for (const ChapterTable& table : report.tables) {
    tables.push_back(table_json(table));
  }
  ordered_json figures = ordered_json::array();
  for (const ChapterFigure& figure : report.figures) {
    figures.push_back(figure_json(figure));
  }
  ordered_json corrections = ordered_json::array();
  for (const Correction& correction : report.corrections) {
    corrections.push_back(correction_json(correction));
  }
  const ordered_json whole = {{"schema", chapter_schema},
                              {"options",
                               {{"digits", chapter_digits},
                                {"law", "simultaneous"},
                                {"counted_speed", counted_speed},
                                {"figure_step", figure_step},
                                {"seed", chapter_seed}}},
                              {"tables", std::move(tables)},
                              {"figures", std::move(figures)},
                              {"corrections", std::move(corrections)}};
  return whole.dump(2) + "\n";
}

std::string chapter_page_data(const ChapterReport& report) {
  ordered_json figures = ordered_json::array();
  for (const ChapterFigure& figure : report.figures) {
    figures.push_back(plot_json(figure));
  }
  const ordered_json data = {{"figures", std::move(figures)}};
  return html_json(data.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace tautline::bench
