#pragma once

#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

/// The first events, or all, after an empty line; "" without one. Each number has right digits
/// alone; what is beyond the horizon is one row. An accumulation stands at its limit. Where there
/// is no room, their velocities go first, then their poses.
[[nodiscard]] std::string events_text(const Case& the_case, const Solution& solution,
                                      const Uncertainty& uncertainty, bool all,
                                      const TerminalStyle& style);

/// The state at each time with every right digit, likewise: a column for a time, as many beside
/// each other as fit.
[[nodiscard]] std::string samples_text(const Solution& solution, const Uncertainty& uncertainty,
                                       const std::vector<double>& times,
                                       const TerminalStyle& style);

}  // namespace tautline::bench
