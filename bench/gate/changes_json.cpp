#include "bench/gate/changes_output.hpp"

#include <vector>

#include "bench/report/json/writer.hpp"

namespace tautline::bench {
namespace {

/// The numbers of the forms: their key `schema`.
constexpr int changes_schema = 3;
constexpr int trend_schema = 1;

}  // namespace

// What follows is found by its argument's type: it must not be in the unnamed namespace.

static Json json_of(const VersionChange& change) {
  return {
      {"what", change.what}, {"before", json_of(change.before)}, {"after", json_of(change.after)}};
}

static Json json_of(const StatusChange& change) {
  Json row = json_of(change.key);
  row["before"] = to_string(change.before);
  row["after"] = to_string(change.after);
  row["reason"] = change.reason;
  return row;
}

static Json json_of(const MetricChange& change) {
  const Metric& metric = metric_list()[change.metric];
  Json row = json_of(change.key);
  row["metric"] = metric.name;
  row["unit"] = metric.unit;
  row["before"] = json_of(change.before);
  row["after"] = json_of(change.after);
  return row;
}

static Json json_of(const CostChange& change) {
  return {{"engine", change.key.engine},
          {"model", change.key.model},
          {"step", change.key.step},
          {"cases", change.cases},
          {"factor", change.factor}};
}

static Json json_of(const Noise& noise) {
  return {{"relative", noise.relative},  {"early_rounding", noise.early_rounding},
          {"growth", noise.growth},      {"extremes", noise.extremes},
          {"impacts", noise.impacts},    {"cost", noise.cost},
          {"tolerance", noise.tolerance}};
}

static Json json_of(const TrendReport& report) {
  return {{"name", report.name},
          {"started", report.started},
          {"version", report.version},
          {"runs", report.runs}};
}

static Json json_of(const TrendPoint& point) {
  return {{"version", point.version},     {"median", point.median}, {"lower_quartile", point.low},
          {"upper_quartile", point.high}, {"worse", point.worse},   {"better", point.better}};
}

static Json json_of(const TrendRow& row) {
  const Metric& metric = metric_list()[row.metric];
  return {{"engine", row.key.engine},     {"model", row.key.model}, {"step", row.key.step},
          {"metric", metric.name},        {"unit", metric.unit},    {"cases", row.cases},
          {"points", json_of(row.points)}};
}

static Json json_of(const TrendCost& cost) {
  return {{"engine", cost.key.engine},
          {"model", cost.key.model},
          {"step", cost.key.step},
          {"cases", cost.cases},
          {"points", json_of(cost.points)}};
}

std::string changes_json(const Changes& changes) {
  const Json json = {{"schema", changes_schema},
                     {"compared", changes.compared},
                     {"worse", changes.worse()},
                     {"noise", json_of(changes.noise)},
                     {"versions", json_of(changes.versions)},
                     {"new_failures", json_of(changes.new_failures)},
                     {"recovered", json_of(changes.recovered)},
                     {"got_worse", json_of(changes.got_worse)},
                     {"got_better", json_of(changes.got_better)},
                     {"only_before", json_of(changes.only_before)},
                     {"only_after", json_of(changes.only_after)},
                     {"other_case", json_of(changes.other_case)},
                     {"costs", json_of(changes.costs)}};
  return json.dump(2) + "\n";
}

static Json json_of(const Trend& trend) {
  return {{"schema", trend_schema},
          {"worse", trend.latest.worse()},
          {"noise", json_of(trend.latest.noise)},
          {"reports", json_of(trend.reports)},
          {"rows", json_of(trend.rows)},
          {"costs", json_of(trend.costs)}};
}

static Json json_of(const TrendVersion& version) {
  return {{"version", version.version},
          {"untried", version.untried},
          {"report", version.problem.empty() ? Json(version.file) : Json(nullptr)},
          {"problem", version.problem.empty() ? Json(nullptr) : Json(version.problem)}};
}

static Json json_of(const VersionTrend& trend) {
  return {{"engine", trend.engine},
          {"package", trend.package},
          {"range", trend.range},
          {"versions", json_of(trend.versions)},
          {"trend", json_of(trend.trend)}};
}

std::string trend_json(const Trend& trend) { return json_of(trend).dump(2) + "\n"; }

std::string version_trends_json(const std::vector<VersionTrend>& trends) {
  const Json json = {{"schema", trend_schema}, {"engines", json_of(trends)}};
  return json.dump(2) + "\n";
}

}  // namespace tautline::bench
