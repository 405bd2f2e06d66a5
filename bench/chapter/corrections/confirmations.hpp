#pragma once

#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// What was checked and holds.
[[nodiscard]] std::vector<Correction> confirmations(const ChapterStudy& study);

}  // namespace tautline::bench
