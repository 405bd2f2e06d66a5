#pragma once

#include <cstddef>
#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

// What fits a comment on a pull request, and a card to put beside it.

/// The most rows of the summary's table; GitHub folds a comment that is much longer.
inline constexpr std::size_t most_summary_rows = 20;

/// The most characters of the summary: a comment on GitHub has room for 65,536.
inline constexpr std::size_t longest_summary = 60000;

/// summary.md: the verdict in one line, then the models, those that break a limit first.
[[nodiscard]] std::string summary_markdown(const Report& report);

/// card-<engine>.svg: the engine, its version, its verdict and the three numbers that matter.
[[nodiscard]] std::string card_svg(const Report& report, const std::string& engine);

/// The name of that file.
[[nodiscard]] std::string card_name(const std::string& engine);

}  // namespace tautline::bench
