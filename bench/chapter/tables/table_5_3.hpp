#pragma once

#include <string_view>
#include <vector>

#include "bench/chapter/study.hpp"
#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// States of the point mass.
[[nodiscard]] ChapterTable chapter_table_5_3(const ChapterStudy& study);

/// Printed less exact numbers of the row `instant` in the order t, x, vx, y, vy, g1, g2.
/// Throws std::out_of_range if there is no such row.
[[nodiscard]] std::vector<double> table_5_3_errors(const ChapterStudy& study,
                                                   std::string_view instant);

}  // namespace tautline::bench
