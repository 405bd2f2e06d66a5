#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// The number of the format below; it changes when a name or a meaning does.
inline constexpr int solution_schema = 1;

/// {position: [x, y], angle, velocity: [vx, vy], spin}
[[nodiscard]] nlohmann::ordered_json state_json(const State& state);

/// The whole case, with the keys of a case file.
[[nodiscard]] nlohmann::ordered_json case_json(const Case& the_case);

/// One sentence for each of `sample_times` at which the solution has no state: outside
/// [0, end_time()].
[[nodiscard]] std::vector<std::string> sample_problems(const Solution& solution,
                                                       std::span<const double> sample_times);

/// What `tautline solve --json` writes: schema, case, options, events, ending, end_time, end_state,
/// energy, with Ending::zeno accumulation, and samples if there are sample times.
/// Requires that `sample_problems` is empty; else throws std::out_of_range.
[[nodiscard]] nlohmann::ordered_json solution_json(const Case& the_case,
                                                   const SolveOptions& options,
                                                   const Solution& solution,
                                                   std::span<const double> sample_times);

}  // namespace tautline::bench
