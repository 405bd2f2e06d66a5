#pragma once

#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/report/report.hpp"
#include "bench/suite/plan.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// The report of a suite, without verdicts. Of `context`, the command, the times and the memory are
/// the caller's to tell; what the suite and this build know is filled in.
[[nodiscard]] Report report_of(const SuiteOptions& options,
                               const std::vector<ReferenceCase>& references,
                               const SuiteResult& result, Context context);

}  // namespace tautline::bench
