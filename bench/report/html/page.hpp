#pragma once

#include <string>

#include "bench/page/page_assets.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// The report as one page that needs no other file and no network: all of it in plain HTML, and the
/// charts by the page's scripts. Drawn from `report` alone; every number in its tables is one of
/// `report`, and stands in full in its cell: in its data-value, or as its text.
[[nodiscard]] std::string report_html(const Report& report, const PageAssets& assets);

}  // namespace tautline::bench
