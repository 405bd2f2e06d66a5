#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/bench/program.hpp"

namespace tautline::test {

/// A CSV file by columns; cells that are no number are nan.
struct Csv {
  explicit Csv(const std::filesystem::path& path);

  [[nodiscard]] std::size_t column(const std::string& heading) const;
  [[nodiscard]] double number(std::size_t row, const std::string& heading) const;

  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;
};

/// What `tautline reproduce` wrote, once for all tests: it takes a while.
class Reproduced : public testing::Test {
 protected:
  static std::filesystem::path out();
  static const nlohmann::json& chapter();

  /// The one of `list` whose `key` is `value`.
  static const nlohmann::json& entry(const char* list, const char* key, const std::string& value);

  static Csv data(const std::string& figure);

  /// The cell of a table's row whose first cells are `keys`.
  static nlohmann::json cell(const std::string& table, const std::vector<std::string>& keys,
                             const std::string& heading);
};

}  // namespace tautline::test
