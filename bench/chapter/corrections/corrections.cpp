#include "bench/chapter/corrections/corrections.hpp"

namespace tautline::bench {

std::vector<Correction> chapter_corrections(const ChapterStudy& study) {
  std::vector<Correction> result = formula_corrections(study);
  for (const auto& more :
       {analysis_corrections(study), comparison_corrections(study), confirmations(study)}) {
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

}  // namespace tautline::bench
