#pragma once

#include <string>

#include "bench/chapter/report.hpp"

namespace tautline::bench {

/// The number of the format of `chapter_json`; it changes when a name or a meaning does.
inline constexpr int chapter_schema = 1;

/// The text of chapter.json: {schema, options, tables, figures, corrections}; file names are
/// relative to the folder `chapter` beside it.
[[nodiscard]] std::string chapter_json(const ChapterReport& report);

/// What the script of the page draws, as the content of a script element: {figures}, each with
/// its curves, boundaries and marks.
[[nodiscard]] std::string chapter_page_data(const ChapterReport& report);

}  // namespace tautline::bench
