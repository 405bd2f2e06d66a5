#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace tautline::bench {

/// A cell of a table, or a number with a name: nothing, a number, a count or words.
using ChapterCell = std::variant<std::monostate, double, long, std::string>;

[[nodiscard]] inline ChapterCell count(std::size_t number) { return static_cast<long>(number); }

/// A column of a table: how its numbers read.
struct ChapterColumn {
  std::string name;
  std::string unit;    // as the chapter's nondimensional lengths and times have it, or empty
  std::string format;  // of a number to be read, as fmt has it; empty: words or counts
};

/// A table that is written as Markdown, CSV and JSON from the same cells.
struct ChapterTable {
  std::string name;   // "Table 5.1"
  std::string title;  // a sentence
  std::string file;   // of its CSV
  std::size_t left;   // columns of words, set to the left
  std::vector<ChapterColumn> columns;
  std::vector<std::vector<ChapterCell>> rows;
  std::vector<std::string> notes;  // sentences below it
};

/// `cell` as words to read, its number by the column's format; a dash for nothing.
[[nodiscard]] std::string cell_text(const ChapterCell& cell, const ChapterColumn& column);

}  // namespace tautline::bench
