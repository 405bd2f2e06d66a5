#pragma once

#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

/// A trend over versions for a terminal: each version, which changed what, and with `all` also each
/// model and step over the versions.
[[nodiscard]] std::string version_text(const VersionTrend& versions, bool all,
                                       const TerminalStyle& style);

/// All of `trends` as a page in Markdown, each with its chart, a file beside it.
[[nodiscard]] std::string version_markdown(const std::vector<VersionTrend>& trends);

/// The name of the chart of an engine.
[[nodiscard]] std::string chart_name(const std::string& engine);

}  // namespace tautline::bench
