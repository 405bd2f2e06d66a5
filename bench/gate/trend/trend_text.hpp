#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/gate/trend/trend.hpp"

namespace tautline::bench {

/// A trend for a terminal: what moves from report to report, or `all`; a table for every engine,
/// model and step.
[[nodiscard]] std::string trend_text(const Trend& trend, bool all, const TerminalStyle& style);

}  // namespace tautline::bench
