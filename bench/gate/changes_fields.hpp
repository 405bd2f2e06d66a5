#pragma once

#include <string>

#include "bench/gate/changes.hpp"
#include "bench/gate/trend.hpp"
#include "bench/report/json/fields.hpp"

// The members of what changed between reports by their names in JSON, as fields.hpp has those of a
// report.

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, VersionChange& change) {
  visit("what", change.what);
  visit("before", change.before);
  visit("after", change.after);
}

template <class Visitor>
void fields(Visitor& visit, StatusChange& change) {
  fields(visit, change.key);
  visit("before", change.before);
  visit("after", change.after);
  visit("reason", change.reason);
}

/// The name and the unit of the metric in this `place` of the list.
template <class Visitor>
void metric_fields(Visitor& visit, std::size_t place) {
  const Metric& metric = metric_list()[place];
  visit("metric", std::string(metric.name));
  visit("unit", std::string(metric.unit), "1 for a ratio");
}

template <class Visitor>
void fields(Visitor& visit, MetricChange& change) {
  fields(visit, change.key);
  metric_fields(visit, change.metric);
  visit("before", change.before, "null: not measured");
  visit("after", change.after, "null: not measured");
}

template <class Visitor>
void fields(Visitor& visit, CostChange& change) {
  fields(visit, change.key);
  visit("cases", change.cases, at_least(1));
  visit("factor", change.factor, above(0));
}

template <class Visitor>
void fields(Visitor& visit, Noise& noise) {
  visit.means("what counts as noise, and the tolerance: bench/gate/noise.hpp");
  visit("relative", noise.relative);
  visit("early_rounding", noise.early_rounding);
  visit("growth", noise.growth);
  visit("extremes", noise.extremes);
  visit("impacts", noise.impacts);
  visit("cost", noise.cost);
  visit("tolerance", noise.tolerance, at_least(0));
}

template <class Visitor>
void fields(Visitor& visit, Changes& changes) {
  schema_field(visit, 3);
  visit("compared", changes.compared, "runs in both reports, of the same case");
  visit("worse", changes.worse(),
        "exit code 1: a new failure, a metric that got worse, or a run that is gone");
  visit("noise", changes.noise);
  visit("versions", changes.versions,
        "of the program, the compiler, the build, the processor and the engines, where they "
        "differ; null where one is not there");
  visit("new_failures", changes.new_failures);
  visit("recovered", changes.recovered);
  visit("got_worse", changes.got_worse);
  visit("got_better", changes.got_better);
  visit("only_before", changes.only_before);
  visit("only_after", changes.only_after);
  visit("other_case", changes.other_case, "not compared: cables, duration or start differ");
  visit("costs", changes.costs,
        "the cost of a step, where its median over the cases changed by more than the noise; it "
        "judges nothing");
}

template <class Visitor>
void fields(Visitor& visit, TrendReport& report) {
  visit("name", report.name, "of the file, or the version");
  visit("started", report.started, "ISO 8601, UTC");
  visit("version", report.version, "of tautline");
  visit("runs", report.runs);
}

template <class Visitor>
void fields(Visitor& visit, TrendPoint& point) {
  visit("version", point.version, "of the engine");
  visit("median", point.median, "over the cases");
  visit("lower_quartile", point.low);
  visit("upper_quartile", point.high);
  visit("worse", point.worse, "runs, since the report before, beyond noise and tolerance");
  visit("better", point.better);
}

template <class Visitor>
void fields(Visitor& visit, TrendRow& row) {
  fields(visit, row.key);
  metric_fields(visit, row.metric);
  visit("cases", row.cases, at_least(1));
  visit("points", row.points,
        Says("one for each report; null: the report has no such run").not_empty());
}

template <class Visitor>
void fields(Visitor& visit, TrendCost& cost) {
  fields(visit, cost.key);
  visit("cases", cost.cases, at_least(1, "that all reports with such runs have"));
  visit("points", cost.points,
        Says("[s], median over the cases, one for each report; null: no such run").not_empty());
}

template <class Visitor>
void fields(Visitor& visit, Trend& trend) {
  schema_field(visit, 1);
  visit("worse", trend.latest.worse(),
        "exit code 1: from the last report but one to the last there is a new failure, a metric "
        "that got worse, or a run that is gone");
  visit("noise", trend.latest.noise);
  visit("reports", trend.reports, Says("in the order of the command line").not_empty());
  visit("rows", trend.rows);
  visit("costs", trend.costs, "what a simulated second costs: noisy, and judges nothing");
}

}  // namespace tautline::bench
