#pragma once

#include <optional>

#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

// How far instants of a solution may be off [s], rounding and the end of bounces together. None
// where the instant is beyond the horizon.

/// The error of the time of the event of this kind at `time`.
[[nodiscard]] std::optional<double> time_error(const Solution& solution,
                                               const Uncertainty& uncertainty, double time,
                                               EventKind kind);

/// The accumulation that `event` completes, or null.
[[nodiscard]] const Accumulation* accumulation_at(const Solution& solution, const Event& event);

/// The error of the limit of `accumulation`, one of those of `solution`.
[[nodiscard]] std::optional<double> limit_error(const Solution& solution,
                                                const Uncertainty& uncertainty,
                                                const Accumulation& accumulation);

/// The error of the time of the lock, if there is one.
[[nodiscard]] std::optional<double> lock_error(const Solution& solution, const Settling& settling,
                                               const Uncertainty& uncertainty);

}  // namespace tautline::bench
