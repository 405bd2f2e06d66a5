#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/chapter/corrections.hpp"
#include "bench/chapter/figures.hpp"
#include "bench/chapter/study.hpp"
#include "bench/chapter/table.hpp"

namespace tautline::bench {

/// The number of the format of `chapter_json`; it changes when a name or a meaning does.
inline constexpr int chapter_schema = 1;

/// Everything that `tautline reproduce` has to say of the source chapter.
struct ChapterReport {
  std::vector<ChapterTable> tables;
  std::vector<ChapterFigure> figures;
  std::vector<Correction> corrections;
};
[[nodiscard]] ChapterReport chapter_report(const ChapterStudy& study);

/// {schema, options, tables, figures, corrections}; file names are relative to the folder
/// `chapter` beside it.
[[nodiscard]] nlohmann::ordered_json chapter_json(const ChapterReport& report);

/// The same as a page to read.
[[nodiscard]] std::string chapter_markdown(const ChapterReport& report);

/// The corrections as a table: place, what the chapter says, what is right, what shows it.
[[nodiscard]] std::string corrections_csv(const std::vector<Correction>& corrections);

}  // namespace tautline::bench
