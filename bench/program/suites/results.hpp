#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/gate/limits.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// Where a report goes, and what it is held against.
struct ResultsTarget {
  std::filesystem::path out;        // the result tree
  std::string json;                 // a file as well, or "-" for standard output; empty: neither
  std::optional<std::string> gate;  // a limits file that may be broken
  Limits limits;                    // of it, or those that ship
};

/// Writes `report`, which has its verdicts: report.json, report.md, index.html with its motions,
/// summary.md and a card for each engine.
void write_results(const ResultsTarget& target, const Report& report);

/// Prints the summary of `report`, and `last`, which says what was done, before the place where all
/// of it is; nothing where standard output has the JSON.
void print_results(const ResultsTarget& target, const Report& report, const std::string& last);

/// The exit code of a report that is whole: prints what breaks the gate if there is one; without
/// one, a run or an engine that failed counts.
[[nodiscard]] int judged(const ResultsTarget& target, const Report& report);

/// The instant that it is, ISO 8601, UTC.
[[nodiscard]] std::string now_utc();

}  // namespace tautline::bench
