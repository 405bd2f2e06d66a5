#pragma once

#include <map>
#include <string>

#include "bench/gate/limits.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The precision of the engine of a run, as the patterns of a limits file ask for it.
class Precisions {
 public:
  explicit Precisions(const Report& report);
  /// "" of an engine that the report does not list, or says nothing of.
  [[nodiscard]] std::string of(const RunKey& run) const;

 private:
  std::map<std::string, std::string> by_name_;
};

/// Holds every run of `report` against `limits`: each gets a verdict, the report their source. A
/// run that shows a finding of the audit never passes: at best the finding is known.
void add_verdicts(Report& report, const Limits& limits);

}  // namespace tautline::bench
