#pragma once

#include <vector>

#include "bench/chapter/study.hpp"
#include "bench/chapter/table.hpp"

namespace tautline::bench {

/// An error this small is the decimal's own rounding to double: it counts as none [-].
inline constexpr double printed_rounding = 1e-15;

/// Tables 5.1, 5.2 and 5.3: what is printed beside what is exact.
[[nodiscard]] std::vector<ChapterTable> chapter_tables(const ChapterStudy& study);

/// The last of them.
[[nodiscard]] ChapterTable table_5_3(const ChapterStudy& study);

/// Printed less exact numbers of Table 5.3's row `instant` in the order t, x, vx, y, vy, g1, g2.
/// Throws std::out_of_range if there is no such row.
[[nodiscard]] std::vector<double> table_5_3_errors(const ChapterStudy& study,
                                                   std::string_view instant);

}  // namespace tautline::bench
