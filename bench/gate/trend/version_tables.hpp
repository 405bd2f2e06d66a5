#pragma once

#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/gate/trend/change_tables.hpp"
#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

/// "planck: planck >=1.0 <=1.4.2 of npm, 3 versions".
[[nodiscard]] std::string version_title(const VersionTrend& versions);

/// What the newest version has come to since the one before it, in a sentence or two.
[[nodiscard]] std::string newest_sentence(const VersionTrend& versions);

/// A row for each version: its runs, those that failed, how much changed since the version before,
/// and what is to be said of it.
[[nodiscard]] Table versions_table(const VersionTrend& versions);

/// Each model and step over the versions: medians of its metrics, and its cost.
[[nodiscard]] std::vector<TitledTable> setup_tables(const Trend& trend);

/// How to read them.
inline constexpr const char* how_to_read_setups =
    "Medians over the cases that all versions have. Cost is processor time of a simulated second; "
    "it is noisy and judges nothing.";

}  // namespace tautline::bench
