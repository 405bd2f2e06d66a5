#include "bench/chapter/output.hpp"

#include <fmt/format.h>

#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// `text` as one field, in quotes where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return result + "\"";
}

std::string field(const ChapterCell& cell) {
  if (const auto* const words = std::get_if<std::string>(&cell)) {
    return field(*words);
  }
  if (const auto* const number = std::get_if<double>(&cell)) {
    return shortest(*number);
  }
  const auto* const whole = std::get_if<long>(&cell);
  return whole != nullptr ? std::to_string(*whole) : "";
}

}  // namespace

std::string table_csv(const ChapterTable& table) {
  std::string csv;
  for (const auto& [name, unit, format] : table.columns) {
    csv += (csv.empty() ? "" : ",") + field(unit.empty() ? name : name + " [" + unit + "]");
  }
  csv += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t index = 0; index < row.size(); ++index) {
      csv += (index == 0 ? "" : ",") + field(row[index]);
    }
    csv += '\n';
  }
  return csv;
}

std::string data_csv(const FigureData& data) {
  std::string csv = fmt::format("{}\n", fmt::join(data.columns, ","));
  for (const auto& [numbers, words] : data.rows) {
    csv += fmt::format("{:.12g}", fmt::join(numbers, ","));
    for (const std::string_view word : words) {
      csv += ',';
      csv += word;
    }
    csv += '\n';
  }
  return csv;
}

std::string corrections_csv(const std::vector<Correction>& corrections) {
  std::string csv = "where,holds,chapter,right,shown\n";
  for (const Correction& one : corrections) {
    csv += fmt::format("{},{},{},{},{}\n", field(one.where), one.holds ? "yes" : "no",
                       field(one.chapter), field(one.right), field(one.shown));
  }
  return csv;
}

}  // namespace tautline::bench
