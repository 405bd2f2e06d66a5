#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bench/cases/bench_case.hpp"
#include "bench/measure/compare.hpp"
#include "bench/report/record.hpp"
#include "bench/run/registry.hpp"
#include "bench/run/worker.hpp"
#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/impact.hpp"

namespace tautline::bench {

/// One of the parts into which the runs of a suite are dealt out, for a machine each.
struct Shard {
  std::size_t number = 1;  // from 1 to `of`
  std::size_t of = 1;

  auto operator<=>(const Shard&) const = default;  // NOLINT(modernize-use-nullptr): it has none
};

/// What is run: every case on every engine, with every model and step.
struct SuiteOptions {
  std::vector<BenchCase> cases;
  std::vector<RegisteredEngine> engines;
  std::vector<std::string> models;  // of those; empty means all
  std::vector<double> steps;        // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
  std::filesystem::path out;  // a result tree from `open_tree`; empty writes nothing
  unsigned jobs = 1;          // worker processes at a time
  Shard shard;                // of the runs, that are done here
  bool resume = false;        // keep runs that `out` already has
  std::size_t samples = 500;  // rows of a trajectory.csv, next to those at impacts
  WorkerLimits limits;
  CompareOptions compare;
  std::size_t draws = 0;  // of the standard case, compared as distributions
  bool certify = false;   // hold the exact solution of each case against many digits
  /// A hash of each engine's plug-in, where the files are not here; empty: where they are.
  std::vector<std::uint64_t> plugins;
};

/// One run of the suite.
struct PlannedRun {
  std::size_t the_case;  // index into SuiteOptions::cases
  std::size_t engine;    // index into SuiteOptions::engines
  Model model;
  double step;  // [s]
};
[[nodiscard]] RunKey key_of(const SuiteOptions& options, const PlannedRun& run);

/// True where `model` can run a case of this kind.
[[nodiscard]] bool runs(const Model& model, const BenchCase& any);

/// Every run, in the order in which the report lists them. A model that cannot run systems is left
/// out where the case is a system, unless it is named.
[[nodiscard]] std::vector<PlannedRun> plan(const SuiteOptions& options);

/// What the runs of a suite left.
struct SuiteResult {
  std::vector<RunRecord> runs;  // those that finished, in the order of `plan`
  std::size_t planned = 0;      // of the whole suite
  std::size_t due = 0;          // of `planned`, those of the shard
  std::size_t kept = 0;         // of `runs`, taken from an earlier invocation
  bool interrupted = false;
};

/// Sentences that say why `options` cannot run: no steps, a step that is not above 0 or needs more
/// than `most_steps` for a case, an output folder that holds something else.
[[nodiscard]] std::vector<std::string> suite_problems(const SuiteOptions& options);

/// Of a command line that is quoted in a report [bytes].
inline constexpr std::size_t longest_command = 1000;

/// More worker processes than this at a time are refused.
inline constexpr unsigned most_jobs = 256;

}  // namespace tautline::bench
