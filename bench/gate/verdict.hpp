#pragma once

#include <map>
#include <string>

#include "bench/gate/listed_problems.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The precision of the engines of a report.
class Precisions {
 public:
  explicit Precisions(const Report& report);
  /// "" of an engine that the report does not list, or says nothing of.
  [[nodiscard]] std::string of(const RunKey& run) const;

 private:
  std::map<std::string, std::string> by_name_;
};

/// Gives every run of `report` its verdict: the problems that its judgement and the findings of the
/// audit are, and which of them are `listed`.
void add_verdicts(Report& report, const ListedProblems& listed);

/// True where the run could show a problem of this kind: it was measured.
[[nodiscard]] bool could_show(const RunRow& run, const std::string& kind);

}  // namespace tautline::bench
