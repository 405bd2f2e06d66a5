#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/terminal.hpp"
#include "bench/solution/certificate.hpp"
#include "tautline/case.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

/// How the motion ends, when it settled and what is left of it, in a few lines of plain words. Each
/// number has right digits alone, as `uncertainty` says, and what is beyond the horizon is named.
[[nodiscard]] std::string solution_text(const Case& the_case, const Solution& solution,
                                        const Settling& settling, const Uncertainty& uncertainty);

/// The least and the largest tension of each cable over a period, a line each; "" where the motion
/// is not known to repeat, or is beyond the horizon.
[[nodiscard]] std::string period_tensions_text(const Case& the_case, const Solution& solution,
                                               const Settling& settling,
                                               const Uncertainty& uncertainty);

/// The tensions that hold a body at rest at the end, as a line of the summary; "" where it moves.
[[nodiscard]] std::string rest_tensions_text(const Case& the_case, const Solution& solution,
                                             const Uncertainty& uncertainty);

/// Samples after an empty line, a column for each of `times`, as many beside each other as fit
/// where a number has up to `longest_number` columns. `numbers_at` a time gives the cells in the
/// order of `names`, none beyond the horizon.
[[nodiscard]] std::string samples_table(
    const std::vector<std::string>& names, std::span<const double> times,
    std::size_t longest_number, const TerminalStyle& style,
    const std::function<std::vector<std::string>(double)>& numbers_at);

/// Events below a summary, unless all are asked for.
inline constexpr std::size_t most_events = 20;

/// A column of a table of events; where there is no room for all, the highest `rank`
/// goes first, 0 never.
[[nodiscard]] inline Column ranked(const char* heading, int rank) {
  Column result;
  result.heading = heading;
  result.rank = rank;
  return result;
}

/// The first events, or all, after an empty line; "" without one. Each number has right digits
/// alone; what is beyond the horizon is one row. An accumulation stands at its limit. Where there
/// is no room, their velocities go first, then their poses.
[[nodiscard]] std::string events_text(const Case& the_case, const Solution& solution,
                                      const Uncertainty& uncertainty, bool all,
                                      const TerminalStyle& style);

/// The stretches in which cables stay taut, with the least and the largest tension and when they
/// are reached, likewise; "" without one. Where statics do not determine a tension, it says so.
[[nodiscard]] std::string tensions_text(const Case& the_case, const Solution& solution,
                                        const Uncertainty& uncertainty, const TerminalStyle& style);

/// The state, the gaps, their rates, the tensions and the energy at each time with every right
/// digit, likewise: a column for a time, as many beside each other as fit.
[[nodiscard]] std::string samples_text(const Case& the_case, const Solution& solution,
                                       const Uncertainty& uncertainty,
                                       const std::vector<double>& times,
                                       const TerminalStyle& style);

/// What `certificate` says of `solution`, in a few lines and a table.
[[nodiscard]] std::string certificate_text(const Certificate& certificate, const Case& the_case,
                                           const Solution& solution, const TerminalStyle& style);

}  // namespace tautline::bench
