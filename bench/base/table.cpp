#include "bench/base/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <sstream>
#include <string_view>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// One cell of a line of text.
struct Shown {
  std::string text;
  Colour colour = Colour::plain;
};

/// One line of text, a cell for each column; or fewer where the last one spans the rest.
struct Line {
  std::vector<Shown> cells;
  bool spans = false;
};

/// The text of a cell and its notes, on one line.
std::string whole_text(const Cell& cell) {
  std::string text = cell.text;
  const char* separator = ": ";
  for (const std::string& note : cell.notes) {
    text += separator + note;
    separator = "; ";
  }
  return text;
}

std::string markdown_heading(const Column& column) {
  return (column.group.empty() ? "" : column.group + ": ") + column.heading +
         (column.unit.empty() ? "" : " [" + column.unit + "]");
}

std::string plain_heading(const Column& column) {
  if (!column.brief.empty()) {
    return column.brief;
  }
  return (column.group.empty() ? "" : column.group + ": ") + column.heading;
}

/// The width of each column; what spans several does not count.
std::vector<std::size_t> widths_of(const std::vector<Line>& lines, std::size_t columns,
                                   std::size_t least) {
  std::vector<std::size_t> widths(columns, least);
  for (const Line& line : lines) {
    const std::size_t own = line.cells.size() - (line.spans ? 1 : 0);
    for (std::size_t place = 0; place < own; ++place) {
      widths[place] = std::max(widths[place], terminal_width(line.cells[place].text));
    }
  }
  return widths;
}

std::string padded(const Shown& cell, std::size_t width, bool numbers, const TerminalStyle& style) {
  const std::size_t own = terminal_width(cell.text);
  const std::string space(width - std::min(own, width), ' ');
  const std::string text = coloured(cell.text, cell.colour, style);
  return numbers ? space + text : text + space;
}

/// The cells of a row as Markdown. It knows no cell that spans others: that one is the last, after
/// dashes.
Line markdown_line(const Row& row, std::size_t columns) {
  Line line;
  for (const Cell& cell : row.cells) {
    line.cells.push_back({markdown_text(whole_text(cell))});
  }
  line.cells.insert(line.cells.end() - 1, columns - row.cells.size(), {dash});
  return line;
}

/// The cells of a row at the places that are shown.
Line plain_line(const Row& row, const std::vector<std::size_t>& places, std::size_t columns) {
  Line line;
  line.spans = row.cells.size() < columns;
  const std::size_t own = row.cells.size() - (line.spans ? 1 : 0);
  for (const std::size_t place : places) {
    if (place < own) {
      line.cells.push_back({whole_text(row.cells[place]), row.cells[place].colour});
    }
  }
  if (line.spans) {
    line.cells.push_back({whole_text(row.cells.back()), row.cells.back().colour});
  }
  return line;
}

/// The places of the columns up to a rank.
std::vector<std::size_t> places_up_to(int rank, const std::vector<Column>& columns) {
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < columns.size(); ++place) {
    if (columns[place].rank <= rank) {
      places.push_back(place);
    }
  }
  return places;
}

/// The lines of a table with the columns up to a rank, the headings first.
std::vector<Line> plain_lines(const Table& table, const std::vector<std::size_t>& places) {
  Line headings;
  for (const std::size_t place : places) {
    headings.cells.push_back({plain_heading(table.columns()[place])});
  }
  std::vector<Line> lines;
  lines.reserve(table.rows().size() + 1);
  lines.push_back(std::move(headings));
  for (const Row& row : table.rows()) {
    lines.push_back(plain_line(row, places, table.columns().size()));
  }
  return lines;
}

constexpr std::size_t between = 2;  // [columns], of two neighbours on a terminal

std::size_t total(const std::vector<std::size_t>& widths) {
  std::size_t sum = 0;
  for (const std::size_t width : widths) {
    sum += (sum == 0 ? 0 : between) + width;
  }
  return sum;
}

/// Where column `at` begins.
std::size_t start_of(std::size_t at, const std::vector<std::size_t>& widths) {
  std::size_t sum = 0;
  for (std::size_t place = 0; place < at; ++place) {
    sum += widths[place] + between;
  }
  return sum;
}

/// Words in fewer columns than this are read with more trouble than a line that is too long.
constexpr std::size_t least_for_words = 16;

/// What the width leaves to the last column if it holds words; all that it needs where that is
/// too little.
std::size_t room_of_the_last(const std::vector<std::size_t>& widths,
                             const std::vector<std::size_t>& places,
                             const std::vector<Column>& columns, std::size_t width) {
  const std::size_t start = start_of(widths.size() - 1, widths);
  const bool words = !columns[places.back()].numbers;
  return words && width >= start + least_for_words ? width - start : widths.back();
}

/// The text of a cell that begins at `start`, in as many lines as it takes below each other.
std::string hanging(const Shown& cell, std::size_t start, const TerminalStyle& style) {
  if (style.width < start + least_for_words) {
    return coloured(cell.text, cell.colour, style);
  }
  std::istringstream lines(wrapped(cell.text, style.width - start));
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    result +=
        (result.empty() ? "" : "\n" + std::string(start, ' ')) + coloured(line, cell.colour, style);
  }
  return result;
}

}  // namespace

