#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bench/solution/certificate.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

/// The number of the format below; it changes when a name or a meaning does.
inline constexpr int solution_schema = 4;

/// One sentence for each of `sample_times` at which the solution has no state: outside
/// [0, end_time()].
[[nodiscard]] std::vector<std::string> sample_problems(const Solution& solution,
                                                       std::span<const double> sample_times);

/// What `tautline solve --json` writes:
///
///     schema, case (with the keys of a case file),
///     options: {law, completion_error, max_events, max_steps},
///     events: [{time, kind, cables, impulses, before, after, errors: {time, impulses, before,
///     after}|null, indeterminate: [cable] if there are any}], ending, end_time, end_state,
///     energy: {start, impacts, completions, end, residual},
///     settling: {last_impacts: [{speed, time|null}], lock: {time, uncertainty|null, cables,
///     permanent, rests, swing: {energy, period, least|null, largest|null, amplitude|null,
///     angle_of, goes_round, tensions: [{cable, least: {value, error|null}, largest}]}|null}|null},
///     accumulations: [{start, time, uncertainty|null, cables, energy_lost}],
///     unsure: [{from, until|null, tie: {kind, cables}|null}],
///     taut: [{cable, from, until, least: {tension, time}, largest, indeterminate}], a tension and
///     its time as {value, error|null},
///     samples: [{time, position, angle, velocity, spin, gaps, gap_rates, tensions, energy,
///     errors: {state, gaps, gap_rates, tensions, energy}|null}], if there are sample times,
///     certificate, if there is one: {digits, completion_error, correct: [{digits, until|null}],
///         events: {same, until, all, next_in_double: {time, kind, cables}|null, next_in_digits,
///         in_digits}, ending, end_time, energy, settling}
///
/// `errors` bound those of the numbers beside them, as `Uncertainty` does; null where the solution
/// is one of many motions that start alike, which are the `unsure` stretches of time. That of the
/// time of a completed accumulation is of its limit. `uncertainty` bounds the error of the time
/// beside it: rounding, and how the bounces end; in the certificate the latter alone. Impulses are
/// >= 0. `taut` has the stretches of time in which a cable stays taut, with its least and its
/// largest tension [N] there and the first time of each; `indeterminate` where statics leave its
/// share open: it is the smallest then.
///
/// A `tie` is what rounding decides at `from`: with kind impact which of the cables, taut at one
/// instant, is hit first; with kind slack whether the cable lets go, whose tension touches zero;
/// with kind taut how the body goes on from a dead point of its taut cables. Among `indeterminate`
/// cables the split of an impulse is one of several: that of smallest size.
///
/// A `swing` goes to and fro, or round and round: then it has no turning points. Its angles are
/// those of the "body", or of its first "cable" where the body does not turn with it. `tensions`
/// are the extremes of a period [N].
///
/// Each value, event and sample is a line.
///
/// A state is {position: [x, y], angle, velocity: [vx, vy], spin}.
/// Requires that `sample_problems` is empty; else throws std::out_of_range.
[[nodiscard]] std::string solution_json(const Case& the_case, const SolveOptions& options,
                                        const Solution& solution, const Settling& settling,
                                        std::span<const double> sample_times,
                                        const std::optional<Certificate>& certificate);

}  // namespace tautline::bench
