#pragma once

#include "bench/report/json/fields_of_runs.hpp"
#include "bench/report/report.hpp"

// The members of every row of a report by their names in JSON, once for writing and for reading: a
// visitor is called with each name and member. `group` makes an object of members that are
// none of their own in C++; `by_metric` one with a key for every metric of the list.

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, LastImpact& last) {
  visit("speed", last.speed);
  visit("time", last.time);
}

template <class Visitor>
void fields(Visitor& visit, Swing& swing) {
  visit("energy", swing.energy);
  visit("period", swing.period);
  visit("least", swing.least);
  visit("largest", swing.largest);
  visit("amplitude", swing.amplitude);
}

template <class Visitor>
void fields(Visitor& visit, Lock& lock) {
  visit("time", lock.time);
  visit("uncertainty", lock.uncertainty);
  visit("cables", lock.cables);
  visit("permanent", lock.permanent);
  visit("rests", lock.rests);
  visit("swing", lock.swing);
}

template <class Visitor>
void fields(Visitor& visit, Settling& settling) {
  visit("last_impacts", settling.last_impacts);
  visit("lock", settling.lock);
}

template <class Visitor>
void fields(Visitor& visit, Body& body) {
  visit("mass", body.mass);
  visit("inertia", body.inertia);
}

template <class Visitor>
void fields(Visitor& visit, CableRow& cable) {
  visit("anchor", cable.anchor);
  visit("attachment", cable.attachment);
  visit("length", cable.length);
  visit("restitution", cable.restitution);
}

template <class Visitor>
void fields(Visitor& visit, EventColumns& events) {
  visit("time", events.time);
  visit("kind", events.kind);
  visit("cables", events.cables);
  visit("rate", events.rate);
  visit("left_out", events.left_out);
}

template <class Visitor>
void fields(Visitor& visit, CorrectDigits& correct) {
  visit("digits", correct.digits);
  visit("until", correct.until);
}

template <class Visitor>
void fields(Visitor& visit, CertifiedDigits& certified) {
  visit("digits", certified.digits);
  visit("correct", certified.correct);
}

template <class Visitor>
void fields(Visitor& visit, CaseRow& row) {
  visit("name", row.name);
  visit("title", row.title);
  visit("cables", row.cables);
  visit("duration", row.duration);
  visit("ending", row.ending);
  visit("end_time", row.end_time);
  visit("horizon", row.horizon);
  visit("counted_impacts", row.counted_impacts);
  visit("start_energy", row.start_energy);
  visit("end_energy", row.end_energy);
  visit("settling", row.settling);
  visit("body", row.body);
  visit("gravity", row.gravity);
  visit("geometry", row.geometry);
  visit("extent", row.extent);
  visit("path", row.path);
  visit("events", row.events);
  visit("motions", row.motions);
  visit("certified", row.certified);
}

template <class Visitor>
void fields(Visitor& visit, Setting& setting) {
  visit("name", setting.name);
  visit("value", setting.value);
  visit("reason", setting.reason);
}

template <class Visitor>
void fields(Visitor& visit, Model& model) {
  visit("name", model.name);
  visit("sentence", model.sentence);
  visit("maker", model.maker);
  visit("settings", model.settings);
}

/// An engine that could not be asked has a name alone.
template <class Visitor>
void fields(Visitor& visit, EngineRow& engine) {
  visit("name", engine.name);
  visit.unless_missing("version", engine.info, [](auto& inside, EngineInfo& info) {
    inside("version", info.version);
    inside("precision", info.precision);
    inside("models", info.models);
  });
  visit("problem", engine.problem);
  visit("missing", engine.missing);
}

template <class Visitor>
void fields(Visitor& visit, MedianAndWorst& both) {
  visit("median", both.median);
  visit("worst", both.worst);
}

template <class Visitor>
void fields(Visitor& visit, SummaryRow& row) {
  fields(visit, row.key);
  visit("cases", row.cases);
  visit("failed", row.failed);
  visit.group("impacts", [&](auto& inside) {
    inside("exact", row.exact);
    inside("found", row.found);
    inside("matched", row.matched);
  });
  visit.group("settled", [&](auto& inside) {
    inside("exact", row.exact_settled);
    inside("found", row.found_settled);
  });
  visit.by_metric("metrics", row.metrics);
}

template <class Visitor>
void fields(Visitor& visit, Slope& slope) {
  visit("smallest", slope.smallest);
  visit("median", slope.median);
  visit("largest", slope.largest);
}

