#pragma once

#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

/// "planck: planck >=1.0 <=1.4.2 of npm, 3 versions".
[[nodiscard]] std::string version_title(const VersionTrend& versions);

/// A row for each version: its runs, those that failed, and what is to be said of it.
[[nodiscard]] Table versions_table(const VersionTrend& versions);

/// What got worse or better between which versions; empty if nothing did.
[[nodiscard]] Table moves_table(const Trend& trend);

/// One model and step over the versions: medians of its metrics, and its cost.
struct SetupTable {
  std::string title;
  Table table;
};

/// All of them, or those of which something moves.
[[nodiscard]] std::vector<SetupTable> setup_tables(const Trend& trend, bool all);

/// What the last step says, in a sentence; "" for one version alone.
[[nodiscard]] std::string latest_sentence(const Trend& trend);

}  // namespace tautline::bench
