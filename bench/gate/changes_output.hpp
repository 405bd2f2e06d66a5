#pragma once

#include <string>
#include <vector>

#include "bench/base/terminal.hpp"
#include "bench/gate/changes.hpp"
#include "bench/gate/trend/trend.hpp"
#include "bench/gate/trend/version_trend.hpp"

namespace tautline::bench {

// What changed between reports, as it is written.

/// What changed, for a terminal: what is broken first. Runs that are in one report alone are
/// counted.
[[nodiscard]] std::string changes_text(const Changes& changes,
                                       const TerminalStyle& style = unlimited);

/// Of these what fails anew, and the runs that are gone; "" without any.
[[nodiscard]] std::string missing_text(const Changes& changes, const TerminalStyle& style);

/// Its last line: how many changes.
[[nodiscard]] std::string changes_sentence(const Changes& changes);

/// A trend for a terminal: what moves from report to report, or `all`; a table for every engine,
/// model and step.
[[nodiscard]] std::string trend_text(const Trend& trend, bool all, const TerminalStyle& style);

/// These three write JSON, indented, with a line break at the end.
[[nodiscard]] std::string changes_json(const Changes& changes);
[[nodiscard]] std::string trend_json(const Trend& trend);
[[nodiscard]] std::string version_trends_json(const std::vector<VersionTrend>& trends);

/// The JSON schema of `changes_json` and `trend_json`, and that of `version_trends_json`.
[[nodiscard]] std::string compare_schema_json();
[[nodiscard]] std::string version_trends_schema_json();

}  // namespace tautline::bench
