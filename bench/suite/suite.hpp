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

}  // namespace tautline::bench
