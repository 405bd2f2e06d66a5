#pragma once

#include <string>

#include "bench/chapter/report.hpp"

namespace tautline::bench {

/// The report to read as text: chapter.md.
[[nodiscard]] std::string chapter_markdown(const ChapterReport& report);

}  // namespace tautline::bench
