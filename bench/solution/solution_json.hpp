#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "bench/solution/certify.hpp"
#include "tautline/ledger.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// The number of the format below; it changes when a name or a meaning does.
inline constexpr int solution_schema = 2;

/// {position: [x, y], angle, velocity: [vx, vy], spin}
[[nodiscard]] nlohmann::ordered_json state_json(const State& state);

/// The whole case, with the keys of a case file.
[[nodiscard]] nlohmann::ordered_json case_json(const Case& the_case);

/// {last_impacts: [{speed, time|null}], lock: {time, uncertainty, cables, permanent, rests,
/// swing: {energy, period, least, largest, amplitude}|null}|null}
[[nodiscard]] nlohmann::ordered_json settling_json(const Settling& settling);

/// {start, impacts, completions, end, residual}
[[nodiscard]] nlohmann::ordered_json ledger_json(const EnergyLedger& ledger);

/// {digits, completion_error, correct: [{digits, until|null}], events: {same, until, all,
/// next_in_double: {time, kind, cables}|null, next_in_digits, in_digits}, ending, end_time, energy}
[[nodiscard]] nlohmann::ordered_json certificate_json(const Certificate& certificate);

/// One sentence for each of `sample_times` at which the solution has no state: outside
/// [0, end_time()].
[[nodiscard]] std::vector<std::string> sample_problems(const Solution& solution,
                                                       std::span<const double> sample_times);

/// What `tautline solve --json` writes: schema, case, options, events, ending, end_time, end_state,
/// energy, settling, accumulations, and samples if there are sample times.
/// Requires that `sample_problems` is empty; else throws std::out_of_range.
[[nodiscard]] nlohmann::ordered_json solution_json(const Case& the_case,
                                                   const SolveOptions& options,
                                                   const Solution& solution,
                                                   const Settling& settling,
                                                   std::span<const double> sample_times);

}  // namespace tautline::bench
