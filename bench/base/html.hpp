#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bench/base/text.hpp"

namespace tautline::bench {

// What the report page is made of. No text reaches the page but through these.

/// `text` as the content of an element or of an attribute in quotes: on one line, cut after
/// `longest` bytes, with what HTML, a terminal or an editor would read as its own made harmless.
[[nodiscard]] std::string html_text(std::string_view text, std::size_t longest = quotable_length);

/// The same of a text with **strong**, *stressed* and `code` words, as our Markdown has them.
[[nodiscard]] std::string html_prose(std::string_view text);

/// `json` as the content of a script element: a script cannot end inside it.
[[nodiscard]] std::string html_json(const nlohmann::ordered_json& json);

// Cells of a table.

/// Words, set to the left.
[[nodiscard]] std::string word_cell(std::string_view text, std::size_t longest = quotable_length);

/// The name of a row.
[[nodiscard]] std::string row_heading(std::string_view text);

/// A number, set to the right, as `shown`; in full in the attribute data-value. A dash for null.
[[nodiscard]] std::string number_cell(const nlohmann::ordered_json& value, std::string_view shown);

/// Two digits, which is what an error is good for.
[[nodiscard]] std::string error_cell(const nlohmann::ordered_json& value);

/// So many digits after the point.
[[nodiscard]] std::string fixed_cell(const nlohmann::ordered_json& value, int digits);

/// As short as it reads back: counts and steps.
[[nodiscard]] std::string plain_cell(const nlohmann::ordered_json& value);

/// A column of a table.
struct HtmlColumn {
  std::string
      key;  // by which the page's script and its address know it; "" where it cannot be sorted
  std::string heading;  //
  std::string unit;     // or empty
  std::string group;    // heading above neighbours that share it, or empty
  bool numbers = true;  // set to the right
};

/// A table in its own box, which scrolls where the page is narrower.
class HtmlTable {
 public:
  HtmlTable(std::string id, std::string caption, std::vector<HtmlColumn> columns);

  /// Rows added from here on stand in a body of this class, "" for none. A body without rows is
  /// left out.
  void begin_body(const std::string& name);

  /// One cell per column, made by the functions above. `attributes` of the row, or empty.
  void add(const std::vector<std::string>& cells, const std::string& attributes = "");

  [[nodiscard]] bool empty() const { return rows_ == 0; }
  [[nodiscard]] std::string html() const;

 private:
  [[nodiscard]] std::string head() const;

  std::string id_;
  std::string caption_;
  std::vector<HtmlColumn> columns_;
  std::string bodies_;
  std::string body_;  // class of the body that the next row is in
  bool open_ = false;
  std::size_t rows_ = 0;
};

}  // namespace tautline::bench
