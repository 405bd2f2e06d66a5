#include "bench/tools/reproduce/output.hpp"

#include <fmt/format.h>

#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/data/describer.hpp"
#include "bench/page/document.hpp"
#include "bench/tools/reproduce/checks.hpp"

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

std::string field(const ChapterCell& cell) {
  if (const auto* const words = std::get_if<std::string>(&cell)) {
    return *words;
  }
  if (const auto* const number = std::get_if<double>(&cell)) {
    return shortest(*number);
  }
  const auto* const whole = std::get_if<long>(&cell);
  return whole != nullptr ? std::to_string(*whole) : "";
}

}  // namespace

std::string table_csv(const ChapterTable& table) {
  std::string csv = csv_line(listed(table.columns, [](const ChapterColumn& column) {
    return column.unit.empty() ? column.name : column.name + " [" + column.unit + "]";
  }));
  for (const auto& row : table.rows) {
    csv += csv_line(listed(row, field));
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
  std::string csv = csv_line({"where", "holds", "chapter", "right", "shown"});
  for (const Correction& one : corrections) {
    csv += csv_line({one.where, one.holds ? "yes" : "no", one.chapter, one.right, one.shown});
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
