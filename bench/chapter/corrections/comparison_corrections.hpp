#pragma once

#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// What is wrong where the point mass meets the rigid body, section 5.8.2.
[[nodiscard]] std::vector<Correction> comparison_corrections(const ChapterStudy& study);

}  // namespace tautline::bench
