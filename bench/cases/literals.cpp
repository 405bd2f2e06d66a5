#include "bench/cases/literals.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <filesystem>
#include <vector>

#include "bench/base/input_file.hpp"
#include "bench/base/problems.hpp"
#include "bench/base/toml.hpp"
#include "bench/base/value.hpp"
#include "tautline/case_file.hpp"

namespace tautline::bench {
namespace {

/// Walks a file's tables for its numbers, whose digits the parser has forgotten but not their
/// place.
class NumberSearch {
 public:
  explicit NumberSearch(std::string_view text) {
    for (std::size_t start = 0; start <= text.size();) {
      const std::size_t end = std::min(text.find('\n', start), text.size());
      lines_.push_back(text.substr(start, end - start));
      start = end + 1;
    }
  }

  void visit(const toml::node& node, const std::string& name) {
    if (const toml::table* const table = node.as_table()) {
      for (const auto& [key, value] : *table) {
        visit(value, name.empty() ? std::string(key.str()) : fmt::format("{}.{}", name, key.str()));
      }
    } else if (const toml::array* const array = node.as_array()) {
      for (std::size_t index = 0; index < array->size(); ++index) {
        visit((*array)[index], fmt::format("{}[{}]", name, index));
      }
    } else if (as_number(node)) {
      add(node.source().begin, name);
    }
  }

  [[nodiscard]] Literals found() && { return std::move(found_); }

 private:
  void add(const toml::source_position& place, const std::string& name) {
    if (place.line == 0 || place.line > lines_.size()) {
      return;
    }
    const std::string_view line = lines_[place.line - 1];
    std::size_t at = 0;
    for (std::size_t column = 1; column < place.column && at < line.size(); ++column) {
      do {  // a column is a code point
        ++at;
      } while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xC0U) == 0x80U);
    }
    std::string number(line.substr(at, line.find_first_of(" \t\r,]}#", at) - at));
    number.erase(std::remove(number.begin(), number.end(), '_'), number.end());
    if (number.starts_with('+')) {
      number.erase(0, 1);
    }
    if (!number.empty() && number.find_first_not_of("0123456789.eE+-") == std::string::npos) {
      found_.emplace(name, std::move(number));
    }
  }

  std::vector<std::string_view> lines_;
  Literals found_;
};

}  // namespace

Literals literals(std::string_view text) {
  FileProblems wrong("");
  const auto file = parse_toml(text, wrong);
  NumberSearch search(text);
  if (file) {
    search.visit(*file, "");
  }
  return std::move(search).found();
}

Literals literals_of(const std::string& argument) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(argument, failure)) {
    return {};
  }
  const InputFile file = read_input_file(argument, longest_case_file);
  return file.problem ? Literals{} : literals(file.content);
}

}  // namespace tautline::bench
