#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/chapter/study.hpp"

namespace tautline::bench {

/// Something that the chapter says and that was checked.
struct Correction {
  bool holds;                      // false: it is not so, or not quite
  std::string where;               // "Eq. 5.66", "Section 5.8.1"
  std::string chapter;             // what it says
  std::string right;               // what is right
  std::string shown;               // the computed numbers that show it, in a sentence
  nlohmann::ordered_json numbers;  // the same, by name
};

/// What is known to be wrong in the chapter, in its order, then what was checked and holds.
[[nodiscard]] std::vector<Correction> chapter_corrections(const ChapterStudy& study);

/// Those of the formulas, sections 5.1 to 5.6.
[[nodiscard]] std::vector<Correction> formula_corrections(const ChapterStudy& study);

/// Those of the analysis, sections 5.8 and 5.8.1.
[[nodiscard]] std::vector<Correction> analysis_corrections(const ChapterStudy& study);

/// Those of the point mass against the rigid body, section 5.8.2.
[[nodiscard]] std::vector<Correction> comparison_corrections(const ChapterStudy& study);

/// What was checked and holds.
[[nodiscard]] std::vector<Correction> confirmations(const ChapterStudy& study);

}  // namespace tautline::bench
