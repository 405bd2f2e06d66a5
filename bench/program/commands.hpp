#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {

/// Exit codes of the program.
inline constexpr int exit_done = 0;
inline constexpr int exit_failed = 1;  // a run failed or diverged, or a result could not be written
inline constexpr int exit_usage = 2;   // wrong usage or input

/// What `tautline solve` was asked.
struct SolveCommand {
  std::string the_case;
  std::optional<double> until;        // [s], instead of the case's duration
  std::vector<double> at;             // [s], times of samples
  std::optional<double> angle_limit;  // [rad], instead of the case's
  std::optional<double> ceiling;      // [m], instead of the case's
  ImpactLaw law = ImpactLaw::simultaneous;
  bool certify = false;       // also solve with more digits, and compare
  std::optional<int> digits;  // of that; `default_digits` if not given
  std::string json;           // file, "-" for standard output, or empty
  std::string plot;           // the same, for a picture (SVG)
};
[[nodiscard]] int solve_command(const SolveCommand& command);

/// What `tautline run` was asked.
struct RunCommand {
  std::string the_case;
  std::string engine;
  std::string model;
  double step = 1e-3;  // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
  double time_limit = 60.0;
  std::string json;
  std::filesystem::path out;  // folder for the run's files, or empty
};
[[nodiscard]] int run_command(const RunCommand& command);

/// What `tautline bench` was asked.
struct BenchCommand {
  std::vector<std::string> cases;
  std::vector<std::string> engines;
  std::vector<std::string> models;
  std::vector<double> steps = {1e-2, 1e-3, 1e-4};  // [s]
  std::optional<double> until;                     // [s], instead of each case's duration
  ImpactLaw law = ImpactLaw::simultaneous;
  std::filesystem::path out = "results";
  std::optional<unsigned> jobs;  // one per core if not given
  bool resume = false;
  double time_limit = 60.0;         // [s]
  std::optional<std::string> gate;  // limits file; breaking it makes the exit code 1
  std::string json;
  std::string command_line;  // as it was typed, for the report
};
[[nodiscard]] int bench_command(const BenchCommand& command);

/// What `tautline compare` was asked.
struct CompareCommand {
  std::string before;  // report.json
  std::string after;
  std::string json;
};
[[nodiscard]] int compare_command(const CompareCommand& command);

/// What `tautline check` was asked.
struct CheckCommand {
  std::string engine;
  std::string model;  // or empty: all
  std::string json;
  double time_limit = 60.0;  // [s], for each model
};
[[nodiscard]] int check_command(const CheckCommand& command);

/// What `tautline reproduce` was asked.
struct ReproduceCommand {
  std::filesystem::path out = "results";
  std::string json;
};
[[nodiscard]] int reproduce_command(const ReproduceCommand& command);

/// What `tautline engines` was asked.
struct EnginesCommand {
  std::string json;
};
[[nodiscard]] int engines_command(const EnginesCommand& command);

/// What `tautline cases` was asked: the list of shipped cases, or one of them as a case file.
struct CasesCommand {
  std::string the_case;
};
[[nodiscard]] int cases_command(const CasesCommand& command);

/// The one case that `argument` means; none, after complaining, if that is not one.
[[nodiscard]] std::optional<Case> one_case(const std::string& argument);

/// Prints each sentence to standard error as "tautline: ...".
void complain(const std::vector<std::string>& sentences);

/// Writes `text` to the file `target`, or to standard output for "-".
void write_output(const std::string& target, const std::string& text);

}  // namespace tautline::bench
