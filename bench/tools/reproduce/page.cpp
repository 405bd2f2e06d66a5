// The source chapter as a page and in Markdown: its errors, its tables, its figures.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "bench/base/document.hpp"
#include "bench/base/html.hpp"
#include "bench/base/listed.hpp"
#include "bench/page/document.hpp"
#include "bench/tools/reproduce/output.hpp"
#include "bench/tools/reproduce/source.hpp"
#include "tautline_bench_reproduce_words.inc"

namespace tautline::bench {
namespace {

using namespace fmt::literals;

constexpr const char* title = "The source chapter, computed again";

constexpr const char* contents =
    "<nav aria-label=\"Sections\">\n<a href=\"#wrong\">What it got wrong</a>\n"
    "<a href=\"#reading\">How to read it</a>\n<a href=\"#tables\">Tables</a>\n"
    "<a href=\"#figures\">Figures</a>\n<a href=\"#holds\">What holds</a>\n</nav>\n";

Document header(const ChapterReport& report, bool charts) {
  Document out;
  out.html(fmt::format("<h1>{}</h1>\n", title)).paragraph(report.introduction);
  for (const Correction& one : report.corrections) {
    out.paragraph(one.main ? fmt::format("What it missed: {} {}", one.right, one.shown) : "",
                  "answer");
  }
  return out.paragraph(charts ? "" : words::no_charts, "note");
}

/// On a page what the chapter missed altogether is first, the rest in its order.
Document corrections(const ChapterReport& report, bool holds) {
  const char* const checked = holds ? "Checked" : "Right";
  std::string main;
  std::string others;
  std::string markdown;
  int count = 0;
  for (const auto& [is_so, where, chapter, right, shown, numbers, list, is_main] :
       report.corrections) {
    if (is_so == holds) {
      (is_main ? main : others) += fmt::format(
          "<li><strong>{}.</strong> {}<br>{}: {}<br><span class=\"evidence\">{}</span></li>\n",
          html_text(where), html_prose(chapter), checked, html_prose(right), html_prose(shown));
      markdown +=
          fmt::format("{}{}. **{}.** {}\n   - {}: {}\n   - Shown: {}", count == 0 ? "" : "\n",
                      count + 1, where, chapter, checked, right, shown);
      ++count;
    }
  }
  Document out;
  out.html("<ol class=\"corrections\">\n" + main + others + "</ol>\n");
  out.in(Medium::markdown).paragraph(markdown);
  return holds ? Document().section("holds", "What was checked and holds", std::move(out))
               : Document().section("wrong", "What the chapter got wrong", std::move(out));
}

Document reading(const ChapterReport& report) {
  Document out;
  out.list(report.conventions);
  out.in(Medium::markdown).heading(2, "Case numbers").in(Medium::page).heading(3, "Case numbers");
  out.paragraph(words::case_numbers);
  out.table(case_number_table(), "case-number", "The number of the standard case, digit by digit.");
  return out.list(case_number_rules());
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

Table table_of(const ChapterTable& table) {
  std::vector<Column> columns;
  for (const auto& [name, unit, format] : table.columns) {
    Column column;
    column.heading = name;
    column.unit = unit;
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
  return shown;
}

Document tables(const ChapterReport& report) {
  Document out;
  for (const ChapterTable& table : report.tables) {
    out.in(Medium::markdown).heading(2, table.name).in(Medium::page).heading(3, table.title);
    out.in(Medium::markdown)
        .paragraph(fmt::format("{0} Data: [{1}](chapter/{1}).", table.title, table.file));
    // short: a caption is as wide as its table, and a narrow screen is not
    out.table(table_of(table), id_of(table.name), table.name + ".");
    out.html(
        fmt::format("<p class=\"note\">Data: <a href=\"chapter/{0}\">{0}</a></p>\n"
                    "<div class=\"notes\">\n",
                    html_text(table.file)));
    out.list(table.notes).html("</div>\n");
  }
  return out;
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
      html_prose(figure.chapter), html_prose(figure.truth));
}

Document figures_on_page(const ChapterReport& report, bool charts) {
  Document out;
  out.paragraph(words::figures_of_page);
  out.html("<div class=\"figures\">\n");
  for (const ChapterFigure& figure : report.figures) {
    out.html(figure_html(figure, charts));
  }
  return Document().section("figures", "Its figures", out.html("</div>\n"));
}

Document figures_in_markdown(const ChapterReport& report) {
  Table files({"figure", "plots", "data", "boundaries"}, 4);
  for (const ChapterFigure& figure : report.figures) {
    files.add(
        {figure.number, figure.title, figure.file, figure.boundary ? figure.boundary->file : dash});
  }
  Document out;
  out.paragraph(words::figures).table(std::move(files), "", "");
  out.paragraph(fmt::format(words::figure_data, "step"_a = figure_step));
  for (auto figure = report.figures.begin(); figure != report.figures.end();) {
    const std::string& said = figure->chapter;
    std::vector<std::string> truths;
    for (; figure != report.figures.end() && figure->chapter == said; ++figure) {
      truths.push_back(
          fmt::format("Fig. {}, case {}. {}", figure->number, figure->case_number, figure->truth));
    }
    out.paragraph(said + " In truth:").list(truths);
  }
  return Document().section("", "Figures 5.6 to 5.20", std::move(out));
}

}  // namespace

std::string typeset(std::string text) {
  struct Sign {
    std::string_view spelt;
    std::string_view set;
  };
  constexpr Sign signs[] = {{"<=", "≤"},    {">=", "≥"}, {"&lt;=", "≤"},
                            {"&gt;=", "≥"}, {"^2", "²"}, {"sqrt(", "√("}};
  for (const auto& [spelt, set] : signs) {
    for (std::size_t at = text.find(spelt); at != std::string::npos; at = text.find(spelt, at)) {
      text.replace(at, spelt.size(), set);
    }
  }
  return text;
}

std::string chapter_page(const ChapterReport& report, const PageAssets& assets) {
  const bool charts = !assets.plotly.empty();
  Document main;
  main.add(corrections(report, false)).section("reading", "How to read it", reading(report));
  main.section("tables", "Its tables", tables(report)).add(figures_on_page(report, charts));
  main.add(corrections(report, true));
  std::string content = typeset(fmt::format("<header>\n{}</header>\n{}<main>\n{}</main>\n",
                                            header(report, charts).html(), contents, main.html()));
  return html_document({title, std::move(content), "tautline reproduce", "chapter-data",
                        chapter_page_data(report), assets.chapter_scripts},
                       assets);
}

std::string chapter_markdown(const ChapterReport& report) {
  Document out;
  out.paragraph(report.introduction).add(reading(report)).add(tables(report));
  out.add(figures_in_markdown(report)).add(corrections(report, false));
  return fmt::format("# {}\n\n{}", title, out.add(corrections(report, true)).markdown());
}

}  // namespace tautline::bench
