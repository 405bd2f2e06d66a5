#pragma once

#include <vector>

#include "bench/chapter/study.hpp"
#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// Tables 5.1, 5.2 and 5.3: what is printed beside what is exact.
[[nodiscard]] std::vector<ChapterTable> chapter_tables(const ChapterStudy& study);

}  // namespace tautline::bench