std::string number_text(double value, Digits digits) {
  if (value == 0.0) {  // exactly: no digits to show
    return "0";
  }
  switch (digits.kind) {
    case Digits::Kind::error:
      return fmt::format("{:.1e}", value);
    case Digits::Kind::fixed:
      return fixed_text(value, digits.count);
    case Digits::Kind::shortest:
      break;
  }
  constexpr double countable = 1e15;  // a count has all its digits
  const bool whole = std::trunc(value) == value && std::abs(value) < countable;
  return whole ? fmt::format("{:.0f}", value) : fmt::format("{:g}", value);
}

Cell number_cell(std::optional<double> value, Digits digits) {
  Cell cell = value ? number_text(*value, digits) : dash;
  cell.number = value;
  cell.is_number = true;
  return cell;
}

Table::Table(const std::vector<std::string>& headings, std::size_t left, std::size_t words) {
  for (std::size_t place = 0; place < headings.size(); ++place) {
    Column column;
    column.heading = headings[place];
    column.numbers = place >= left && place + words < headings.size();
    columns_.push_back(std::move(column));
  }
}

void Table::add(Row row) {
  assert(!row.cells.empty() && row.cells.size() <= columns_.size() && "no more cells than columns");
  rows_.push_back(std::move(row));
}

void Table::cut(std::size_t most, const std::string& what) {
  if (rows_.size() > most) {
    rest_ = fmt::format("and {} more{}\n", rows_.size() - most, what);
    rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(most), rows_.end());
  }
}

std::string Table::markdown() const {
  Line headings;
  std::transform(columns_.begin(), columns_.end(), std::back_inserter(headings.cells),
                 [](const Column& column) { return Shown{markdown_heading(column)}; });
  std::vector<Line> lines;
  lines.reserve(rows_.size() + 2);
  lines.push_back(std::move(headings));
  for (const Row& row : rows_) {
    lines.push_back(markdown_line(row, columns_.size()));
  }
  constexpr std::size_t shortest_rule = 3;
  const std::vector<std::size_t> widths = widths_of(lines, columns_.size(), shortest_rule);
  Line rule;
  for (std::size_t place = 0; place < columns_.size(); ++place) {
    const bool numbers = columns_[place].numbers;
    rule.cells.push_back(
        {std::string(widths[place] - (numbers ? 1 : 0), '-') + (numbers ? ":" : "")});
  }
  lines.insert(lines.begin() + 1, std::move(rule));
  std::string result;
  for (const Line& line : lines) {
    for (std::size_t place = 0; place < columns_.size(); ++place) {
      result += (place == 0 ? "| " : " | ") +
                padded(line.cells[place], widths[place], columns_[place].numbers, unlimited);
    }
    result += " |\n";
  }
  return result;
}

std::string Table::plain(const TerminalStyle& style) const {
  int rank = 0;
  for (const Column& column : columns_) {
    rank = column.rank < of_a_page ? std::max(rank, column.rank) : rank;
  }
  std::vector<std::size_t> places = places_up_to(rank, columns_);
  std::vector<Line> lines = plain_lines(*this, places);
  std::vector<std::size_t> widths = widths_of(lines, places.size(), 0);
  while (rank > 0 && total(widths) > style.width) {
    places = places_up_to(--rank, columns_);
    lines = plain_lines(*this, places);
    widths = widths_of(lines, places.size(), 0);
  }
  const std::size_t room = room_of_the_last(widths, places, columns_, style.width);
  std::string result;
  for (const Line& line : lines) {
    std::string text;
    for (std::size_t at = 0; at < line.cells.size(); ++at) {
      text += at == 0 ? "" : std::string(between, ' ');
      const bool spans = line.spans && at + 1 == line.cells.size();
      const bool numbers = !spans && columns_[places[at]].numbers;
      if (spans) {
        text += hanging(line.cells[at], start_of(at, widths), style);
      } else if (at + 1 == widths.size() && widths[at] > room) {
        text += hanging(line.cells[at], style.width - room, style);
      } else {
        text += padded(line.cells[at], widths[at], numbers, style);
      }
    }
    text.erase(text.find_last_not_of(' ') + 1);
    result += text + "\n";
  }
  std::string left_out;
  for (const Column& column : columns_) {
    if (column.rank > rank && column.rank < of_a_page) {
      left_out += (left_out.empty() ? "" : ", ") + plain_heading(column);
    }
  }
  return result +
         (left_out.empty() ? "" : wrapped("not shown at this width: " + left_out, style.width)) +
         rest_;
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

std::size_t terminal_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char letter) {
    return (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U;
  }));
}

std::string wrapped(const std::string& text, std::size_t width) {
  std::istringstream words(text);
  std::string result;
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && terminal_width(line) + 1 + terminal_width(word) > width) {
      result += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? result : result + line + "\n";
}

std::string wrapped_lines(const std::string& text, std::size_t width, std::size_t hang) {
  std::istringstream lines(text);
  std::string result;
  for (std::string line; std::getline(lines, line);) {
    if (terminal_width(line) <= width) {
      result += line + "\n";
      continue;
    }
    const std::size_t own = std::min(line.find_first_not_of(' '), line.size());
    const std::string indent(own, ' ');
    const std::string more(own + hang, ' ');
    const std::size_t room = width > more.size() + least_for_words ? width - more.size() : width;
    std::istringstream parts(wrapped(line, room));
    const std::string* before = &indent;
    for (std::string part; std::getline(parts, part); before = &more) {
      result += *before + part + "\n";
    }
  }
  return result;
}

}  // namespace tautline::bench
