#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// True where `name` is one that `pattern` means: * and ? are as for files, a | stands between
/// patterns of which any will do, and nothing else is special.
[[nodiscard]] bool matches(const std::string& pattern, const std::string& name);

/// The patterns between which `pattern` has a |.
[[nodiscard]] std::vector<std::string> alternatives(const std::string& pattern);

/// Which runs an entry of a problems file is about. Names are patterns as for files: * and ?.
struct RunPattern {
  std::string engine = "*";
  std::string model = "*";
  std::string the_case = "*";
  std::optional<double> step;  // [s]; any without one

  /// True where `run` is one of these.
  [[nodiscard]] bool holds(const RunKey& run) const;
};

}  // namespace tautline::bench
