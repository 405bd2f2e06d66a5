#pragma once

#include <string>

#include "bench/report/report.hpp"

namespace tautline::bench {

/// The report as Markdown, readable as it stands. Drawn from `report` alone.
[[nodiscard]] std::string report_markdown(const Report& report);

}  // namespace tautline::bench
