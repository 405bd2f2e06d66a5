#include "bench/base/table.hpp"

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

namespace tautline::bench {
namespace {

std::string padded(const std::string& text, std::size_t width, bool left) {
  const std::string space(width - terminal_width(text), ' ');
  return left ? text + space : space + text;
}

}  // namespace

std::size_t terminal_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U;
  }));
}

std::string markdown_text(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    if (letter == '\n' || letter == '\r') {
      result += ' ';
      continue;
    }
    if (std::string_view("|<>`*[]!&#").find(letter) != std::string_view::npos) {
      result += '\\';
    }
    result += letter;
  }
  return result;
}

Table::Table(std::vector<std::string> headings, std::size_t left, std::size_t words)
    : headings_(std::move(headings)), left_(left), words_(words) {}

void Table::add(std::vector<std::string> cells) {
  assert(cells.size() == headings_.size() && "one cell per heading");
  rows_.push_back(std::move(cells));
}

std::vector<std::size_t> Table::widths(const std::vector<std::vector<std::string>>& rows) const {
  std::vector<std::size_t> result;
  for (std::size_t column = 0; column < headings_.size(); ++column) {
    std::size_t width = std::max<std::size_t>(3, terminal_width(headings_[column]));
    for (const auto& row : rows) {
      width = std::max(width, terminal_width(row[column]));
    }
    result.push_back(width);
  }
  return result;
}

std::string Table::line(const std::vector<std::string>& cells,
                        const std::vector<std::size_t>& widths,
                        const std::string& separator) const {
  std::string result;
  for (std::size_t column = 0; column < cells.size(); ++column) {
    result +=
        (column == 0 ? "" : separator) + padded(cells[column], widths[column], holds_words(column));
  }
  return result;
}

std::string Table::markdown() const {
  std::vector<std::vector<std::string>> rows = rows_;
  for (auto& row : rows) {
    std::transform(row.begin(), row.end(), row.begin(), markdown_text);
  }
  const std::vector<std::size_t> width = widths(rows);
  std::vector<std::string> rule;
  for (std::size_t column = 0; column < headings_.size(); ++column) {
    std::string dashes(width[column], '-');
    if (!holds_words(column)) {
      dashes.back() = ':';
    }
    rule.push_back(std::move(dashes));
  }
  std::string result = "| " + line(headings_, width, " | ") + " |\n";
  result += "| " + line(rule, width, " | ") + " |\n";
  for (const auto& row : rows) {
    result += "| " + line(row, width, " | ") + " |\n";
  }
  return result;
}

std::string Table::plain() const {
  const std::vector<std::size_t> width = widths(rows_);
  std::string result;
  const auto add_line = [&](const std::vector<std::string>& cells) {
    std::string text = line(cells, width, "  ");
    text.erase(text.find_last_not_of(' ') + 1);
    result += text + "\n";
  };
  add_line(headings_);
  std::for_each(rows_.begin(), rows_.end(), add_line);
  return result;
}

}  // namespace tautline::bench
