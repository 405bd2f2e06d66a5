#include "bench/tools/reproduce/output.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/base/html.hpp"
#include "bench/base/json_list.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/tools/reproduce/checks.hpp"
#include "bench/tools/reproduce/source.hpp"

namespace tautline::bench {

namespace {

std::string table_markdown(const ChapterTable& table) {
  const std::vector<std::string> headings = listed(table.columns, &ChapterColumn::name);
  Table text(headings, table.left);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t index = 0; index < row.size(); ++index) {
      cells.push_back(cell_text(row[index], table.columns[index]));
    }
    text.add(cells);
  }
  return text.markdown();
}

std::string tables_markdown(const ChapterReport& report) {
  std::string out;
  for (const ChapterTable& table : report.tables) {
    out += fmt::format("\n## {}\n\n{} Data: [{}](chapter/{}).\n\n{}\n", table.name, table.title,
                       table.file, table.file, table_markdown(table));
    for (const std::string& note : table.notes) {
      out += "- " + note + "\n";
    }
  }
  return out;
}

std::string figures_markdown(const ChapterReport& report) {
  std::string out =
      "\n## Figures 5.6 to 5.20\n\nFigures 5.1 to 5.5 are drawings of the geometry: there is "
      "nothing to compute in them.\n\n";
  Table files({"figure", "plots", "data", "boundaries"}, 4);
  for (const ChapterFigure& figure : report.figures) {
    files.add(
        {figure.number, figure.title, figure.file, figure.boundary ? figure.boundary->file : "–"});
  }
  out += files.markdown();
  out += fmt::format(
      "\nThe data are in the folder `chapter`: the whole state each {:g} time units, and two rows "
      "at each event, before and after it. Of the impacts there is one row each, with both "
      "velocities. Boundaries are those of the centre of mass at angle 0; with the angle they "
      "move, and the "
      "chapter draws none for a body with dimensions.\n",
      figure_step);
  std::string_view said;
  for (const ChapterFigure& figure : report.figures) {
    if (figure.chapter != said) {
      out += "\n" + figure.chapter + " In truth:\n\n";
      said = figure.chapter;
    }
    out += fmt::format("- Fig. {}, case {}. {}\n", figure.number, figure.case_number, figure.truth);
  }
  return out;
}

std::string corrections_section(const ChapterReport& report, bool holds) {
  std::string out;
  int count = 0;
  for (const Correction& one : report.corrections) {
    if (one.holds == holds) {
      out += fmt::format("{}. **{}.** {}\n   - {}: {}\n   - Shown: {}\n", ++count, one.where,
                         one.chapter, holds ? "Checked" : "Right", one.right, one.shown);
    }
  }
  return out;
}

std::string case_number_section() {
  std::string out = fmt::format(
      "\n## Case numbers\n\nA case number spells its case, digit by digit. That of the standard "
      "case:\n\n{}\n",
      case_number_table().markdown());
  for (const std::string& rule : case_number_rules()) {
    out += "- " + rule + "\n";
  }
  return out;
}

/// `text` as one field, in quotes where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return result + "\"";
}

std::string field(const ChapterCell& cell) {
  if (const auto* const words = std::get_if<std::string>(&cell)) {
    return field(*words);
  }
  if (const auto* const number = std::get_if<double>(&cell)) {
    return shortest(*number);
  }
  const auto* const whole = std::get_if<long>(&cell);
  return whole != nullptr ? std::to_string(*whole) : "";
}

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

std::string chapter_markdown(const ChapterReport& report) {
  std::string out = "# The source chapter, computed again\n\n" + report.introduction + "\n\n";
  for (const std::string& convention : report.conventions) {
    out += "- " + convention + "\n";
  }
  out += case_number_section();
  out += tables_markdown(report);
  out += figures_markdown(report);
  out += "\n## What the chapter got wrong\n\n" + corrections_section(report, false);
  out += "\n## What was checked and holds\n\n" + corrections_section(report, true);
  return out;
}

std::string table_csv(const ChapterTable& table) {
  std::string csv;
  for (const auto& [name, unit, format] : table.columns) {
    csv += (csv.empty() ? "" : ",") + field(unit.empty() ? name : name + " [" + unit + "]");
  }
  csv += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t index = 0; index < row.size(); ++index) {
      csv += (index == 0 ? "" : ",") + field(row[index]);
    }
    csv += '\n';
  }
  return csv;
}

std::string data_csv(const FigureData& data) {
  std::string csv = fmt::format("{}\n", fmt::join(data.columns, ","));
  for (const auto& [numbers, words] : data.rows) {
    csv += fmt::format("{:.12g}", fmt::join(numbers, ","));
    for (const std::string_view word : words) {
      csv += ',';
      csv += word;
    }
    csv += '\n';
  }
  return csv;
}

std::string corrections_csv(const std::vector<Correction>& corrections) {
  std::string csv = "where,holds,chapter,right,shown\n";
  for (const Correction& one : corrections) {
    csv += fmt::format("{},{},{},{},{}\n", field(one.where), one.holds ? "yes" : "no",
                       field(one.chapter), field(one.right), field(one.shown));
  }
  return csv;
}

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
