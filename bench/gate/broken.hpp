#pragma once

#include <string>
#include <vector>

#include "bench/gate/limits.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// A row that breaks the gate, as it is printed.
struct BrokenRow {
  std::string engine;
  std::string model;
  std::string the_case;  // or empty: all
  std::string step;      // [s], or empty: all
  std::string metric;
  std::string value;  // with its unit; "failed" and the like without a number
  std::string limit;
  std::string reason;
};

/// What breaks the gate, for a report with verdicts: limits that do not hold and are not known to,
/// findings that are not known, runs and engines that failed, known deviations of which no run of
/// the report shows any or which no limit is on, limits that could be measured on no run; and a
/// gate that judges no run at all.
[[nodiscard]] std::vector<BrokenRow> broken_rows(const Report& report, const Limits& limits);

}  // namespace tautline::bench
