#pragma once

#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/gate/trend/version_trend.hpp"
#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// A trend over versions for a terminal: each version, which changed what, and with `all` also each
/// model and step over the versions.
[[nodiscard]] std::string version_text(const VersionTrend& versions, bool all,
                                       const TerminalStyle& style);

/// All of `trends` as a page in Markdown, each with its chart, a file beside it.
[[nodiscard]] std::string version_markdown(const std::vector<VersionTrend>& trends);

/// The name of the chart of an engine.
[[nodiscard]] std::string chart_name(const std::string& engine);

/// Error and cost of an engine over its versions as a picture: a row of panels for each of what is
/// looked at first, a column for each step, a line for each model. Requires a trend.
[[nodiscard]] std::string version_svg(const VersionTrend& versions);

/// All of `trends` as a page, charts included, that needs no other file and no script.
[[nodiscard]] std::string version_html(const std::vector<VersionTrend>& trends,
                                       const PageAssets& assets);

}  // namespace tautline::bench
