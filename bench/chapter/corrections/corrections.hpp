#pragma once

#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// What is known to be wrong in the chapter, in its order, then what was checked and holds.
[[nodiscard]] std::vector<Correction> chapter_corrections(const ChapterStudy& study);

}  // namespace tautline::bench
