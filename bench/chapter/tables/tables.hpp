#pragma once

#include <string_view>
#include <vector>

#include "bench/chapter/study.hpp"
#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// Tables 5.1, 5.2 and 5.3: what is printed beside what is exact.
[[nodiscard]] std::vector<ChapterTable> chapter_tables(const ChapterStudy& study);

/// Parameters and starts, and what becomes of them.
[[nodiscard]] ChapterTable chapter_table_5_1(const ChapterStudy& study);

/// Moments of inertia.
[[nodiscard]] ChapterTable chapter_table_5_2();

/// States of the point mass.
[[nodiscard]] ChapterTable chapter_table_5_3(const ChapterStudy& study);

/// Printed less exact numbers of the row `instant` in the order t, x, vx, y, vy, g1, g2.
/// Throws std::out_of_range if there is no such row.
[[nodiscard]] std::vector<double> table_5_3_errors(const ChapterStudy& study,
                                                   std::string_view instant);

}  // namespace tautline::bench
