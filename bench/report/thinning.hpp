#pragma once

#include "bench/report/report.hpp"

namespace tautline::bench {

/// Samples of one path of a report of `runs` runs, so that all of them have about 4 MB.
[[nodiscard]] std::size_t path_samples(std::size_t runs);

/// `row` with the digits that a drawing needs, and with no more than `impacts` impacts, the
/// fastest; the others leave the path too.
[[nodiscard]] RunRow drawable(RunRow row, std::size_t impacts);
[[nodiscard]] CaseRow drawable(CaseRow row);

/// Impacts of one run of a report of `runs` runs, so that all of them have about 1 MB, and each at
/// least 24.
[[nodiscard]] std::size_t impacts_per_run(std::size_t runs);

/// `value` with `digits` significant digits.
[[nodiscard]] double rounded(double value, int digits = 6);

}  // namespace tautline::bench
