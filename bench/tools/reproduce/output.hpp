#pragma once

#include <string>
#include <vector>

#include "bench/page/page_assets.hpp"
#include "bench/tools/reproduce/report.hpp"

namespace tautline::bench {

// What the report of the chapter is written as.

/// The report to read as text: chapter.md.
[[nodiscard]] std::string chapter_markdown(const ChapterReport& report);

/// The report as one page that needs no other file and no network: chapter.html. Text and tables
/// are plain HTML, the figures are drawn by the page's scripts. Its links to the CSV files are
/// relative to the folder that it stands in.
[[nodiscard]] std::string chapter_page(const ChapterReport& report, const PageAssets& assets);

/// The number of the format of `chapter_json`; it changes when a name or a meaning does.
inline constexpr int chapter_schema = 1;

/// The text of chapter.json: {schema, options, tables, figures, corrections}; file names are
/// relative to the folder `chapter` next to it.
[[nodiscard]] std::string chapter_json(const ChapterReport& report);

/// What the script of the page draws, as the content of a script element: {figures}, each with
/// its curves, boundaries and marks.
[[nodiscard]] std::string chapter_page_data(const ChapterReport& report);

/// The table with its numbers in full.
[[nodiscard]] std::string table_csv(const ChapterTable& table);

/// The data of a figure in twelve digits: a plot needs four, and files stay small.
[[nodiscard]] std::string data_csv(const FigureData& data);

/// The corrections as a table: place, what the chapter says, what is right, what shows it.
[[nodiscard]] std::string corrections_csv(const std::vector<Correction>& corrections);

/// `text` with the signs that it spells in ASCII, for a page: "sqrt(S/g)" as "√(S/g)", "<=" as "≤".
[[nodiscard]] std::string typeset(std::string text);

}  // namespace tautline::bench
