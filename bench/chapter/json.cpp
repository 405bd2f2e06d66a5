#include "bench/chapter/output.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/base/html.hpp"
#include "bench/base/json_list.hpp"
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
  return json_list(cells, cell_json);
}

ordered_json column_json(const ChapterColumn& column) {
  return {{"name", column.name}, {"unit", column.unit}};
}

ordered_json table_json(const ChapterTable& table) {
  return {{"name", table.name},
          {"title", table.title},
          {"file", table.file},
          {"columns", json_list(table.columns, column_json)},
          {"rows", json_list(table.rows, cells_json)},
          {"notes", table.notes}};
}

ordered_json mark_json(const FigureMark& mark) {
  return {{"time", mark.time}, {"meaning", mark.meaning}};
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
                         {"marks", json_list(figure.marks, mark_json)},
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
    numbers[correction.list.name] = json_list(correction.list.rows, numbers_json);
  }
  return {{"where", correction.where},     {"holds", correction.holds},
          {"chapter", correction.chapter}, {"right", correction.right},
          {"shown", correction.shown},     {"numbers", std::move(numbers)}};
}

/// Six digits, more than a plot shows.
ordered_json drawn(const std::vector<double>& values) {
  return json_list(
      values, [](double value) -> ordered_json { return std::stod(fmt::format("{:.6g}", value)); });
}

ordered_json curve_json(const Curve& curve) {
  return {{"name", curve.name}, {"x", drawn(curve.x)}, {"y", drawn(curve.y)}};
}

ordered_json plot_json(const ChapterFigure& figure) {
  ordered_json boundary;
  if (figure.boundary) {
    boundary = curve_json(boundary_curve(*figure.boundary));
  }
  return {{"name", figure.number},
          {"x", typeset(figure.data.columns[figure.x])},
          {"y", typeset(figure.data.columns[figure.y])},
          {"curves", json_list(figure_curves(figure), curve_json)},
          {"boundary", std::move(boundary)},
          {"marks", json_list(figure.marks, mark_json)}};
}

}  // namespace

std::string chapter_json(const ChapterReport& report) {
  const ordered_json whole = {{"schema", chapter_schema},
                              {"options",
                               {{"digits", chapter_digits},
                                {"law", "simultaneous"},
                                {"counted_speed", counted_speed},
                                {"figure_step", figure_step},
                                {"seed", chapter_seed}}},
                              {"tables", json_list(report.tables, table_json)},
                              {"figures", json_list(report.figures, figure_json)},
                              {"corrections", json_list(report.corrections, correction_json)}};
  return whole.dump(2) + "\n";
}

std::string chapter_page_data(const ChapterReport& report) {
  const ordered_json data = {{"figures", json_list(report.figures, plot_json)}};
  return html_json(data.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
}

}  // namespace tautline::bench
