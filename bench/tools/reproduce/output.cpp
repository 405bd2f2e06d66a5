#include "bench/tools/reproduce/output.hpp"

#include <fmt/format.h>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/table.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/tools/reproduce/checks.hpp"
#include "bench/tools/reproduce/source.hpp"

namespace tautline::bench {

// The members of chapter.json and of the data of the page by their names; they have no schema.

inline Json json_of(const ChapterCell& cell) {
  return std::visit(
      [](const auto& value) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>) {
          return nullptr;
        } else {
          return value;
        }
      },
      static_cast<const ChapterCell::variant&>(cell));
}

/// Numbers by their names: one alone as it is, several as a list.
template <class Visitor>
void number_fields(Visitor& visit, const NamedNumbers& numbers) {
  for (const auto& [name, values] : numbers) {
    values.size() == 1 ? visit(name, values.front()) : visit(name, values);
  }
}
inline Json json_of(const NamedNumbers& numbers) {
  Writer object;
  number_fields(object, numbers);
  return std::move(object).object();
}

template <class Visitor>
void fields(Visitor& visit, ChapterColumn& column) {
  visit("name", column.name);
  visit("unit", column.unit);
}

template <class Visitor>
void fields(Visitor& visit, ChapterTable& table) {
  visit("name", table.name);
  visit("title", table.title);
  visit("file", table.file);
  visit("columns", table.columns);
  visit("rows", table.rows);
  visit("notes", table.notes);
}

template <class Visitor>
void fields(Visitor& visit, FigureMark& mark) {
  visit("time", mark.time);
  visit("meaning", mark.meaning);
}

template <class Visitor>
void fields(Visitor& visit, Boundary& boundary) {
  visit("file", boundary.file);
  visit("columns", boundary.data.columns);
}

template <class Visitor>
void fields(Visitor& visit, ChapterFigure& figure) {
  const std::vector<std::string>& columns = figure.data.columns;
  visit("name", figure.number);
  visit("title", figure.title);
  visit("file", figure.file);
  visit("columns", columns);
  visit("x", columns[figure.x]);
  visit("y", columns[figure.y]);
  visit("cases", std::vector<std::string>{figure.case_number});
  visit("marks", figure.marks);
  visit("chapter", figure.chapter);
  visit("truth", figure.truth);
  visit.if_any("boundary", figure.boundary);
}

/// What the page's script draws of a figure.
struct FigurePlot {
  const ChapterFigure* figure;
};

/// Six digits, more than a plot shows.
inline std::vector<double> drawn(const std::vector<double>& values) {
  return listed(values, [](double value) { return std::stod(fmt::format("{:.6g}", value)); });
}

template <class Visitor>
void fields(Visitor& visit, Curve& curve) {
  visit("name", curve.name);
  visit("x", drawn(curve.x));
  visit("y", drawn(curve.y));
}

template <class Visitor>
void fields(Visitor& visit, FigurePlot& plot) {
  const ChapterFigure& figure = *plot.figure;
  const auto& boundary = figure.boundary;
  visit("name", figure.number);
  visit("x", typeset(figure.data.columns[figure.x]));
  visit("y", typeset(figure.data.columns[figure.y]));
  visit("curves", figure_curves(figure));
  visit("boundary", boundary ? std::optional(boundary_curve(*boundary)) : std::nullopt);
  visit("marks", figure.marks);
}

template <class Visitor>
void fields(Visitor& visit, Correction& correction) {
  visit("where", correction.where);
  visit("holds", correction.holds);
  visit("chapter", correction.chapter);
  visit("right", correction.right);
  visit("shown", correction.shown);
  visit.group("numbers", {}, [&](auto& inside) {
    number_fields(inside, correction.numbers);
    if (!correction.list.name.empty()) {
      inside(correction.list.name, correction.list.rows);
    }
  });
}

template <class Visitor>
void fields(Visitor& visit, ChapterReport& report) {
  schema_field(visit, chapter_schema);
  visit.group("options", {}, [](auto& inside) {
    inside("digits", std::size_t{chapter_digits});
    inside("law", std::string("simultaneous"));
    inside("counted_speed", counted_speed);
    inside("figure_step", figure_step);
    inside("seed", std::size_t{chapter_seed});
  });
  visit("tables", report.tables);
  visit("figures", report.figures);
  visit("corrections", report.corrections);
}

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
      "\n## Case numbers\n\nA case number spells its case, digit by digit. For the standard "
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

std::string chapter_json(const ChapterReport& report) { return text_of(json_of(report)); }

std::string chapter_page_data(const ChapterReport& report) {
  const Json data = {{"figures", json_of(listed(report.figures, [](const ChapterFigure& figure) {
                        return FigurePlot{&figure};
                      }))}};
  return html_json(on_one_line(data));
}

}  // namespace tautline::bench
