#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The one run of `report` for a terminal: what ran, its verdict, the metrics that matter with
/// value, limit and unit, or all of them, and what was found.
[[nodiscard]] std::string run_card(const Report& report, bool all_metrics,
                                   const TerminalStyle& style);

}  // namespace tautline::bench
