#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tautline::bench {

/// A column of a table: how its numbers read in Markdown.
struct Column {
  std::string name;
  std::string unit;    // as the chapter's nondimensional lengths and times have it, or empty
  std::string format;  // of a number in Markdown, as fmt has it; empty: words, or as it stands
};

/// A table that is written as Markdown, CSV and JSON from the same cells.
struct ChapterTable {
  std::string name;   // "Table 5.1"
  std::string title;  // a sentence
  std::string file;   // of its CSV
  std::size_t left;   // columns of words, set to the left
  std::vector<Column> columns;
  std::vector<std::vector<nlohmann::ordered_json>> rows;  // null where there is no number
  std::vector<std::string> notes;                         // sentences below it
};

[[nodiscard]] std::string table_csv(const ChapterTable& table);
[[nodiscard]] std::string table_markdown(const ChapterTable& table);
[[nodiscard]] nlohmann::ordered_json table_json(const ChapterTable& table);

/// "name [unit]", or the name alone.
[[nodiscard]] std::string heading(const std::string& name, const std::string& unit);

/// `text` as one field of a CSV file, in quotes where it must be.
[[nodiscard]] std::string csv_field(const std::string& text);

}  // namespace tautline::bench
