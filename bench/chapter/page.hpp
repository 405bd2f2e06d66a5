#pragma once

#include <string>

#include "bench/chapter/report.hpp"
#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// The report as one page that needs no other file and no network: chapter.html. Text and tables
/// are plain HTML, the figures are drawn by the page's scripts. Its links to the CSV files are
/// relative to the folder that it stands in.
[[nodiscard]] std::string chapter_page(const ChapterReport& report, const PageAssets& assets);

}  // namespace tautline::bench
