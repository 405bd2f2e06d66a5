#pragma once

#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// What is known to be wrong in the chapter, in its order, then what was checked and holds.
[[nodiscard]] std::vector<Correction> chapter_corrections(const ChapterStudy& study);

// Its parts.

/// What is wrong in the formulas, sections 5.1 to 5.6.
[[nodiscard]] std::vector<Correction> formula_corrections(const ChapterStudy& study);

/// What is wrong in the analysis, sections 5.8 and 5.8.1.
[[nodiscard]] std::vector<Correction> analysis_corrections(const ChapterStudy& study);

/// What is wrong where the point mass meets the rigid body, section 5.8.2.
[[nodiscard]] std::vector<Correction> comparison_corrections(const ChapterStudy& study);

/// What was checked and holds.
[[nodiscard]] std::vector<Correction> confirmations(const ChapterStudy& study);

}  // namespace tautline::bench
