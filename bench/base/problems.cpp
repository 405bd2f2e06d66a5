#include "bench/base/problems.hpp"

#include <algorithm>

#include "bench/base/text.hpp"

namespace tautline::bench {

FileProblems::FileProblems(const std::string& source_name) {
  constexpr std::size_t longest_path = 1024;
  source_ = source_name.empty() ? "\"\"" : printable(source_name, longest_path);
}

void FileProblems::add(std::size_t line, const std::string& sentence) {
  std::pair found(line, source_ + (line > 0 ? ":" + std::to_string(line) : "") + ": " + sentence);
  if (std::find(found_.begin(), found_.end(), found) == found_.end()) {
    found_.push_back(std::move(found));
  }
}

std::vector<std::string> FileProblems::sentences() const {
  constexpr std::size_t enough = 100;
  auto sorted = found_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& one, const auto& two) { return one.first < two.first; });
  std::vector<std::string> result;
  for (const auto& [line, sentence] : sorted) {
    if (result.size() == enough) {
      result.push_back(source_ + ": and " + std::to_string(sorted.size() - enough) +
                       " more problems");
      break;
    }
    result.push_back(sentence);
  }
  return result;
}

}  // namespace tautline::bench
