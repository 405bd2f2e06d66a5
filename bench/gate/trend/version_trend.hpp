#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/gate/trend/trend.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// One version of an engine's package, and the report of its runs.
struct TrendVersion {
  std::string version;
  bool untried = false;          // the engine.toml does not name it among those it is made for
  std::string file;              // of the report
  std::string problem;           // why there is no report, or ""
  std::optional<Report> report;  // one engine's
};

/// An engine over the versions of its package.
struct VersionTrend {
  std::string engine;
  std::string package;
  std::string range;                   // as npm reads it
  std::vector<TrendVersion> versions;  // from the oldest to the newest
  std::optional<Trend> trend;          // over those that have a report; none if none has
};

/// Fills in `trend`: its reports are named by their version.
void find_trend(VersionTrend& versions, const Noise& noise = {});

/// A metric of a model and step that got worse, or better, since the version before.
struct VersionMove {
  std::string version;
  MetricChange most;     // of the run that changed by the largest factor
  std::size_t runs = 0;  // that changed so
};

/// What got worse: the newest version comes first, and of each what changed most.
[[nodiscard]] std::vector<VersionMove> worse_moves(const Trend& trend);

/// The same of what got better.
[[nodiscard]] std::vector<VersionMove> better_moves(const Trend& trend);

/// By how much a metric changed [-]: 1 not at all, otherwise more, whichever way; infinity where a
/// factor says nothing.
[[nodiscard]] double size_of_change(const MetricChange& change);

/// True where a maintainer should look before a release: the newest version has no report, or is
/// worse than the one before it that has one.
[[nodiscard]] bool newest_is_worse(const VersionTrend& versions);

}  // namespace tautline::bench
