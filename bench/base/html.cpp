#include "bench/base/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace tautline::bench {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// What `markdown_text` writes a backslash before. In a text that is being marked up the byte of
/// its place is there instead, from 1 on, which no printable text has.
constexpr std::string_view harmless = "|<>`*[]!&#";

std::string with_hidden(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::size_t place =
        text[at] == '\\' && at + 1 < text.size() ? harmless.find(text[at + 1]) : harmless.npos;
    at += place != harmless.npos ? 1U : 0U;
    result += place != harmless.npos ? static_cast<char>(place + 1) : text[at];
  }
  return result;
}

std::string with_shown(const std::string& text, std::string (*shown)(std::string_view one)) {
  std::string result;
  for (const char& one : text) {
    const bool hidden = one > 0 && static_cast<std::size_t>(one) <= harmless.size();
    result +=
        hidden ? shown(harmless.substr(static_cast<std::size_t>(one) - 1, 1)) : std::string(1, one);
  }
  return result;
}

/// Turns each pair of `mark` around words into `form`, an element. A mark beside blanks is none:
/// "a * b".
void mark_up(std::string& text, std::string_view mark, const char* form) {
  const auto blank = [&](std::size_t at) { return at >= text.size() || text[at] == ' '; };
  std::size_t at = text.find(mark);
  while (at != std::string::npos) {
    const std::size_t start = at + mark.size();
    std::size_t end = text.find(mark, start + 1);
    while (end != std::string::npos && blank(end - 1)) {
      end = text.find(mark, end + 1);
    }
    if (blank(start) || end == std::string::npos) {
      at = text.find(mark, start);
      continue;
    }
    const std::string inner = text.substr(start, end - start);
    const std::string marked = fmt::format(fmt::runtime(form), inner);
    text.replace(at, end + mark.size() - at, marked);
    at = text.find(mark, at + marked.size());
  }
}

std::string heading_html(const Column& column, bool grouped) {
  return fmt::format(
      "<th scope=\"col\"{}{}{}>{}{}</th>", column.numbers ? " class=\"n\"" : "",
      column.key.empty() ? "" : " data-key=\"" + html_text(column.key) + "\"",
      grouped && column.group.empty() ? " rowspan=\"2\"" : "", html_text(column.heading),
      column.unit.empty() ? "" : " <span class=\"unit\">[" + html_text(column.unit) + "]</span>");
}

/// The heading of the group that starts at `first`, over all its columns.
std::string group_html(const std::vector<Column>& columns, std::size_t first) {
  std::size_t end = first;
  while (end < columns.size() && columns[end].group == columns[first].group) {
    ++end;
  }
  return fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", end - first,
                     html_text(columns[first].group));
}

std::string head_html(const std::vector<Column>& columns) {
  const bool grouped = std::any_of(columns.begin(), columns.end(),
                                   [](const Column& column) { return !column.group.empty(); });
  std::string upper;
  std::string lower;
  for (std::size_t place = 0; place < columns.size(); ++place) {
    const Column& column = columns[place];
    if (column.group.empty()) {
      upper += heading_html(column, grouped);
      continue;
    }
    if (place == 0 || columns[place - 1].group != column.group) {
      upper += group_html(columns, place);
    }
    lower += heading_html(column, grouped);
  }
  return "<thead>\n<tr>" + upper + "</tr>\n" + (grouped ? "<tr>" + lower + "</tr>\n" : "") +
         "</thead>\n";
}

/// A cell over so many columns; `numbers` is its column's.
std::string cell_html(const Cell& cell, bool numbers, std::size_t span) {
  constexpr std::size_t longest = 1100;  // [bytes], of a whole sentence
  const std::string wide = span > 1 ? fmt::format(" colspan=\"{}\"", span) : "";
  if (cell.is_number) {
    if (cell.number && span == 1 && cell.text == shortest(*cell.number)) {
      return "<td class=\"n\">" + html_text(cell.text) + "</td>";  // which says it all
    }
    const std::string value = cell.number ? "=\"" + shortest(*cell.number) + "\"" : "";
    return fmt::format("<td data-value{}{}>{}</td>", value, wide, html_text(cell.text));
  }
  const std::string look = !cell.kind.empty()     ? html_text(cell.kind)
                           : numbers && span == 1 ? "n"
                                                  : "";
  // the look of a kind may be the first line's alone
  std::string text = html_text(cell.text, longest);
  text = cell.kind.empty() ? text : "<span>" + text + "</span>";
  for (const std::string& note : cell.notes) {
    text += "<br>" + html_text(note, longest);
  }
  return fmt::format("<td{}{}>{}</td>", look.empty() ? "" : " class=\"" + look + "\"", wide, text);
}

std::string row_html(const Row& row, const std::vector<Column>& columns) {
  constexpr std::size_t longest_name = 60;
  std::string out = row.kind.empty() ? "<tr>" : "<tr class=\"" + html_text(row.kind) + "\">";
  const std::string name = html_text(row.cells.front().text, longest_name);
  // a row that goes on with what is named above has no name of its own
  out += name.empty() ? "<td></td>" : "<th scope=\"row\">" + name + "</th>";
  for (std::size_t place = 1; place < row.cells.size(); ++place) {
    const bool last = place + 1 == row.cells.size();
    out += cell_html(row.cells[place], columns[place].numbers, last ? columns.size() - place : 1);
  }
  return out + "</tr>\n";
}

}  // namespace

std::string html_text(std::string_view text, std::size_t longest) {
  return xml_text(printable(text, longest));
}

std::string html_prose(std::string_view text) {
  constexpr std::size_t longest_paragraph = 4000;
  std::string result = xml_text(with_hidden(printable(text, longest_paragraph)));
  mark_up(result, "`", "<code>{}</code>");
  mark_up(result, "**", "<strong>{}</strong>");
  mark_up(result, "*", "<em>{}</em>");
  return with_shown(result, xml_text);
}

std::string plain_prose(std::string_view text) {
  std::string result = with_hidden(text);
  for (const char* const mark : {"`", "**", "*"}) {
    mark_up(result, mark, "{}");
  }
  return with_shown(result, [](std::string_view one) { return std::string(one); });
}

std::string verbatim(std::string_view text, std::size_t longest) {
  return markdown_text(printable(text, longest));
}

std::string html_json(std::string json) {
  replace_all(json, "<", "\\u003c");
  replace_all(json, "\xE2\x80\xA8", "\\u2028");  // lines end here for a script, not for JSON
  replace_all(json, "\xE2\x80\xA9", "\\u2029");
  return json;
}

std::string html_table(const Table& table, const std::string& id, const std::string& caption) {
  std::string bodies;
  const std::vector<Row>& rows = table.rows();
  for (std::size_t index = 0; index < rows.size(); ++index) {
    if (index == 0 || rows[index].body != rows[index - 1].body) {
      bodies += index == 0 ? "" : "</tbody>\n";
      bodies += rows[index].body.empty()
                    ? "<tbody>\n"
                    : "<tbody class=\"" + html_text(rows[index].body) + "\">\n";
    }
    bodies += row_html(rows[index], table.columns());
  }
  bodies += rows.empty() ? "" : "</tbody>\n";
  return fmt::format(
      "<div class=\"table-box\" tabindex=\"0\" role=\"region\" aria-labelledby=\"{0}-caption\">\n"
      "<table id=\"{0}\">\n<caption id=\"{0}-caption\">{1}</caption>\n{2}{3}</table>\n</div>\n",
      html_text(id), html_prose(caption), head_html(table.columns()), bodies);
}

}  // namespace tautline::bench
