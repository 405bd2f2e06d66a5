#pragma once

#include <string>
#include <vector>

#include "bench/gate/trend/version_trend.hpp"
#include "bench/page/page_assets.hpp"

namespace tautline::bench {

/// All of `trends` as a page, charts included, that needs no other file and no script.
[[nodiscard]] std::string version_html(const std::vector<VersionTrend>& trends,
                                       const PageAssets& assets);

}  // namespace tautline::bench
