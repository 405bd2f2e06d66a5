#pragma once

#include <cstddef>
#include <string>

#include "bench/base/document.hpp"
#include "bench/gate/changes.hpp"
#include "bench/gate/trend.hpp"

namespace tautline::bench {

// What changed between reports, as it is written.

/// What changed, for a terminal: what is broken first. Runs that are in one report alone are
/// counted.
[[nodiscard]] std::string changes_text(const Changes& changes,
                                       const TerminalStyle& style = unlimited);

/// Adds the runs that newly fail, and those that are gone, if there are any.
void add_missing(Document& out, const Changes& changes);

/// Its last line: how many changes.
[[nodiscard]] std::string changes_sentence(const Changes& changes);

/// A trend for a terminal: what moves from report to report, or `all`; a table for every engine,
/// model and step.
[[nodiscard]] std::string trend_text(const Trend& trend, bool all, const TerminalStyle& style);

/// A metric at the head of a column or a row: "early [m]".
[[nodiscard]] std::string metric_heading(const Metric& metric);

/// A dash for 0.
[[nodiscard]] std::string count_or_dash(std::size_t count);

/// These two write JSON, indented, with a line break at the end.
[[nodiscard]] std::string changes_json(const Changes& changes);
[[nodiscard]] std::string trend_json(const Trend& trend);

/// The JSON schema of `changes_json` and `trend_json`.
[[nodiscard]] std::string compare_schema_json();

}  // namespace tautline::bench
