#include "tests/bench/reproduce/reproduced.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace tautline::test {
namespace {

using nlohmann::json;

std::vector<std::string> split(const std::string& line) {
  std::istringstream cells(line + ",");
  std::vector<std::string> result;
  for (std::string cell; std::getline(cells, cell, ',');) {
    result.push_back(cell);
  }
  return result;
}

/// One run of the program and its folder.
struct Run {
  Run() {
    const Outcome outcome = program({"reproduce", "--out", out().string()});
    if (outcome.code != 0) {
      throw std::runtime_error(outcome.errors);
    }
    chapter = json::parse(content_of(out() / "chapter.json"));
  }

  [[nodiscard]] std::filesystem::path out() const { return folder.path() / "r"; }

  TemporaryFolder folder;
  json chapter;
};

const Run& run() {
  static const Run once;
  return once;
}

}  // namespace

Csv::Csv(const std::filesystem::path& path) {
  std::istringstream text(content_of(path));
  std::string line;
  std::getline(text, line);
  headings = split(line);
  while (std::getline(text, line)) {
    rows.push_back(split(line));
  }
}

std::size_t Csv::column(const std::string& heading) const {
  const auto found = std::find(headings.begin(), headings.end(), heading);
  EXPECT_NE(found, headings.end()) << heading;
  return static_cast<std::size_t>(found - headings.begin());
}

double Csv::number(std::size_t row, const std::string& heading) const {
  return std::stod(rows.at(row).at(column(heading)));
}

std::filesystem::path Reproduced::out() { return run().out(); }

const json& Reproduced::chapter() { return run().chapter; }

const json& Reproduced::entry(const char* list, const char* key, const std::string& value) {
  for (const json& one : chapter().at(list)) {
    if (one.at(key) == value) {
      return one;
    }
  }
  throw std::out_of_range("no " + value + " among the " + list);
}

Csv Reproduced::data(const std::string& figure) {
  return Csv(out() / "chapter" / entry("figures", "name", figure).at("file").get<std::string>());
}

json Reproduced::cell(const std::string& table, const std::vector<std::string>& keys,
                      const std::string& heading) {
  const json& found = entry("tables", "name", table);
  std::size_t column = 0;
  while (found.at("columns").at(column).at("name") != heading) {
    ++column;
  }
  for (const json& row : found.at("rows")) {
    bool same = true;
    for (std::size_t index = 0; index < keys.size(); ++index) {
      same = same && row.at(index) == keys[index];
    }
    if (same) {
      return row.at(column);
    }
  }
  throw std::out_of_range("no such row in " + table);
}

}  // namespace tautline::test
