#pragma once

#include <string>
#include <vector>

#include "bench/gate/changes.hpp"
#include "bench/gate/trend/trend.hpp"
#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

/// As bench/gate/changes.schema.json describes it, indented, with a line break at its end.
[[nodiscard]] std::string changes_json(const Changes& changes);

/// As bench/gate/trend/trend.schema.json describes it, likewise.
[[nodiscard]] std::string trend_json(const Trend& trend);

/// As bench/gate/trend/version_trend.schema.json describes it, likewise.
[[nodiscard]] std::string version_trends_json(const std::vector<VersionTrend>& trends);

}  // namespace tautline::bench
