#pragma once

#include "bench/report/record.hpp"
#include "bench/report/report.hpp"

// The members of all that a run leaves by their names in JSON, once for writing and for reading: a
// visitor is called with each name and member. `group` makes an object of members that are
// none of their own in C++; `by_metric` one with a key for every metric of the list.

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, RunKey& key) {
  visit("case", key.the_case);
  visit("engine", key.engine);
  visit("model", key.model);
  visit("step", key.step);
}

template <class Visitor>
void fields(Visitor& visit, SetupKey& key) {
  visit("engine", key.engine);
  visit("model", key.model);
  visit("step", key.step);
}

template <class Visitor>
void fields(Visitor& visit, GridColumn& column) {
  visit("start", column.start);
  visit("scale", column.scale);
  visit("steps", column.steps);
}

template <class Visitor>
void fields(Visitor& visit, TautColumns& cable) {
  visit("times", cable.times);
  visit("gap_times", cable.gap_times);
  visit("gap", cable.gap);
}

template <class Visitor>
void fields(Visitor& visit, Path& path) {
  visit("error", path.error);
  visit("spacing", path.spacing);
  visit("time", path.time);
  visit("x", path.x);
  visit("y", path.y);
  visit("angle", path.angle);
  visit("x_bends", path.x_bends);
  visit("y_bends", path.y_bends);
  visit("angle_bends", path.angle_bends);
  visit("energy_error", path.energy_error);
  visit("energy_time", path.energy_time);
  visit("energy", path.energy);
  visit("cables", path.cables);
}

template <class Visitor>
void fields(Visitor& visit, ImpactColumns& impacts) {
  visit("time", impacts.time);
  visit("cable", impacts.cable);
  visit("requested", impacts.requested);
  visit("rate_before", impacts.rate_before);
  visit("rate_after", impacts.rate_after);
  visit("arm", impacts.arm);
  visit("tangential_error", impacts.tangential_error);
  visit("angular_error", impacts.angular_error);
  visit("steps", impacts.steps);
  visit("left_out", impacts.left_out);
}

template <class Visitor>
void fields(Visitor& visit, RunDetails::OfWindow& window) {
  visit("until", window.until);
  visit("covered", window.covered);
  visit("exact", window.exact);
  visit("found", window.found);
  visit("matched", window.matched);
}

template <class Visitor>
void fields(Visitor& visit, LastImpactMatch& last) {
  visit("speed", last.speed);
  visit("exact", last.exact);
  visit("found", last.found);
}

template <class Visitor>
void fields(Visitor& visit, ExactAndFound& both) {
  visit("exact", both.exact);
  visit("found", both.found);
}

template <class Visitor>
void fields(Visitor& visit, SwingMatch& swing) {
  visit("from", swing.from);
  visit("until", swing.until);
  visit("energy", swing.energy);
  visit("amplitude", swing.amplitude);
}

/// Its worst error is a metric of the list.
template <class Visitor>
void fields(Visitor& visit, MeasuredRestitution& measured) {
  visit("count", measured.count);
  visit("smallest", measured.smallest);
  visit("mean", measured.mean);
  visit("largest", measured.largest);
}

template <class Visitor>
void fields(Visitor& visit, RunDetails& details) {
  visit("early", details.of_windows[0]);
  visit("horizon", details.of_windows[1]);
  visit("whole", details.of_windows[2]);
  visit("last_impacts", details.last_impacts);
  visit("swing", details.swing);
  visit("restitution", details.restitution);
  visit("stride", details.stride);
  visit("recorded_impacts", details.recorded_impacts);
  visit("slow_impacts", details.slow_impacts);
}

template <class Visitor>
void fields(Visitor& visit, Ladder& ladder) {
  visit("cable", ladder.cable);
  visit("exact_ratio", ladder.exact_ratio);
  visit("heights", ladder.heights);
  visit("exact", ladder.exact);
}

template <class Visitor>
void fields(Visitor& visit, Scatter& scatter) {
  visit("count", scatter.count);
  visit("mean", scatter.mean);
  visit("standard_deviation", scatter.standard_deviation);
  visit("smallest", scatter.smallest);
  visit("largest", scatter.largest);
}

template <class Visitor>
void fields(Visitor& visit, Attribution& attribution) {
  visit("until", attribution.until);
  visit("covered", attribution.covered);
  visit("deviation", attribution.deviation);
  visit("parts", attribution.parts);
  visit("remainder", attribution.remainder);
  visit("arcs", attribution.arcs);
  visit("impacts", attribution.impacts);
  visit("reason", attribution.reason);
}

template <class Visitor>
void fields(Visitor& visit, Check& check) {
  visit("metric", check.metric);
  visit("value", check.value);
  visit("limit", check.limit);
  visit("holds", check.holds);
  visit("known", check.known);
  visit("reason", check.reason);
}

template <class Visitor>
void fields(Visitor& visit, Verdict& verdict) {
  visit("word", verdict.word);
  visit("reason", verdict.reason);
  visit("checks", verdict.checks);
}

template <class Visitor>
void fields(Visitor& visit, RunRow& row) {
  fields(visit, row.key);
  visit("status", row.status);
  visit("reason", row.reason);
  visit("output_tail", row.output_tail);
  visit.by_metric("metrics", row.metrics);
  visit("details", row.details);
  visit("path", row.path);
  visit("impacts", row.impacts);
  visit.group("audit", [&](auto& inside) {
    inside("ladder", row.ladder);
    inside("scatter", row.scatter);
  });
  visit("attribution", row.attribution);
  visit("verdict", row.verdict);
}

template <class Visitor>
void fields(Visitor& visit, Spread& spread) {
  visit("smallest", spread.smallest);
  visit("lower", spread.lower);
  visit("upper", spread.upper);
}

template <class Visitor>
void fields(Visitor& visit, TimingRow& row) {
  fields(visit, row.key);
  visit("memory", row.memory);
  visit("step_cost", row.step_cost);
  visit("reference_cost", row.reference_cost);
  visit("cost_ratio", row.cost_ratio);
  visit("second_cost", row.second_cost);
  visit("second_spread", row.second_spread);
  visit("repetitions", row.repetitions);
}

template <class Visitor>
void fields(Visitor& visit, AuditedImpact& impact) {
  visit("speed", impact.speed);
  visit("requested", impact.requested);
  visit("effective", impact.effective);
  visit("arm", impact.arm);
  visit("across", impact.across);
  visit("turning", impact.turning);
  visit("rate_floor", impact.rate_floor);
  visit("steps", impact.steps);
}

template <class Visitor>
void fields(Visitor& visit, Freeze& freeze) {
  visit("moving", freeze.moving);
  visit("time", freeze.time);
  visit("lost", freeze.lost);
}

template <class Visitor>
void fields(Visitor& visit, RunAudit& audit) {
  visit("ladder", audit.ladder);
  visit("scatter", audit.scatter);
  visit("impacts", audit.impacts);
  visit("freeze", audit.freeze);
}

template <class Visitor>
void fields(Visitor& visit, RunRecord& record) {
  visit("row", record.row);
  visit("timing", record.timing);
  visit("audit", record.audit);
}

}  // namespace tautline::bench
