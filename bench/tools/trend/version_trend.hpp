#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/gate/trend.hpp"
#include "bench/page/page_assets.hpp"
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

/// A trend of one engine over the versions of its package, with what is to be said of each version.
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

/// Those that are listed in `kind`, which is what got worse or what got better: the newest version
/// comes first, and of each what changed most.
[[nodiscard]] std::vector<VersionMove> version_moves(const Trend& trend,
                                                     std::vector<MetricChange> Changes::*kind);

/// True where a maintainer should look before a release: the newest version has no report, or is
/// worse than the one before it that has one.
[[nodiscard]] bool newest_is_worse(const VersionTrend& versions);

/// "planck: planck >=1.0 <=1.4.2 of npm, 3 versions".
[[nodiscard]] std::string version_title(const VersionTrend& versions);

/// What the newest version has come to since the one before it, in a sentence or two.
[[nodiscard]] std::string newest_sentence(const VersionTrend& versions);

/// A table, what stands above it, and how to read its columns.
struct TitledTable {
  std::string title;
  Table table;
  std::string how_to_read;
};

/// Which version changed which figure by how much: what got worse, then what got better, then
/// costs. What there is nothing of is left out.
[[nodiscard]] std::vector<TitledTable> change_tables(const Trend& trend);

/// A trend over versions for a terminal: each version, which changed what, and with `all` also each
/// model and step over the versions.
[[nodiscard]] std::string version_text(const VersionTrend& versions, bool all,
                                       const TerminalStyle& style);

/// All of `trends` as a page in Markdown, each with its chart, a file next to it.
[[nodiscard]] std::string version_markdown(const std::vector<VersionTrend>& trends);

/// All of `trends` as a page, charts included, that needs no other file.
[[nodiscard]] std::string version_html(const std::vector<VersionTrend>& trends,
                                       const PageAssets& assets);

/// All of `trends` as JSON, indented, with a line break at the end, and its schema.
[[nodiscard]] std::string version_trends_json(const std::vector<VersionTrend>& trends);
[[nodiscard]] std::string version_trends_schema_json();

/// The name of the chart of an engine.
[[nodiscard]] std::string chart_name(const std::string& engine);

/// Error and cost of an engine over its versions as a picture: a row of panels for each of what is
/// looked at first, a column for each step, a line for each model. Requires a trend.
[[nodiscard]] std::string version_svg(const VersionTrend& versions);

/// The numbers of that picture: a line for each quantity, model, step and version.
[[nodiscard]] std::string version_csv(const VersionTrend& versions);

}  // namespace tautline::bench
