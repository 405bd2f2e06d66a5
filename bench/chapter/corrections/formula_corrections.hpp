#pragma once

#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// What is wrong in the formulas, sections 5.1 to 5.6.
[[nodiscard]] std::vector<Correction> formula_corrections(const ChapterStudy& study);

}  // namespace tautline::bench
