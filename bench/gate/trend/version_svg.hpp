#pragma once

#include <string>

#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

/// Error and cost of an engine over its versions as a picture: a row of panels for each of what is
/// looked at first, a column for each step, a line for each model. Requires a trend.
[[nodiscard]] std::string version_svg(const VersionTrend& versions);

}  // namespace tautline::bench
