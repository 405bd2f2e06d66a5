#pragma once

#include <string>
#include <vector>

#include "bench/gate/listed_problems.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// A row that breaks the gate, as it is printed.
struct BrokenRow {
  std::string engine;
  std::string model;
  std::string the_case;  // or empty: all
  std::string step;      // [s], or empty: all
  std::string kind;      // of problem
  std::string what;      // in a sentence
};

/// What breaks the gate, for a report with verdicts: problems that are not listed, engines that
/// failed, listed problems that runs of the report could show and none does, and a report none of
/// whose runs could be judged.
[[nodiscard]] std::vector<BrokenRow> broken_rows(const Report& report,
                                                 const ListedProblems& listed);

}  // namespace tautline::bench
