#pragma once

#include <string>
#include <vector>

#include "bench/chapter/corrections/correction.hpp"
#include "bench/chapter/figures/figures.hpp"
#include "bench/chapter/study.hpp"
#include "bench/chapter/tables/table.hpp"

namespace tautline::bench {

/// Everything that `tautline reproduce` has to say of the source chapter. Its sentences have
/// **strong**, *stressed* and `code` words as Markdown does.
struct ChapterReport {
  std::string introduction;              // what the chapter is, and what is done with it here
  std::vector<std::string> conventions;  // units, names and how it was computed
  std::vector<ChapterTable> tables;
  std::vector<ChapterFigure> figures;
  std::vector<Correction> corrections;
};
[[nodiscard]] ChapterReport chapter_report(const ChapterStudy& study);

}  // namespace tautline::bench
