// The source chapter on the page: its errors first, its tables, its figures.
#include <fmt/format.h>

#include "bench/report/html/page.hpp"
#include "bench/report/html/parts.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

std::string correction_item(const ordered_json& one) {
  const bool holds = one.at("holds");
  return fmt::format(
      "<li><strong>{}.</strong> {}<br>{}: {}<br><span class=\"evidence\">{}</span></li>\n",
      html_text(text_of(one, "where")), html_prose(text_of(one, "chapter")),
      holds ? "Checked" : "Right", html_prose(text_of(one, "right")),
      html_prose(text_of(one, "shown")));
}

std::string corrections(const ordered_json& list, bool holds) {
  std::string out;
  for (const ordered_json& one : list) {
    out += one.at("holds") == holds ? correction_item(one) : "";
  }
  return "<ol class=\"corrections\">\n" + out + "</ol>\n";
}

/// Six digits, as the chapter prints; in full in data-value.
std::string cell(const ordered_json& value) {
  if (value.is_string()) {
    return word_cell(value.get<std::string>());
  }
  return number_cell(value, value.is_number() ? fmt::format("{:.6g}", value.get<double>()) : "");
}

/// The chapter's own numbers are text, as printed: set like numbers where a column holds nothing
/// else.
bool holds_numbers(const ordered_json& rows, std::size_t column) {
  for (const ordered_json& row : rows) {
    const ordered_json& value = row.at(column);
    if (value.is_string() &&
        value.get<std::string>().find_first_not_of("+-.0123456789e") != std::string::npos) {
      return false;
    }
  }
  return true;
}

std::string table_html(const ordered_json& table) {
  std::vector<HtmlColumn> columns;
  const ordered_json& rows = table.at("rows");
  for (std::size_t index = 0; index < table.at("columns").size(); ++index) {
    const ordered_json& column = table.at("columns").at(index);
    columns.push_back({"", text_of(column, "name"), text_of(column, "unit"), "",
                       !rows.empty() && holds_numbers(rows, index)});
  }
  std::string id = "chapter-" + text_of(table, "name");
  for (char& letter : id) {
    const bool plain = (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'z') ||
                       (letter >= 'A' && letter <= 'Z');
    letter = plain ? letter : '-';
  }
  HtmlTable html(id, html_text(text_of(table, "name")) + ". " + html_prose(text_of(table, "title")),
                 columns);
  for (const ordered_json& row : rows) {
    std::vector<std::string> cells;
    for (std::size_t index = 0; index < row.size(); ++index) {
      const ordered_json& value = row.at(index);
      const bool as_number = value.is_string() && columns[index].numbers;
      cells.push_back(as_number ? "<td class=\"n\">" + html_text(value.get<std::string>())
                                : cell(value));
    }
    html.add(cells);
  }
  std::string notes;
  for (const ordered_json& note : table.at("notes")) {
    notes += fmt::format("<li>{}</li>\n", html_prose(note.get<std::string>()));
  }
  return html.html() + (notes.empty() ? "" : "<ul class=\"notes\">\n" + notes + "</ul>\n");
}

std::string figure_html(const ordered_json& figure) {
  const std::string name = html_text(text_of(figure, "name"));
  return fmt::format(
      "<figure class=\"chapter-figure\">\n<div class=\"chart\" data-figure=\"{0}\" role=\"img\" "
      "aria-label=\"Figure {0}: {1}\"><p class=\"no-script\">Drawn by script only.</p></div>\n"
      "<figcaption><b>Fig. {0}.</b> {1}.<br><i>The chapter:</i> {2}<br><i>In truth:</i> {3}"
      "</figcaption>\n</figure>\n",
      name, html_text(text_of(figure, "title")), html_prose(text_of(figure, "chapter")),
      html_prose(text_of(figure, "truth")));
}

}  // namespace

std::string chapter_section(const ordered_json& report) {
  const ordered_json& chapter = member(report, "chapter");
  std::string out = "<section id=\"chapter\">\n<h2>The source chapter, computed again</h2>\n";
  if (!chapter.is_object()) {
    return out +
           "<p>Not in this report: it is made when all the chapter’s cases are run whole, as "
           "<code>tautline "
           "bench</code> does without arguments, and by <code>tautline "
           "reproduce</code>.</p>\n</section>\n";
  }
  out +=
      "<p>Lengths are in S, half the distance of the anchors; times in sqrt(S/g), speeds in "
      "sqrt(gS), "
      "energies in mgS from the equilibrium.</p>\n";
  out += "<h3>What the chapter got wrong</h3>\n" + corrections(chapter.at("corrections"), false);
  out += "<h3>Its tables</h3>\n";
  for (const ordered_json& table : chapter.at("tables")) {
    out += table_html(table);
  }
  out += "<h3>Its figures</h3>\n<div class=\"figures\">\n";
  for (const ordered_json& figure : chapter.at("figures")) {
    out += figure_html(figure);
  }
  out += "</div>\n<h3>What was checked and holds</h3>\n" +
         corrections(chapter.at("corrections"), true);
  return out + "</section>\n";
}

}  // namespace tautline::bench
