#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tautline::bench {

/// `text` with the characters that Markdown and HTML read as their own made harmless, on one line.
[[nodiscard]] std::string markdown_text(const std::string& text);

/// Columns that `text` takes on a terminal; continuation bytes of UTF-8 take none.
[[nodiscard]] std::size_t terminal_width(const std::string& text);

/// A table of text whose columns line up, so that it reads the same rendered and raw.
class Table {
 public:
  /// The first `left` columns hold words, and so do the last `words`; the others numbers, set to
  /// the right.
  Table(std::vector<std::string> headings, std::size_t left, std::size_t words = 0);

  /// One cell per heading.
  void add(std::vector<std::string> cells);

  [[nodiscard]] bool empty() const { return rows_.empty(); }

  /// As a Markdown table; bars and line breaks inside cells are made harmless.
  [[nodiscard]] std::string markdown() const;

  /// As plain aligned columns for a terminal.
  [[nodiscard]] std::string plain() const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths(
      const std::vector<std::vector<std::string>>& rows) const;
  [[nodiscard]] std::string line(const std::vector<std::string>& cells,
                                 const std::vector<std::size_t>& widths,
                                 const std::string& separator) const;

  /// True for words, which are set to the left.
  [[nodiscard]] bool holds_words(std::size_t column) const {
    return column < left_ || column + words_ >= headings_.size();
  }

  std::vector<std::string> headings_;
  std::size_t left_;
  std::size_t words_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace tautline::bench
