#pragma once

#include <optional>
#include <vector>

#include "bench/measure/reference.hpp"
#include "bench/report/report.hpp"
#include "bench/suite/plan.hpp"
#include "bench/suite/suite.hpp"

namespace tautline::bench {

/// The report of a suite, without verdicts. `certified` has an entry for each of `references`. Of
/// `context`, the command, the times and the memory are the caller's to tell; what the suite and
/// this build know is filled in.
[[nodiscard]] Report report_of(const SuiteOptions& options,
                               const std::vector<ReferenceCase>& references,
                               const std::vector<std::optional<CertifiedDigits>>& certified,
                               const SuiteResult& result, Context context);

}  // namespace tautline::bench
