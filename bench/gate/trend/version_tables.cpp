#include "bench/gate/trend/version_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "bench/base/listed.hpp"
#include "bench/base/text.hpp"
#include "bench/gate/changes_output.hpp"
#include "bench/report/words.hpp"

namespace tautline::bench {
namespace {

constexpr double milli = 1e-3;

std::string name_of(const Metric& metric) {
  return std::string(metric.brief) +
         (metric.unit == "1" ? "" : " [" + std::string(metric.unit) + "]");
}

std::string setup_name(const SetupKey& key) {
  return fmt::format("{}, step {:g} s", printable(key.model), key.step);
}

std::string count_or_dash(std::size_t count) {
  return count == 0 ? std::string(dash) : std::to_string(count);
}

/// The first reason among the runs of `report` that failed, and how many did.
std::string failures_of(const Report& report) {
  const auto failed = [](const RunRow& run) { return !did_its_work(run.status); };
  const auto first = std::find_if(report.runs.begin(), report.runs.end(), failed);
  return first == report.runs.end()
             ? ""
             : fmt::format("{}, {}: {}", to_string(first->status), printable(first->key.model),
                           printable(first->reason));
}

/// A model and step: its metrics and its cost over the reports.
struct Setup {
  std::vector<const TrendRow*> rows;
  const TrendCost* cost = nullptr;
};

std::map<SetupKey, Setup> setups_of(const Trend& trend) {
  std::map<SetupKey, Setup> setups;
  for (const TrendRow& row : trend.rows) {
    setups[row.key].rows.push_back(&row);
  }
  for (const TrendCost& cost : trend.costs) {
    setups[cost.key].cost = &cost;
  }
  return setups;
}

Table table_of(const Trend& trend, const Setup& setup) {
  std::vector<std::string> headings = {"version"};
  for (const TrendRow* row : setup.rows) {
    headings.push_back(name_of(metric_list()[row->metric]));
  }
  headings.emplace_back("cost [ms/s]");
  Table table(headings, 1);
  for (std::size_t index = 0; index < trend.reports.size(); ++index) {
    std::vector<Cell> cells = {printable(trend.reports[index].name)};
    for (const TrendRow* row : setup.rows) {
      const std::optional<TrendPoint>& point = row->points[index];
      cells.push_back(number_cell(point ? std::optional(point->median) : std::nullopt,
                                  metric_list()[row->metric].digits));
    }
    const std::optional<double> cost =
        setup.cost != nullptr ? setup.cost->points[index] : std::nullopt;
    cells.push_back(number_cell(cost ? std::optional(*cost / milli) : std::nullopt, as_error));
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace

std::string version_title(const VersionTrend& versions) {
  const std::size_t count = versions.versions.size();
  return fmt::format("{}: {} {} of npm, {} version{}", printable(versions.engine),
                     printable(versions.package), printable(versions.range), count,
                     count == 1 ? "" : "s");
}

std::string newest_sentence(const VersionTrend& versions) {
  const TrendVersion& newest = versions.versions.back();
  std::string out = newest.report ? ""
                                  : fmt::format("{} has no report: {}. ", printable(newest.version),
                                                printable(newest.problem, longest_sentence));
  if (const std::size_t count = versions.trend ? versions.trend->reports.size() : 0; count > 1) {
    out += fmt::format("From {} to {}: {}", versions.trend->reports[count - 2].name,
                       versions.trend->reports[count - 1].name,
                       changes_sentence(versions.trend->latest));
  }
  return out;
}

Table versions_table(const VersionTrend& versions) {
  Table table({"version", "runs", "failed", "worse", "better", "note"}, 1, 1);
  std::size_t reports = 0;
  for (const TrendVersion& version : versions.versions) {
    const std::string untried = version.untried ? "untried: not among engine.toml's versions" : "";
    const std::string said = version.report ? failures_of(*version.report)
                                            : printable(version.problem, longest_sentence);
    const std::string note =
        fmt::format("{}{}{}", untried, untried.empty() || said.empty() ? "" : "; ", said);
    if (!version.report) {
      table.add({printable(version.version), dash, dash, dash, dash, note});
      continue;
    }
    const auto& runs = version.report->runs;
    const auto failed = std::count_if(runs.begin(), runs.end(),
                                      [](const RunRow& run) { return !did_its_work(run.status); });
    const Changes since = reports == 0 ? Changes() : versions.trend->changes[reports - 1];
    ++reports;
    table.add({printable(version.version), std::to_string(runs.size()),
               count_or_dash(static_cast<std::size_t>(failed)), count_or_dash(since.count_worse()),
               count_or_dash(since.count_better()), note});
  }
  return table;
}

std::vector<TitledTable> setup_tables(const Trend& trend) {
  return listed(setups_of(trend), [&](const auto& one) {
    return TitledTable{setup_name(one.first), table_of(trend, one.second)};
  });
}

}  // namespace tautline::bench
