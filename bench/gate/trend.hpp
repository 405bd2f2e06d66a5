#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/gate/changes.hpp"
#include "bench/gate/noise.hpp"
#include "bench/report/report.hpp"

namespace tautline::bench {

/// A report of a trend, in the order in which they were given.
struct TrendReport {
  std::string name;     // of its file
  std::string started;  // ISO 8601, UTC
  std::string version;  // of tautline
  std::size_t runs = 0;
};

/// A metric of one engine, model and step in one report: over the cases that all reports with such
/// runs have, and in which all of them could measure it.
struct TrendPoint {
  std::string version;     // of the engine
  double median = 0.0;     // in the unit of the metric, as the quartiles
  double low = 0.0;        // a quarter of the cases is below
  double high = 0.0;       // a quarter of the cases is above
  std::size_t worse = 0;   // runs, since the report before, beyond noise and tolerance
  std::size_t better = 0;  //
};

/// A metric of one engine, model and step over the reports.
struct TrendRow {
  SetupKey key;
  std::size_t metric = 0;  // its place in the list
  std::size_t cases = 0;
  std::vector<std::optional<TrendPoint>> points;  // one for each report; none: no such run

  /// True where some run of it got worse or better.
  [[nodiscard]] bool moves() const;
};

/// What a simulated second costs an engine, model and step over the reports: median over the cases
/// that all reports with such runs have.
struct TrendCost {
  SetupKey key;
  std::size_t cases = 0;
  std::vector<std::optional<double>> points;  // [s], one for each report; none: no such run
};

/// How engines do from report to report, as from version to version.
struct Trend {
  std::vector<TrendReport> reports;
  std::vector<TrendRow> rows;    // of the metrics of the answers
  std::vector<TrendCost> costs;  // which are noisy and judge nothing
  std::vector<Changes> changes;  // from each report to the next: one fewer than reports
  Changes latest;                // the last of them; nothing, of one report
};

/// The trend over one report or more, of which `names` are the files. Any two can be compared: see
/// `incomparable`.
[[nodiscard]] Trend trend(const std::vector<Report>& reports, const std::vector<std::string>& names,
                          const Noise& noise = {});

}  // namespace tautline::bench