template <class Visitor>
void fields(Visitor& visit, ConvergenceRow& row) {
  visit("engine", row.engine);
  visit("model", row.model);
  visit("cases", row.cases);
  visit("cases_at_rounding", row.cases_at_rounding);
  visit("slope", row.slope);
}

template <class Visitor>
void fields(Visitor& visit, RunOfModel& run) {
  visit("case", run.the_case);
  visit("step", run.step);
}

template <class Visitor>
void fields(Visitor& visit, Finding& finding) {
  visit("engine", finding.engine);
  visit("model", finding.model);
  visit("kind", finding.kind);
  visit("sentence", finding.sentence);
  visit("value", finding.value);
  visit("unit", finding.unit);
  visit.group("evidence", [&](auto& inside) {
    inside("runs", finding.runs);
    inside("impacts", finding.impacts);
    inside("shown_in", finding.shown_in);
  });
}

template <class Visitor>
void fields(Visitor& visit, CausesRow& row) {
  fields(visit, row.key);
  visit("cases", row.cases);
  visit("deviation", row.deviation);
  visit("shares", row.shares);
  visit("covered", row.covered);
  visit("remainder", row.remainder);
}

template <class Visitor>
void fields(Visitor& visit, CostRow& row) {
  fields(visit, row.key);
  visit("cost_ratio", row.cost_ratio);
  visit("second_cost", row.second_cost);
  visit("second_spread", row.second_spread);
  visit("cases", row.cases);
}

template <class Visitor>
void fields(Visitor& visit, ReportOptions& options) {
  visit("steps", options.steps);
  visit("law", options.law);
  visit("count_speed", options.count_speed);
  visit("early_impacts", options.early_impacts);
  visit("time_limit", options.time_limit);
  visit("memory_limit", options.memory_limit);
  visit("certify", options.certify);
}

template <class Visitor>
void fields(Visitor& visit, LimitsSource& limits) {
  visit("file", limits.file);
  visit("version", limits.version);
}

template <class Visitor>
void fields(Visitor& visit, DistributionRow& row) {
  visit("name", row.statistic);
  visit("median", row.median);
  visit("distance", row.distance);
  visit("probability", row.probability);
  visit("visible", row.visible);
  visit("differs", row.differs);
}

template <class Visitor>
void fields(Visitor& visit, DistributionsRow& row) {
  fields(visit, row.key);
  visit("failed", row.failed);
  visit("statistics", row.statistics);
}

template <class Visitor>
void fields(Visitor& visit, Distributions::Statistic& statistic) {
  visit("name", statistic.name);
  visit("heading", statistic.heading);
  visit("unit", statistic.unit);
  visit("median", statistic.median);
}

template <class Visitor>
void fields(Visitor& visit, Distributions& distributions) {
  visit("case", distributions.the_case);
  visit("draws", distributions.draws);
  visit("deviation", distributions.deviation);
  visit("page", distributions.page);
  visit("statistics", distributions.statistics);
  visit("setups", distributions.setups);
}

template <class Visitor>
void fields(Visitor& visit, ShardRow& shard) {
  visit("number", shard.number);
  visit("of", shard.of);
  visit("command", shard.command);
  visit("started", shard.started);
  visit("elapsed", shard.elapsed);
  visit("processor", shard.processor);
  visit("cores", shard.cores);
}

template <class Visitor>
void fields(Visitor& visit, Context& context) {
  visit("command", context.command);
  visit("started", context.started);
  visit("elapsed", context.elapsed);
  visit("program_memory", context.program_memory);
  visit("worker_memory", context.worker_memory);
  visit("kept_runs", context.kept_runs);
  visit("processor", context.processor);
  visit("cores", context.cores);
  visit("compiler", context.compiler);
  visit("build_type", context.build_type);
  visit("flags", context.flags);
  visit("commit", context.commit);
  visit("costs", context.costs);
  visit("timing", context.timing);
  visit("shards", context.shards);
}

/// All of it but the form, the program and the list of metrics, which stand before.
template <class Visitor>
void fields(Visitor& visit, Report& report) {
  visit("complete", report.complete);
  visit("planned_runs", report.planned_runs);
  visit("options", report.options);
  visit("engines", report.engines);
  visit("cases", report.cases);
  visit("summary", report.summary);
  visit("convergence", report.convergence);
  visit("findings", report.findings);
  visit("causes", report.causes);
  visit("runs", report.runs);
  visit("limits", report.limits);
  visit.unless_missing(
      "distributions", report.distributions,
      [](auto& inside, Distributions& distributions) { inside("distributions", distributions); });
  visit("context", report.context);
}

}  // namespace tautline::bench
