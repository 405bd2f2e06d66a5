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

/// A metric of a model and step that moves from one version to the next.
struct VersionMove {
  std::string from;
  std::string to;
  const TrendRow* row = nullptr;
  double before = 0.0;  // median, in the unit of the metric
  double after = 0.0;
  std::size_t worse = 0;  // runs
  std::size_t better = 0;
};

/// All of them, by version: where something changed comes first, then what. `trend` must outlive
/// it.
[[nodiscard]] std::vector<VersionMove> moves(const Trend& trend);

/// True where a maintainer should look before a release: the newest version has no report, or is
/// worse than the one before it that has one.
[[nodiscard]] bool newest_is_worse(const VersionTrend& versions);

}  // namespace tautline::bench
