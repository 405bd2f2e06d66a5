#pragma once

#include "bench/chapter/study.hpp"
#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// Parameters and starts, and what becomes of them.
[[nodiscard]] ChapterTable chapter_table_5_1(const ChapterStudy& study);

}  // namespace tautline::bench
