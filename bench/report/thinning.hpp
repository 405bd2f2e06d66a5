#pragma once

#include "bench/report/replay.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// `impacts` with the digits that a chart needs, and no more than `most` of them, the fastest.
[[nodiscard]] ImpactColumns drawable(ImpactColumns impacts, std::size_t most);

/// `replay` of `report` likewise, with an entry for each of its cases and runs, and without the
/// paths of the runs.
[[nodiscard]] Replay drawable(const Replay& replay, const Report& report);

/// Impacts of one run of a report of `runs` runs, so that all of them have about 1 MB; at least 3.
[[nodiscard]] std::size_t impacts_per_run(std::size_t runs);

/// `value` with `digits` significant digits.
[[nodiscard]] double rounded(double value, int digits = 6);
void round_all(std::vector<double>& column, int digits = 6);

}  // namespace tautline::bench
