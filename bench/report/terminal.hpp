#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The answers for a terminal: the table over all cases with as many columns as fit, what its words
/// mean, and the failures. Drawn from `report` alone.
[[nodiscard]] std::string report_summary(const Report& report, const TerminalStyle& style);

}  // namespace tautline::bench
