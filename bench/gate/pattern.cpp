#include "bench/gate/pattern.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <cmath>

namespace tautline::bench {
namespace {

/// Steps this near are the same: 0.001 from a file and from a command line [-].
constexpr double same_step = 1e-9;

bool matches_one(const std::string& pattern, const std::string& name) {
  std::string escaped;  // what else is special for fnmatch, escaped
  for (const char letter : pattern) {
    if (letter == '[' || letter == ']' || letter == '\\') {
      escaped += '\\';
    }
    escaped += letter;
  }
  return ::fnmatch(escaped.c_str(), name.c_str(), 0) == 0;
}

}  // namespace

std::vector<std::string> alternatives(const std::string& pattern) {
  std::vector<std::string> result(1);
  for (const char letter : pattern) {
    if (letter == '|') {
      result.emplace_back();
    } else {
      result.back() += letter;
    }
  }
  return result;
}

bool matches(const std::string& pattern, const std::string& name) {
  const std::vector<std::string> patterns = alternatives(pattern);
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& one) { return matches_one(one, name); });
}

bool RunPattern::holds(const RunKey& run) const {
  return matches(engine, run.engine) && matches(model, run.model) &&
         matches(the_case, run.the_case) &&
         (!step || std::abs(*step - run.step) <= same_step * run.step);
}

}  // namespace tautline::bench
