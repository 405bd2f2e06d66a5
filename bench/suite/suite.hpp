#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/measure/compare.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/worker.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// What is run: every case on every engine, with every model and step.
struct SuiteOptions {
  std::vector<Case> cases;
  std::vector<RegisteredEngine> engines;
  std::vector<std::string> models;  // of those; empty means all
  std::vector<double> steps;        // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
  std::filesystem::path out;  // a result tree from `open_tree`; empty writes nothing
  unsigned jobs = 1;          // worker processes at a time
  bool resume = false;        // keep runs that `out` already has
  std::size_t samples = 500;  // rows of a trajectory.csv, next to those at impacts
  WorkerLimits limits;
  CompareOptions compare;
};

/// A case with everything the comparison needs of its exact solution.
struct ReferenceCase {
  Case the_case;
  Solution solution;
  Settling settling;
  double horizon;  // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
};

/// The exact side of every case.
[[nodiscard]] std::vector<ReferenceCase> solve_cases(const std::vector<Case>& cases, ImpactLaw law);

/// One run of the suite.
struct PlannedRun {
  std::size_t the_case;  // index into SuiteOptions::cases
  std::size_t engine;    // index into SuiteOptions::engines
  Model model;
  double step;                   // [s]
  std::size_t path_samples = 0;  // that the report has of it, next to those at impacts
};

/// Every run, in the order in which the report lists them.
[[nodiscard]] std::vector<PlannedRun> plan(const SuiteOptions& options);

/// What a run left: the row of the report, and apart from it what differs from machine to machine.
struct RunResult {
  nlohmann::ordered_json row;     // a "run" of bench/report/report.schema.json
  nlohmann::ordered_json timing;  // its "timing" entry, or null if nothing was measured
};

struct SuiteResult {
  std::vector<RunResult> runs;  // those that finished, in the order of `plan`
  std::size_t planned = 0;
  std::size_t kept = 0;  // of `runs`, taken from an earlier invocation
  bool interrupted = false;
};

/// Runs the suite, `options.jobs` at a time. `progress` is called with the number of runs that
/// ended, from one thread at a time. Throws FileError if a result cannot be written: runs that
/// ended before are whole on disk, and `resume` goes on from them.
[[nodiscard]] SuiteResult run_suite(const SuiteOptions& options,
                                    const std::vector<ReferenceCase>& references,
                                    const std::function<void(std::size_t)>& progress);

/// Sentences that say why `options` cannot run: no steps, a step that is not above 0 or needs more
/// than `most_steps` for a case, an output folder that holds something else.
[[nodiscard]] std::vector<std::string> suite_problems(const SuiteOptions& options);

/// More worker processes than this at a time are refused.
inline constexpr unsigned most_jobs = 256;

/// More steps than this in one run are refused: at a microsecond each they take 15 minutes.
inline constexpr double most_steps = 1e9;

}  // namespace tautline::bench
