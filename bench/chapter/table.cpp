#include "bench/chapter/table.hpp"

#include <fmt/format.h>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

std::string csv_cell(const ordered_json& cell) {
  if (cell.is_null()) {
    return "";
  }
  if (cell.is_string()) {
    return csv_field(cell.get<std::string>());
  }
  return cell.is_number_float() ? shortest(cell.get<double>()) : cell.dump();
}

std::string markdown_cell(const ordered_json& cell, const std::string& format) {
  if (cell.is_null()) {
    return "–";
  }
  if (cell.is_string()) {
    return cell.get<std::string>();
  }
  return cell.is_number_float() ? fmt::format(fmt::runtime(format), cell.get<double>())
                                : cell.dump();
}

}  // namespace

std::string heading(const std::string& name, const std::string& unit) {
  return unit.empty() ? name : name + " [" + unit + "]";
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) {
    return text;
  }
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  }
  return result + "\"";
}

std::string table_csv(const ChapterTable& table) {
  std::string csv;
  for (const Column& column : table.columns) {
    csv += (csv.empty() ? "" : ",") + csv_field(heading(column.name, column.unit));
  }
  csv += '\n';
  for (const auto& row : table.rows) {
    for (std::size_t index = 0; index < row.size(); ++index) {
      csv += (index == 0 ? "" : ",") + csv_cell(row[index]);
    }
    csv += '\n';
  }
  return csv;
}

std::string table_markdown(const ChapterTable& table) {
  std::vector<std::string> headings;
  for (const Column& column : table.columns) {
    headings.push_back(column.name);
  }
  Table text(headings, table.left);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (std::size_t index = 0; index < row.size(); ++index) {
      cells.push_back(markdown_cell(row[index], table.columns[index].format));
    }
    text.add(cells);
  }
  return text.markdown();
}

ordered_json table_json(const ChapterTable& table) {
  ordered_json columns = ordered_json::array();
  for (const Column& column : table.columns) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}});
  }
  return {{"name", table.name}, {"title", table.title}, {"file", table.file},
          {"columns", columns}, {"rows", table.rows},   {"notes", table.notes}};
}

}  // namespace tautline::bench
