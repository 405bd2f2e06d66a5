#include "bench/base/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Turns each pair of `mark` around words into an element. A mark beside blanks is none: "a * b".
void mark_up(std::string& text, std::string_view mark, const std::string& element) {
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
    const std::string marked = fmt::format("<{0}>{1}</{0}>", element, inner);
    text.replace(at, end + mark.size() - at, marked);
    at = text.find(mark, at + marked.size());
  }
}

}  // namespace

std::string html_text(std::string_view text, std::size_t longest) {
  return xml_text(printable(text, longest));
}

std::string html_prose(std::string_view text) {
  constexpr std::size_t longest_paragraph = 4000;
  std::string result = html_text(text, longest_paragraph);
  mark_up(result, "`", "code");
  mark_up(result, "**", "strong");
  mark_up(result, "*", "em");
  return result;
}

std::string html_json(const ordered_json& json) {
  // a name from outside need not be UTF-8; the page shows it with the sign for what is not
  std::string text = json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  replace_all(text, "<", "\\u003c");
  replace_all(text, "\xE2\x80\xA8", "\\u2028");  // lines end here for a script, not for JSON
  replace_all(text, "\xE2\x80\xA9", "\\u2029");
  return text;
}

std::string word_cell(std::string_view text, std::size_t longest) {
  return "<td>" + html_text(text, longest);
}

std::string row_heading(std::string_view text) {
  constexpr std::size_t longest_name = 60;
  return "<th scope=\"row\">" + html_text(text, longest_name);
}

std::string number_cell(const ordered_json& value, std::string_view shown) {
  if (!value.is_number()) {
    return "<td data-value=\"\">–";
  }
  const std::string full = value.is_number_float() ? shortest(value.get<double>()) : value.dump();
  return fmt::format("<td data-value=\"{}\">{}", full, shown);
}

std::string error_cell(const ordered_json& value) {
  if (value.is_number() && value.get<double>() == 0.0) {  // exactly: no digits to show
    return number_cell(value, "0");
  }
  return number_cell(value, value.is_number() ? fmt::format("{:.1e}", value.get<double>()) : "");
}

std::string fixed_cell(const ordered_json& value, int digits) {
  return number_cell(value,
                     value.is_number() ? fmt::format("{:.{}f}", value.get<double>(), digits) : "");
}

std::string plain_cell(const ordered_json& value) {
  return number_cell(value, value.is_number() ? fmt::format("{:g}", value.get<double>()) : "");
}

HtmlTable::HtmlTable(std::string id, std::string caption, std::vector<HtmlColumn> columns)
    : id_(std::move(id)), caption_(std::move(caption)), columns_(std::move(columns)) {}

void HtmlTable::begin_body(const std::string& name) {
  bodies_ += open_ ? "</tbody>\n" : "";
  open_ = false;
  body_ = name;
}

void HtmlTable::add(const std::vector<std::string>& cells, const std::string& attributes) {
  if (!open_) {
    bodies_ += body_.empty() ? "<tbody>\n" : "<tbody class=\"" + body_ + "\">\n";
    open_ = true;
  }
  bodies_ += attributes.empty() ? "<tr>" : "<tr " + attributes + ">";
  for (const std::string& cell : cells) {
    bodies_ += cell + (cell.starts_with("<th") ? "</th>" : "</td>");
  }
  bodies_ += "</tr>\n";
  ++rows_;
}

std::string HtmlTable::head() const {
  std::string upper;
  std::string lower;
  const bool grouped = std::any_of(columns_.begin(), columns_.end(),
                                   [](const HtmlColumn& column) { return !column.group.empty(); });
  for (std::size_t index = 0; index < columns_.size(); ++index) {
    const HtmlColumn& column = columns_[index];
    std::string cell = fmt::format(
        "<th scope=\"col\"{}{}{}>{}{}</th>", column.numbers ? " class=\"n\"" : "",
        column.key.empty() ? "" : " data-key=\"" + html_text(column.key) + "\"",
        grouped && column.group.empty() ? " rowspan=\"2\"" : "", html_text(column.heading),
        column.unit.empty() ? "" : " <span class=\"unit\">[" + html_text(column.unit) + "]</span>");
    if (column.group.empty()) {
      upper += cell;
      continue;
    }
    if (index == 0 || columns_[index - 1].group != column.group) {
      std::size_t end = index;
      while (end < columns_.size() && columns_[end].group == column.group) {
        ++end;
      }
      upper += fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", end - index,
                           html_text(column.group));
    }
    lower += cell;
  }
  return "<thead>\n<tr>" + upper + "</tr>\n" + (grouped ? "<tr>" + lower + "</tr>\n" : "") +
         "</thead>\n";
}

std::string HtmlTable::html() const {
  return fmt::format(
      "<div class=\"table-box\" tabindex=\"0\" role=\"region\" aria-labelledby=\"{0}-caption\">\n"
      "<table id=\"{0}\">\n<caption id=\"{0}-caption\">{1}</caption>\n{2}{3}{4}</table>\n</div>\n",
      id_, caption_, head(), bodies_, open_ ? "</tbody>\n" : "");
}

}  // namespace tautline::bench
