#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/gate/limits.hpp"
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
  std::optional<long long> draws;   // those of the suite, or 0, if not given
  std::optional<bool> certify;      // yes of a suite, no of cases, if not given
  double time_limit = 60.0;         // [s]
  std::optional<std::string> gate;  // limits file; breaking it makes the exit code 1
  std::string json;
  std::string command_line;  // as it was typed, for the report
};

/// Adds the options of `tautline bench` to `command`. `asked` must outlive it.
void add_bench_options(CLI::App& command, BenchCommand& asked);

/// What the command line asks for, or every sentence of what is wrong with it.
struct Request {
  const Suite* suite = nullptr;  // null where cases are named
  SuiteOptions options;
  Limits limits;  // of --gate, or those that ship
  std::vector<std::string> problems;
};
[[nodiscard]] Request read_request(const BenchCommand& command);

/// The same but for the engines, their models and the limits, which it leaves out.
[[nodiscard]] Request read_runs(const BenchCommand& command);

/// The limits of the file that --gate names, or those that ship. The file's mistakes are appended
/// to `problems`, and names in it that are neither of `options`, nor shipped, nor of a plug-in
/// here.
[[nodiscard]] Limits limits_of(const std::optional<std::string>& gate, const SuiteOptions& options,
                               std::vector<std::string>& problems);

/// What --gate is for.
inline constexpr const char* gate_help =
    "a limits file (TOML): print the runs that break a limit, and end with exit code 1";

}  // namespace tautline::bench
