#pragma once

#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// What is wrong in the analysis, sections 5.8 and 5.8.1.
[[nodiscard]] std::vector<Correction> analysis_corrections(const ChapterStudy& study);

}  // namespace tautline::bench
