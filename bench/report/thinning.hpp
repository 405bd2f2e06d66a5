#pragma once

#include "bench/report/report.hpp"

namespace tautline::bench {

/// `row` with the digits that a chart needs, and with no more than `impacts` impacts, the fastest.
[[nodiscard]] RunRow drawable(RunRow row, std::size_t impacts);
[[nodiscard]] CaseRow drawable(CaseRow row);

/// Impacts of one run of a report of `runs` runs, so that all of them have about 1 MB; at least 3.
[[nodiscard]] std::size_t impacts_per_run(std::size_t runs);

/// `value` with `digits` significant digits.
[[nodiscard]] double rounded(double value, int digits = 6);

}  // namespace tautline::bench
