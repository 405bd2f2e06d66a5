#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace tautline::bench {

/// What is wrong with one file, in sentences that start with `file:line: `.
class FileProblems {
 public:
  explicit FileProblems(const std::string& source_name);

  /// `line` counts from 1; 0 where no line can be named. What was added before is not added again.
  void add(std::size_t line, const std::string& sentence);
  [[nodiscard]] bool empty() const { return found_.empty(); }

  /// In the order of their lines. A file with very many is not read to the end by anyone: the last
  /// sentence then says how many more there are.
  [[nodiscard]] std::vector<std::string> sentences() const;

 private:
  std::string source_;
  std::vector<std::pair<std::size_t, std::string>> found_;
};

}  // namespace tautline::bench
