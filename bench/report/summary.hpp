#pragma once

#include <vector>

#include "bench/report/report.hpp"

namespace tautline::bench {

// What the rows of a report come to over the cases.

/// By engine, model and step: every metric as the list says how it aggregates.
[[nodiscard]] std::vector<SummaryRow> summary(const std::vector<RunRow>& runs);

/// By engine and model: the slope of log error over log step of the early position error, a slope
/// for each case; cases at rounding throughout are counted apart. Of the report it takes the runs,
/// the precision of the engines and the extent of the cases.
[[nodiscard]] std::vector<ConvergenceRow> convergence(const Report& report);

/// By engine, model and step: what deviations come from.
[[nodiscard]] std::vector<CausesRow> causes_of(const std::vector<RunRow>& runs);

/// By engine, model and step: what a step and a simulated second cost.
[[nodiscard]] std::vector<CostRow> costs(const std::vector<TimingRow>& timing);

}  // namespace tautline::bench
