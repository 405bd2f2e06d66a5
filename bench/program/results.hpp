#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "bench/base/descriptor.hpp"
#include "bench/gate/listed_problems.hpp"
#include "bench/program/request.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/report.hpp"
#include "bench/store/manifest.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// A suite that was run, and its report with verdicts, which is not written yet.
struct RunSuite {
  Descriptor tree;  // the result tree is this program's alone until it is gone
  Manifest manifest;
  SuiteResult result;
  Report report;
  Replay replay;  // of the report
};

/// Runs what `request`, which has no problems, asks for, and shows how far it is. `command_line` is
/// what was typed. From here on an interruption ends the runs, not the program.
[[nodiscard]] RunSuite run_request(const Request& request, const std::string& command_line);

/// Where a report goes, and what it is compared with.
struct ResultsTarget {
  std::filesystem::path out;        // the result tree
  std::string json;                 // a file as well, or "-" for standard output; empty: neither
  std::optional<std::string> gate;  // a list of problems, to which others are new
  ListedProblems listed;            // of it, or those that ship
  bool all = false;                 // print every number, not sentences alone
};

/// Writes `report`, which has its verdicts, and its `replay`: report.json, report.md, index.html
/// with its motions, summary.md and a card for each engine.
void write_results(const ResultsTarget& target, const Report& report, const Replay& replay);

/// Prints the summary of `report`, and `last`, which says what was done, before the place where all
/// of it is; nothing where standard output has the JSON.
void print_results(const ResultsTarget& target, const Report& report, const std::string& last);

/// The exit code of a report that is whole: prints what breaks the gate if there is one; without
/// one, a run or an engine that failed counts.
[[nodiscard]] int judged(const ResultsTarget& target, const Report& report);

}  // namespace tautline::bench
