#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/measure/metric_list.hpp"
#include "bench/report/report.hpp"
#include "bench/report/tally.hpp"

namespace tautline::bench {

// What the tables of a report have in common.

/// A column of words that a page can sort by `key`.
[[nodiscard]] Column word_column(std::string heading, std::string key);

/// How instants are shown [s].
inline constexpr Digits as_instant = fixed(4);

/// A column of numbers; `unit` and `group` may be empty.
[[nodiscard]] Column number_column(std::string heading, std::string unit, std::string group,
                                   std::string key);

/// The same with a heading and a rank for a terminal.
[[nodiscard]] Column number_column(std::string heading, std::string unit, std::string group,
                                   std::string key, std::string brief, int rank);

/// A name or a sentence from outside, fit to be shown.
[[nodiscard]] Cell word_cell(std::string_view text);
[[nodiscard]] Cell sentence_cell(std::string_view text);

/// A count.
[[nodiscard]] Cell count_cell(std::size_t count);

/// The colour of a verdict on a terminal.
[[nodiscard]] Colour colour_of(Word word);

/// A word as the name of a look: "listed-problem".
[[nodiscard]] std::string word_look(Word word);

/// The worst verdict of some runs and how many have it, or a dash of none.
[[nodiscard]] Cell tally_cell(const Tally& tally);

/// The look of a verdict's cell: "verdict listed-problem".
[[nodiscard]] std::string verdict_kind(Word word);

/// Engine, model and step.
[[nodiscard]] std::vector<Column> setup_columns();
[[nodiscard]] std::vector<Cell> setup_cells(const SetupKey& key);

/// The unit of a metric as a heading shows it: "" of a ratio or a count.
[[nodiscard]] std::string shown_unit(const Metric& metric);

/// The same; "" too of a length, a time or an energy where every case has units of its own.
[[nodiscard]] std::string shown_unit(const Metric& metric, const Report& report);

/// `table` with the units of what the report is of: none of lengths, times and energies where every
/// case has units of its own.
[[nodiscard]] Table in_units_of(const Report& report, const Table& table);

/// The key of a metric's column: its name with "-".
[[nodiscard]] std::string column_key(const Metric& metric);

/// The first threshold of settling as the heading of a group: "last impact > 0.01 m/s".
[[nodiscard]] std::string last_impact_heading(const Report& report);

/// Adds the rows to `table`, those of the control before or after the others in a body of theirs.
enum class ControlPlace { before, after };
void add_rows(Table& table, std::vector<Row> rows, ControlPlace place);

/// The body for the rows of an engine: "control", or "" for the others.
[[nodiscard]] std::string body_of(const std::string& engine);

}  // namespace tautline::bench
