#pragma once

#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// Moments of inertia.
[[nodiscard]] ChapterTable chapter_table_5_2();

}  // namespace tautline::bench
