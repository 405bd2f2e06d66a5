#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/report/record.hpp"
#include "bench/suite/plan.hpp"

namespace tautline::bench {

struct SuiteResult {
  std::vector<RunRecord> runs;  // those that finished, in the order of `plan`
  std::size_t planned = 0;      // of the whole suite
  std::size_t due = 0;          // of `planned`, those of the shard
  std::size_t kept = 0;         // of `runs`, taken from an earlier invocation
  bool interrupted = false;
};

/// Told of each run that ended, from one thread at a time; `kept` if it had been done before.
using SuiteProgress = std::function<void(const PlannedRun& run, bool kept)>;

/// Runs what `options.shard` has of the suite, `options.jobs` at a time. Throws FileError if a
/// result cannot be written: runs that ended before are whole on disk, and `resume` goes on from
/// them.
[[nodiscard]] SuiteResult run_suite(const SuiteOptions& options,
                                    const std::vector<ReferenceCase>& references,
                                    const SuiteProgress& progress);

}  // namespace tautline::bench
