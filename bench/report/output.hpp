#pragma once

#include <string>

#include "bench/base/terminal.hpp"
#include "bench/page/page_assets.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

// What a report is written as, from what is in it alone.

/// The report as Markdown, readable as it stands. Drawn from `report` alone.
[[nodiscard]] std::string report_markdown(const Report& report);

/// The report as one page that needs no other file and no network: all of it in plain HTML, and the
/// charts by the page's scripts. Drawn from `report` and its `replay`; every number in its tables
/// is one of `report`, and stands in full in its cell: in its data-value, or as its text.
[[nodiscard]] std::string report_html(const Report& report, const Replay& replay,
                                      const PageAssets& assets);

/// The answers for a terminal: a sentence for each engine, the worst first; with `all` the table
/// over all cases with as many columns as fit, and what its words mean; the failures. Drawn from
/// `report` alone.
[[nodiscard]] std::string report_summary(const Report& report, bool all,
                                         const TerminalStyle& style);

/// The one run of `report` for a terminal: what ran, its verdict and what it is judged by, the
/// metrics that matter, or all of them, and what was found.
[[nodiscard]] std::string run_card(const Report& report, bool all_metrics,
                                   const TerminalStyle& style);

}  // namespace tautline::bench
