#include "bench/gate/changes_output.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "bench/base/table.hpp"
#include "bench/base/text.hpp"

namespace tautline::bench {
namespace {

/// Tables that anyone reads; the JSON has them all.
constexpr std::size_t most_tables = 20;

std::string reports_text(const Trend& trend, const TerminalStyle& style) {
  Table table({"report", "runs", "tautline", "started", "file"}, 0, 3);
  for (std::size_t index = 0; index < trend.reports.size(); ++index) {
    const TrendReport& report = trend.reports[index];
    table.add({std::to_string(index + 1), std::to_string(report.runs), printable(report.version),
               printable(report.started), printable(report.name)});
  }
  return table.plain(style);
}

std::string metric_heading(const Metric& metric) {
  return std::string(metric.brief) +
         (metric.unit == "1" ? "" : " [" + std::string(metric.unit) + "]");
}

/// A line for each report; the metric stands at the first.
void add_points(Table& table, const TrendRow& row) {
  const Metric& metric = metric_list()[row.metric];
  for (std::size_t index = 0; index < row.points.size(); ++index) {
    const std::string name = index == 0 ? metric_heading(metric) : "";
    const std::string number = std::to_string(index + 1);
    const std::optional<TrendPoint>& point = row.points[index];
    if (!point) {
      table.add({name, number, "no runs"});
      continue;
    }
    const auto count = [&](std::size_t runs) {
      return runs == 0 ? std::string(dash) : std::to_string(runs);
    };
    table.add(
        {name, number, printable(point->version), number_text(point->median, metric.digits),
         number_text(point->low, metric.digits) + " to " + number_text(point->high, metric.digits),
         std::to_string(row.cases), count(point->worse), count(point->better)});
  }
}

std::vector<std::string> headings() {
  return {"metric", "report", "version", "median", "quartiles", "cases", "worse", "better"};
}

}  // namespace

std::string trend_text(const Trend& trend, bool all, const TerminalStyle& style) {
  std::map<SetupKey, Table> tables;
  std::size_t moving = 0;
  for (const TrendRow& row : trend.rows) {
    moving += row.moves() ? 1U : 0U;
    if (all || row.moves()) {
      Table& table = tables.try_emplace(row.key, headings(), 3).first->second;
      add_points(table, row);
    }
  }
  std::string result = reports_text(trend, style) + "\n";
  std::size_t shown = 0;
  for (const auto& [key, table] : tables) {
    if (!all && ++shown > most_tables) {
      result +=
          fmt::format("and {} more tables: --all prints them\n\n", tables.size() - most_tables);
      break;
    }
    result += fmt::format("{} {}, step {:g} s\n{}\n", printable(key.engine), printable(key.model),
                          key.step, table.plain(style));
  }
  const std::string counted = fmt::format(
      "{} of {} metrics of an engine, model and step move from one report to the next{}. Worse and "
      "better are runs since the report before.",
      moving, trend.rows.size(), all || moving == trend.rows.size() ? "" : "; --all prints all");
  return result + missing_text(trend.latest, style) + wrapped(counted, style.text) +
         wrapped(fmt::format("From report {} to {}: {}", trend.reports.size() - 1,
                             trend.reports.size(), changes_sentence(trend.latest)),
                 style.text);
}

}  // namespace tautline::bench
