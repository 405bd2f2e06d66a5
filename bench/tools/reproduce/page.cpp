// The source chapter as a page: its errors first, its tables, its figures.
#include "bench/tools/reproduce/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "bench/base/html.hpp"
#include "bench/base/table.hpp"
#include "bench/page/document.hpp"
#include "bench/tools/reproduce/source.hpp"

namespace tautline::bench {
namespace {

constexpr std::string_view title = "The source chapter, computed again";

std::string prose(const std::string& text) { return html_prose(typeset(text)); }

std::string header(const ChapterReport& report, bool charts) {
  std::string out =
      fmt::format("<header>\n<h1>{}</h1>\n<p>{}</p>\n", title, prose(report.introduction));
  for (const Correction& one : report.corrections) {
    if (one.main) {
      out += fmt::format("<p class=\"answer\">What it missed: {} {}</p>\n", prose(one.right),
                         prose(one.shown));
    }
  }
  if (!charts) {
    out +=
        "<p class=\"note\">Charts are not in this build of tautline: it was made without Plotly. "
        "Their data are in the folder <code>chapter</code>.</p>\n";
  }
  return out + "</header>\n";
}

std::string list(const std::vector<std::string>& sentences) {
  std::string items;
  for (const std::string& sentence : sentences) {
    items += fmt::format("<li>{}</li>\n", prose(sentence));
  }
  return "<ul>\n" + items + "</ul>\n";
}

std::string contents() {
  return "<nav aria-label=\"Sections\">\n<a href=\"#wrong\">What it got wrong</a>\n"
         "<a href=\"#reading\">How to read it</a>\n<a href=\"#tables\">Tables</a>\n"
         "<a href=\"#figures\">Figures</a>\n<a href=\"#holds\">What holds</a>\n</nav>\n";
}

std::string correction_item(const Correction& one) {
  return fmt::format(
      "<li><strong>{}.</strong> {}<br>{}: {}<br><span class=\"evidence\">{}</span></li>\n",
      html_text(one.where), prose(one.chapter), one.holds ? "Checked" : "Right", prose(one.right),
      prose(one.shown));
}

/// What the chapter missed altogether first, the rest in its order.
std::string corrections(std::vector<Correction> list, bool holds) {
  std::stable_partition(list.begin(), list.end(), [](const Correction& one) { return one.main; });
  std::string out;
  for (const Correction& one : list) {
    out += one.holds == holds ? correction_item(one) : "";
  }
  return "<ol class=\"corrections\">\n" + out + "</ol>\n";
}

std::string reading_section(const ChapterReport& report) {
  std::string out =
      "<section id=\"reading\">\n<h2>How to read it</h2>\n" + list(report.conventions);
  out += "<h3>Case numbers</h3>\n<p>A case number spells its case, digit by digit.</p>\n";
  out += html_table(case_number_table(), "case-number",
                    "The number of the standard case, digit by digit.");
  return out + list(case_number_rules()) + "</section>\n";
}

Cell table_cell(const ChapterCell& cell, const ChapterColumn& column) {
  Cell shown(cell_text(cell, column));
  if (const auto* const number = std::get_if<double>(&cell)) {
    shown.number = *number;
    shown.text = *number == 0.0 ? "0" : shown.text;  // exactly: no digits to show
  } else if (const auto* const whole = std::get_if<long>(&cell)) {
    shown.number = static_cast<double>(*whole);
  }
  shown.is_number = shown.number.has_value();
  return shown;
}

/// True if nothing in the column is a word: the chapter's own numbers are text, as printed.
bool holds_numbers(const ChapterTable& table, std::size_t column) {
  return column >= table.left &&
         std::all_of(table.rows.begin(), table.rows.end(),
                     [&](const std::vector<ChapterCell>& row) {
                       const auto* const text = std::get_if<std::string>(&row[column]);
                       return text == nullptr ||
                              text->find_first_not_of("+-.0123456789e") == std::string::npos;
                     });
}

/// "Table 5.1" as "table-5-1".
std::string id_of(std::string name) {
  for (char& letter : name) {
    letter = letter == ' ' || letter == '.' ? '-' : letter;
    letter = letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  }
  return name;
}

std::string table_html(const ChapterTable& table) {
  std::vector<Column> columns;
  for (const auto& [name, unit, format] : table.columns) {
    Column column;
    column.heading = name;
    column.unit = typeset(unit);
    column.numbers = holds_numbers(table, columns.size());
    columns.push_back(std::move(column));
  }
  Table shown(std::move(columns));
  const std::vector<ChapterCell>* last = nullptr;
  bool even = false;
  for (const auto& row : table.rows) {
    if (last != nullptr && row.front() != last->front()) {  // a rule between groups of rows
      even = !even;
    }
    last = &row;
    Row cells;
    cells.body = even ? "even" : "odd";
    for (std::size_t index = 0; index < row.size(); ++index) {
      cells.cells.push_back(table_cell(row[index], table.columns[index]));
    }
    shown.add(std::move(cells));
  }
  // short: a caption is as wide as its table, and a narrow screen is not
  const std::string caption = table.name + ".";
  return "<h3>" + prose(table.title) + "</h3>\n" + html_table(shown, id_of(table.name), caption) +
         fmt::format("<p class=\"note\">Data: <a href=\"chapter/{0}\">{0}</a></p>\n",
                     html_text(table.file)) +
         "<div class=\"notes\">\n" + list(table.notes) + "</div>\n";
}

std::string tables_section(const ChapterReport& report) {
  std::string out = "<section id=\"tables\">\n<h2>Its tables</h2>\n";
  for (const ChapterTable& table : report.tables) {
    out += table_html(table);
  }
  return out + "</section>\n";
}

std::string figure_html(const ChapterFigure& figure, bool charts) {
  const std::string plot = fmt::format(
      "<div class=\"chart\" data-figure=\"{0}\" role=\"figure\" aria-label=\"Figure {0}: "
      "{1}\"><p class=\"no-script\">Drawn by script only.</p></div>\n",
      figure.number, html_text(figure.title));
  return fmt::format(
      "<figure>\n{}<figcaption><b>Fig. {}.</b> {}. Data: <a href=\"chapter/{}\">{}</a><br>"
      "{}<br><i>In truth:</i> {}</figcaption>\n</figure>\n",
      charts ? plot : "", figure.number, html_text(figure.title), figure.file, figure.file,
      prose(figure.chapter), prose(figure.truth));
}

std::string figures_section(const ChapterReport& report, bool charts) {
  std::string out =
      "<section id=\"figures\">\n<h2>Its figures</h2>\n<p>Figures 5.1 to 5.5 are drawings of the "
      "geometry. Boundaries are those of the centre of mass at angle 0; with the angle they "
      "move.</p>\n<div class=\"figures\">\n";
  for (const ChapterFigure& figure : report.figures) {
    out += figure_html(figure, charts);
  }
  return out + "</div>\n</section>\n";
}

}  // namespace

std::string typeset(std::string text) {
  struct Sign {
    std::string_view spelt;
    std::string_view set;
  };
  constexpr Sign signs[] = {{"<=", "≤"}, {">=", "≥"}, {"^2", "²"}, {"sqrt(", "√("}};
  for (const auto& [spelt, set] : signs) {
    for (std::size_t at = text.find(spelt); at != std::string::npos; at = text.find(spelt, at)) {
      text.replace(at, spelt.size(), set);
    }
  }
  return text;
}

std::string chapter_page(const ChapterReport& report, const PageAssets& assets) {
  const bool charts = !assets.plotly.empty();
  std::string content = header(report, charts) + contents() + "<main>\n";
  content += "<section id=\"wrong\">\n<h2>What the chapter got wrong</h2>\n" +
             corrections(report.corrections, false) + "</section>\n";
  content += reading_section(report) + tables_section(report) + figures_section(report, charts);
  content += "<section id=\"holds\">\n<h2>What was checked and holds</h2>\n" +
             corrections(report.corrections, true) + "</section>\n</main>\n";
  return html_document({title, std::move(content), "tautline reproduce", "chapter-data",
                        chapter_page_data(report), assets.chapter_scripts},
                       assets);
}

}  // namespace tautline::bench
