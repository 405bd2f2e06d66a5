#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bench/base/terminal.hpp"

namespace tautline::bench {

/// How a number is shown.
struct Digits {
  enum class Kind {
    error,     // two significant digits, which is what an error is good for
    fixed,     // so many after the point
    shortest,  // as short as it reads: counts and steps
  };
  Kind kind = Kind::shortest;
  int count = 0;  // of Kind::fixed
};
inline constexpr Digits as_error = {Digits::Kind::error, 0};
inline constexpr Digits as_count = {Digits::Kind::shortest, 0};
[[nodiscard]] constexpr Digits fixed(int count) { return {Digits::Kind::fixed, count}; }

/// `value` with `digits`: "1.2e-05", "0.9000", "3"; exactly zero is "0".
[[nodiscard]] std::string number_text(double value, Digits digits);

/// Shown in place of a missing number.
inline constexpr const char* dash = "–";

/// The rank of a column that stands on a page alone: no terminal shows it.
inline constexpr int of_a_page = 100;

/// A column of a table.
struct Column {
  std::string heading;
  std::string unit;     // or empty
  std::string group;    // heading above neighbours that share it, or empty
  std::string key;      // by which a page and its address know it; "" where it cannot be sorted
  std::string brief;    // heading on a terminal; "": `heading`
  bool numbers = true;  // set to the right; else words
  int rank = 0;         // where there is no room for all, the highest goes first; 0 never goes
};

/// A cell: words, or a number that is shown with few digits and kept with all of them.
struct Cell {
  // implicit: most cells are just a text
  Cell(std::string words) : text(std::move(words)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* words) : text(words) {}             // NOLINT(google-explicit-constructor)

  std::string text;
  std::optional<double> number;    // what `text` shows
  bool is_number = false;          // true too where a number is missing
  std::string kind;                // a word for its look, such as "verdict pass", or empty
  std::vector<std::string> notes;  // lines below the text
  Colour colour = Colour::plain;   // on a terminal
};

/// A number, or a dash.
[[nodiscard]] Cell number_cell(std::optional<double> value, Digits digits);

/// A row; one with fewer cells than the table has columns fills the rest with its last cell.
struct Row {
  std::vector<Cell> cells;
  std::string kind;  // a word for its look, such as "failed", or empty
  std::string body;  // the part of the table it stands in, such as "control", or empty
};

/// A table of any kind: what it shows, once, for Markdown, for a terminal and for a page.
class Table {
 public:
  explicit Table(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// The first `left` columns hold words, and so do the last `words`; the others numbers.
  Table(const std::vector<std::string>& headings, std::size_t left, std::size_t words = 0);

  /// As many cells as columns, or fewer where the last one spans the rest.
  void add(std::vector<Cell> cells) { add(Row{std::move(cells), "", ""}); }
  void add(Row row);

  /// Words alone, which stand in a list of their own.
  template <class Words>
  requires std::is_same_v<Words, std::vector<std::string>>
  void add(const Words& words) { add(std::vector<Cell>(words.begin(), words.end())); }

  /// Keeps the first `most` rows. A terminal shows below them how many more there are: "and 3 more"
  /// and `what`.
  void cut(std::size_t most, const std::string& what = "");

  [[nodiscard]] bool empty() const { return rows_.empty(); }
  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }

  /// As a Markdown table whose columns line up, so that it reads the same rendered and raw; what
  /// Markdown or HTML would read as its own is made harmless.
  [[nodiscard]] std::string markdown() const;

  /// As aligned columns for a terminal. Columns that do not fit the width are left out, those of
  /// the highest rank first, and named below. Words in the last column take more lines where one is
  /// too short for them.
  [[nodiscard]] std::string plain(const TerminalStyle& style = unlimited) const;

 private:
  std::vector<Column> columns_;
  std::vector<Row> rows_;
  std::string rest_;  // of rows that were cut, on a terminal
};

/// `text` with the characters that Markdown and HTML read as their own made harmless, on one line.
[[nodiscard]] std::string markdown_text(const std::string& text);

/// Columns that `text` takes on a terminal; continuation bytes of UTF-8 take none.
[[nodiscard]] std::size_t terminal_width(const std::string& text);

/// `text` in lines of at most `width` columns, broken at its blanks, each with an end.
[[nodiscard]] std::string wrapped(const std::string& text, std::size_t width);

/// The same for each line of `text` that is too long; what follows in a line of its own is indented
/// as that line is, and by `hang` more.
[[nodiscard]] std::string wrapped_lines(const std::string& text, std::size_t width,
                                        std::size_t hang = 0);

}  // namespace tautline::bench
