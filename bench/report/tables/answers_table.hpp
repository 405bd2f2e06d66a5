#pragma once

#include "bench/base/table.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The answers over all cases, by engine, model and step: every metric of the list that is shown
/// there, impacts, settling, cost, failures and, in a report with verdicts, what they come to. Last
/// come the engines that are not here, and why.
[[nodiscard]] Table answers_table(const Report& report);

}  // namespace tautline::bench
