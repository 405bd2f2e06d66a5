#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/gate/listed_problems.hpp"
#include "bench/store/plan.hpp"
#include "bench/suite/suites.hpp"

namespace CLI {
class App;
}

namespace tautline::bench {

/// What `tautline bench` was asked.
struct BenchCommand {
  std::vector<std::string> cases;    // none: those of a suite
  std::optional<std::string> suite;  // its name; none: the first, unless there are cases
  std::vector<std::string> engines;
  std::vector<std::string> models;
  std::vector<double> steps;    // [s]; none: those of the suite
  std::optional<double> until;  // [s], instead of each case's duration
  ImpactLaw law = ImpactLaw::simultaneous;
  std::filesystem::path out = "results";
  std::optional<unsigned> jobs;      // one per core if not given
  std::optional<std::string> shard;  // "3/16"
  bool resume = false;
  std::optional<long long> draws;     // those of the suite, or 0, if not given
  std::optional<bool> certify;        // yes of a suite, no of cases, if not given
  double time_limit = 60.0;           // [s]
  std::optional<std::string> gate;    // whose problems are listed; others make the exit code 1
  std::string list_problems;          // a file to write the problems to; empty: none
  std::optional<std::string> within;  // "1%": search the largest steps that hold it
  bool all = false;                   // print every number, not sentences alone
  std::string json;
  std::string playground;    // where the live page is, for links of the report; empty: nowhere
  std::string command_line;  // as it was typed, for the report
};

/// Adds the options of `tautline bench` to `command`. `asked` must outlive it.
void add_bench_options(CLI::App& command, BenchCommand& asked);

/// What the command line asks for, or every sentence of what is wrong with it.
struct Request {
  const Suite* suite = nullptr;  // null where cases are named
  SuiteOptions options;
  ListedProblems listed;         // of --gate, or those that ship
  ListedProblems listed_before;  // of the file that --list-problems names, if it is there
  std::optional<double> within;  // [-], of the shortest cable; none: a suite is run
  std::vector<std::string> problems;
};
[[nodiscard]] Request read_request(const BenchCommand& command);

/// The same but for the engines, their models and the listed problems, which it leaves out.
[[nodiscard]] Request read_runs(const BenchCommand& command);

/// The problems of the file that --gate names, none, or those that ship. The file's mistakes are
/// appended to `problems`, and names in it that are neither of `options`, nor shipped, nor of a
/// plug-in here.
[[nodiscard]] ListedProblems listed_by(const std::optional<std::string>& gate,
                                       const SuiteOptions& options,
                                       std::vector<std::string>& problems);

/// What --gate is for.
inline constexpr const char* gate_help =
    "print the problems that are not listed, and end with exit code 1 if there are some; listed "
    "are "
    "those of a FILE that --list-problems has written, those that are `shipped`, or `none`";

}  // namespace tautline::bench
