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

/// The rows that break the gate as a table for a terminal, and a last line that says whether it
/// holds.
[[nodiscard]] std::string gate_text(const Report& report, const ListedProblems& listed,
                                    const std::vector<BrokenRow>& rows);

/// A problems file after the runs of `report`, which has verdicts. It has the entries of `before`
/// without those that are gone, and an entry for the engine, model and kind of each other problem,
/// with the reason that `known` has for it, or an empty one.
[[nodiscard]] std::string problems_file_of(const Report& report, const ListedProblems& before,
                                           const ListedProblems& known);

}  // namespace tautline::bench
