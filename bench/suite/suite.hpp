#pragma once

#include <functional>
#include <vector>

#include "bench/judge/allowance.hpp"
#include "bench/store/plan.hpp"

namespace tautline::bench {

/// Told of each run that ended, from one thread at a time; `kept` if it had been done before.
using SuiteProgress = std::function<void(const PlannedRun& run, bool kept)>;

/// Runs what `options.shard` has of the suite, `options.jobs` at a time. Throws FileError if a
/// result cannot be written: runs that ended before are whole on disk, and `resume` goes on from
/// them.
[[nodiscard]] SuiteResult run_suite(const SuiteOptions& options, const Expectations& expectations,
                                    const SuiteProgress& progress);

}  // namespace tautline::bench
