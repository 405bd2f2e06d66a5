#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/gate/limits.hpp"

namespace tautline::bench {

/// The precision of the engine of a run, as the patterns of a manifest ask for it.
class Precisions {
 public:
  explicit Precisions(const nlohmann::ordered_json& report);
  /// "" of an engine the report does not list.
  [[nodiscard]] std::string of(const nlohmann::ordered_json& run) const;

 private:
  std::map<std::string, std::string> by_name_;
};

/// A row that breaks the gate.
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

/// Holds every run of `report` against `limits`: each gets a "verdict", the report "limits"
/// (bench/report/report.schema.json). Draws on the report alone. The words:
///   pass                every limit on the run holds;
///   deviation-flagged   a limit does not hold, or the run failed or diverged;
///   informative         no limit on it, or the manifest says so;
///   unsupported         the run stopped because the model goes no further, or the manifest says
///   so.
void add_verdicts(nlohmann::ordered_json& report, const Limits& limits);

/// What breaks the gate, for a report with verdicts: limits that do not hold and are not known to,
/// runs and engines that failed, known deviations of which no run of the report shows any or which
/// no limit is on; and a gate that judges no run at all.
[[nodiscard]] std::vector<BrokenRow> broken_rows(const nlohmann::ordered_json& report,
                                                 const Limits& limits);

/// The rows as a table for a terminal and a last line that says whether the gate holds.
[[nodiscard]] std::string gate_text(const nlohmann::ordered_json& report, const Limits& limits,
                                    const std::vector<BrokenRow>& rows);

}  // namespace tautline::bench
