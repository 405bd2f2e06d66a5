#include "bench/gate/changes_json.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

/// The numbers of the forms: their key `schema`.
constexpr int changes_schema = 3;
constexpr int trend_schema = 1;

template <class Value>
ordered_json or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json row_of(const RunKey& run) {
  return {{"case", run.the_case}, {"engine", run.engine}, {"model", run.model}, {"step", run.step}};
}

ordered_json row_of(const VersionChange& change) {
  return {
      {"what", change.what}, {"before", or_null(change.before)}, {"after", or_null(change.after)}};
}

ordered_json row_of(const StatusChange& change) {
  ordered_json row = row_of(change.key);
  row["before"] = to_string(change.before);
  row["after"] = to_string(change.after);
  row["reason"] = change.reason;
  return row;
}

ordered_json row_of(const MetricChange& change) {
  const Metric& metric = metric_list()[change.metric];
  ordered_json row = row_of(change.key);
  row["metric"] = metric.name;
  row["unit"] = metric.unit;
  row["before"] = or_null(change.before);
  row["after"] = or_null(change.after);
  return row;
}

ordered_json row_of(const CostChange& change) {
  return {{"engine", change.key.engine},
          {"model", change.key.model},
          {"step", change.key.step},
          {"cases", change.cases},
          {"factor", change.factor}};
}

ordered_json object_of(const Noise& noise) {
  return {{"relative", noise.relative},  {"early_rounding", noise.early_rounding},
          {"growth", noise.growth},      {"extremes", noise.extremes},
          {"impacts", noise.impacts},    {"cost", noise.cost},
          {"tolerance", noise.tolerance}};
}

ordered_json row_of(const TrendReport& report) {
  return {{"name", report.name},
          {"started", report.started},
          {"version", report.version},
          {"runs", report.runs}};
}

ordered_json row_of(const std::optional<TrendPoint>& point) {
  if (!point) {
    return nullptr;
  }
  return {{"version", point->version},    {"median", point->median},
          {"lower_quartile", point->low}, {"upper_quartile", point->high},
          {"worse", point->worse},        {"better", point->better}};
}

template <class Row>
ordered_json rows_of(const std::vector<Row>& rows) {
  ordered_json result = ordered_json::array();
  for (const Row& row : rows) {
    result.push_back(row_of(row));
  }
  return result;
}

ordered_json row_of(const TrendRow& row) {
  const Metric& metric = metric_list()[row.metric];
  return {{"engine", row.key.engine},     {"model", row.key.model}, {"step", row.key.step},
          {"metric", metric.name},        {"unit", metric.unit},    {"cases", row.cases},
          {"points", rows_of(row.points)}};
}

ordered_json row_of(const TrendCost& cost) {
  ordered_json points = ordered_json::array();
  for (const std::optional<double>& point : cost.points) {
    points.push_back(or_null(point));
  }
  return {{"engine", cost.key.engine},
          {"model", cost.key.model},
          {"step", cost.key.step},
          {"cases", cost.cases},
          {"points", std::move(points)}};
}

}  // namespace

std::string changes_json(const Changes& changes) {
  const ordered_json json = {{"schema", changes_schema},
                             {"compared", changes.compared},
                             {"worse", changes.worse()},
                             {"noise", object_of(changes.noise)},
                             {"versions", rows_of(changes.versions)},
                             {"new_failures", rows_of(changes.new_failures)},
                             {"recovered", rows_of(changes.recovered)},
                             {"got_worse", rows_of(changes.got_worse)},
                             {"got_better", rows_of(changes.got_better)},
                             {"only_before", rows_of(changes.only_before)},
                             {"only_after", rows_of(changes.only_after)},
                             {"other_case", rows_of(changes.other_case)},
                             {"costs", rows_of(changes.costs)}};
  return json.dump(2) + "\n";
}

namespace {

ordered_json object_of(const Trend& trend) {
  ordered_json rows = ordered_json::array();
  for (const TrendRow& row : trend.rows) {
    rows.push_back(row_of(row));
  }
  ordered_json costs = ordered_json::array();
  for (const TrendCost& cost : trend.costs) {
    costs.push_back(row_of(cost));
  }
  return {{"schema", trend_schema},
          {"worse", trend.latest.worse()},
          {"noise", object_of(trend.latest.noise)},
          {"reports", rows_of(trend.reports)},
          {"rows", std::move(rows)},
          {"costs", std::move(costs)}};
}

ordered_json row_of(const TrendVersion& version) {
  return {{"version", version.version},
          {"untried", version.untried},
          {"report", or_null(version.problem.empty() ? std::optional(version.file) : std::nullopt)},
          {"problem",
           or_null(version.problem.empty() ? std::nullopt : std::optional(version.problem))}};
}

ordered_json object_of(const VersionTrend& trend) {
  ordered_json versions = ordered_json::array();
  for (const TrendVersion& version : trend.versions) {
    versions.push_back(row_of(version));
  }
  return {{"engine", trend.engine},
          {"package", trend.package},
          {"range", trend.range},
          {"versions", std::move(versions)},
          {"trend", trend.trend ? object_of(*trend.trend) : ordered_json(nullptr)}};
}

}  // namespace

std::string trend_json(const Trend& trend) { return object_of(trend).dump(2) + "\n"; }

std::string version_trends_json(const std::vector<VersionTrend>& trends) {
  ordered_json engines = ordered_json::array();
  for (const VersionTrend& trend : trends) {
    engines.push_back(object_of(trend));
  }
  const ordered_json json = {{"schema", trend_schema}, {"engines", std::move(engines)}};
  return json.dump(2) + "\n";
}

}  // namespace tautline::bench
