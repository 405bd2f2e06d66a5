#pragma once

#include "bench/data/motion_fields.hpp"
#include "bench/report/json/fields_of_runs.hpp"
#include "bench/report/report.hpp"

// The members of every row of a report by their names in JSON, once for writing, for reading
// and for the schema: a visitor is called with each name, member, and what the schema says of it.
// `group` makes an object of members that are none of their own in C++; `drawn` a list of rows that
// have, each, what is drawn of them.

namespace tautline::bench {

template <class Visitor>
void fields(Visitor& visit, Swing& swing) {
  visit("energy", swing.energy, "above the equilibrium [J]");
  visit("period", swing.period, "[s]");
  visit("least", swing.least, "smallest angle [rad]");
  visit("largest", swing.largest, "[rad]");
  visit("amplitude", swing.amplitude, "half the difference [rad]");
}

template <class Visitor>
void fields(Visitor& visit, Lock& lock) {
  visit("time", lock.time, "from which on they are taut [s]");
  visit("uncertainty", lock.uncertainty, "of the time, rounding before it not counted [s]");
  visit("cables", lock.cables);
  visit("permanent", lock.permanent,
        "the body rests, or a whole period of its swing passes without a release");
  visit("rests", lock.rests);
  visit("swing", lock.swing, "of a body with one degree of freedom left");
}

template <class Visitor>
void fields(Visitor& visit, Settling& settling) {
  visit.means(
      "of the exact motion, by three definitions: the last fast impact, the final set of taut "
      "cables, the swing on it");
  visit("last_impacts", settling.last_impacts);
  visit("lock", settling.lock, "the final set of taut cables; null if all are slack at the end");
}

template <class Visitor>
void fields(Visitor& visit, CableRow& cable) {
  visit("anchor", cable.anchor);
  visit("attachment", cable.attachment);
  visit("length", cable.length);
  visit("restitution", cable.restitution, "null where it depends on the speed");
}

template <class Visitor>
void fields(Visitor& visit, FunctionRow::Piece& piece) {
  visit("from", piece.from, "[s]");
  visit("coefficients", piece.coefficients, "in rising order, of the time since `from`");
}

template <class Visitor>
void fields(Visitor& visit, FunctionRow::Wave& wave) {
  visit("amplitude", wave.amplitude);
  visit("frequency", wave.frequency, "[rad/s]");
  visit("phase", wave.phase, "at time 0 [rad]");
}

template <class Visitor>
void fields(Visitor& visit, FunctionRow& function) {
  visit.means(
      "numbers over time: the polynomial whose `from` is the last before the time, and the waves "
      "amplitude cos(frequency t + phase), summed");
  visit("pieces", function.pieces,
        "the last one lasts for ever; before the first one its value at `from` holds");
  visit("waves", function.waves);
}

template <class Visitor>
void fields(Visitor& visit, EndRow& end) {
  visit("body", end.body, "index; null: a point of the world");
  visit("at", end.at, "in the frame of the body, or in the world [m]");
  visit.unless_missing("motion", end.motion, [](auto& inside, FunctionRow& motion) {
    inside("motion", motion, "added to `at`, of a point of the world that moves [m]");
  });
}

template <class Visitor>
void fields(Visitor& visit, ElasticityRow& law) {
  visit("stiffness", law.stiffness,
        "of the stretch, of its square and so on [N/m, N/m^2, ...]; of the strain [N]");
  visit("of_strain", law.of_strain, "the force is one of the stretch over the length");
  visit("corners", law.corners,
        "stretch [m], or strain, and the stiffness from there on, in place of higher powers");
  visit("damping", law.damping, at_least(0, "[N s/m]"));
  visit("damping_ratio", law.damping_ratio, at_least(0, "in its place"));
  visit("cut", law.cut, one_of({"force", "stretch", "never"}));
}

template <class Visitor>
void fields(Visitor& visit, SystemCableRow& cable) {
  visit("from", cable.from);
  visit("through", cable.through, "rings, in order");
  visit("to", cable.to);
  visit("length", cable.length, "at the start [m]");
  visit("restitution", cable.restitution,
        "null where it depends on the speed, and of an elastic cable");
  visit.unless_missing("elasticity", cable.elasticity, [](auto& inside, ElasticityRow& law) {
    inside("elasticity", law, "how it stretches; it does not without this");
  });
  visit.unless_missing("length_over_time", cable.length_over_time,
                       [](auto& inside, FunctionRow& length) {
                         inside("length_over_time", length, "where it changes [m]");
                       });
  visit.unless_missing("from_time", cable.from_time, [](auto& inside, double& time) {
    inside("from_time", time, "when it is hooked up; it is there from the start without this [s]");
  });
  visit.unless_missing("cut_at", cable.cut_at, [](auto& inside, double& time) {
    inside("cut_at", time, "when it is cut; never without this [s]");
  });
}

template <class Visitor>
void fields(Visitor& visit, SystemBodyRow& body) {
  visit("name", body.name);
  visit("mass", body.mass);
  visit("inertia", body.inertia, "principal moments; three zeros: a point mass [kg m^2]");
}

template <class Visitor>
void fields(Visitor& visit, SystemRow& system) {
  visit.means("of a system in space, at the start");
  visit("hash", system.hash, "of its case file: equal where all numbers are");
  visit("bodies", system.bodies);
  visit("gravity", system.gravity, "[m/s^2]");
  visit("cables", system.cables);
}

template <class Visitor>
void fields(Visitor& visit, EventColumns& events) {
  visit("time", events.time);
  visit("kind", events.kind, one_of({"impact", "taut", "slack", "entry", "exit"}));
  visit("cables", events.cables);
  visit("rate", events.rate, "at which the fastest cable closes [m/s]; null of what is no impact");
  visit("left_out", events.left_out, "impacts that are not here, all slower than those that are");
}

template <class Visitor>
void fields(Visitor& visit, CertifiedDigits& certified) {
  visit("digits", certified.digits, at_least(20, "decimal, of the other solution's numbers"));
  visit("correct", certified.correct);
}

template <class Visitor>
void fields(Visitor& visit, Predictable& predictable) {
  visit.means("up to when a step-by-step model can follow the case, from its exact motion alone");
  visit("step", predictable.step, "[s]");
  visit("until", predictable.until, "[s]");
  visit("barrier", predictable.barrier,
        "why not for longer: the exact motion or its horizon ends; the plain scheme is not run for "
        "more steps; what a step may be off by has "
        "grown to a tenth of the shortest cable; or sound models may part");
  visit("readable", predictable.readable,
        "impacts of the exact motion whose restitution a run of this step can be read by");
}

template <class Visitor>
void fields(Visitor& visit, StepNeeded& needed) {
  visit.means(
      "the largest steps with which a step-by-step model is off by no more than `part`, from what "
      "a plain correct scheme is off by over shifts of its first step");
  visit("part", needed.part, "of the shortest cable [-]");
  visit("until", needed.until, "up to here [s]");
  visit("safe", needed.safe,
        "by the worst of the shifts [s]; below 1e-5 a guess; 0 where the law of impact leaves it "
        "unknown");
  visit("typical", needed.typical, "by their mean [s], the same");
}

template <class Visitor>
void fields(Visitor& visit, CaseRow& row, CaseReplay& replay) {
  visit("name", row.name);
  visit("title", row.title, "what tells the case from others, in words");
  visit("cables", row.cables, in_range(1, 8));
  visit("duration", row.duration, above(0));
  visit("ending", row.ending,
        one_of({"reached_duration", "rest", "unstable_rest", "angle_limit", "ceiling", "singular",
                "event_limit", "step_limit", "no_progress", "overflow"}));
  visit("end_time", row.end_time, "of the exact solution [s]");
  visit("horizon", row.horizon, "predictability horizon [s]");
  visit("counted_impacts", row.counted_impacts);
  visit("start_energy", row.start_energy);
  visit("end_energy", row.end_energy);
  visit("settling", row.settling);
  visit.unless_missing("body", row.plane, [](auto& inside, PlaneRow& plane) {
    inside("body", plane.body);
    inside("gravity", plane.gravity);
    inside("geometry", plane.geometry);
  });
  visit.unless_missing("system", row.system,
                       [](auto& inside, SystemRow& system) { inside("system", system); });
  visit("extent", row.extent,
        "what the anchors and the exact motion cover, the wider of width and height [m]");
  visit("path", replay.path);
  visit("events", replay.events,
        "of the exact motion, a column each; of thousands the fastest impacts");
  visit("motions", row.motions,
        "the file next to the report with the motions of the case's runs, a script that calls "
        "tautline.motionsCame(file, [{engine, model, step, path, impacts}, ...]); null where they "
        "are in the page");
  visit("certified", row.certified,
        "until when the exact solution in double is right, compared with the same motion in many "
        "digits; null where it was not asked for");
  visit("predictable", row.predictable);
  visit.unless_missing("step_needed", row.step_needed,
                       [](auto& inside, StepNeeded& needed) { inside("step_needed", needed); });
}

template <class Visitor>
void fields(Visitor& visit, Setting& setting) {
  visit("name", setting.name);
  visit("value", setting.value);
  visit("reason", setting.reason);
  visit("origin", setting.origin,
        "whose choice the value is: the engine's default, its demo's where it has no default, or "
        "ours");
}

template <class Visitor>
void fields(Visitor& visit, Model& model) {
  visit("name", model.name);
  visit("sentence", model.sentence);
  visit("maker", model.maker,
        "whose the cable is: as shipped, built by hand with the engine's parts, or tautline's "
        "driver");
  visit("settings", model.settings, "every setting that is not left alone");
  visit.unless_missing(
      "in_space", model.in_space, [](auto& inside, std::vector<Setting>& settings) {
        inside("in_space", settings,
               "what is set for a system in space, in place of settings of the same name");
      });
  std::optional<Cables> cables;
  if (model.cables != Cables::inextensible) {
    cables = model.cables;
  }
  visit.unless_missing("cables", cables, [](auto& inside, Cables& word) {
    inside("cables", word,
           "the cables of the cases that it runs: all inextensible where this is missing, elastic "
           "one or more, any both");
  });
  model.cables = cables.value_or(Cables::inextensible);
}

/// An engine that could not be asked has a name alone.
template <class Visitor>
void fields(Visitor& visit, EngineRow& engine) {
  visit("name", engine.name);
  visit.unless_missing("version", engine.info, [](auto& inside, EngineInfo& info) {
    inside("version", info.version);
    inside("precision", info.precision, one_of({"float64", "float32"}));
    inside("models", info.models);
  });
  visit("problem", engine.problem, "why there are no runs of it");
  visit("missing", engine.missing, "there is no plug-in, as opposed to one that failed");
}

template <class Visitor>
void fields(Visitor& visit, MedianAndWorst& both) {
  visit.means("over some cases; null if none has a value");
  visit("median", both.median, "null of an extreme, which has a worst value alone");
  visit("worst", both.worst);
}

template <class Visitor>
void fields(Visitor& visit, SummaryRow& row) {
  fields(visit, row.key);
  visit("cases", row.cases);
  visit("failed", row.failed, "of the cases");
  visit.group("impacts", "counted, up to the horizon", [&](auto& inside) {
    inside("exact", row.exact);
    inside("found", row.found);
    inside("matched", row.matched);
  });
  visit.group("settled", "the last impact faster than the first threshold of settling",
              [&](auto& inside) {
                inside("exact", row.exact_settled, "cases whose exact motion has one and locks");
                inside("found", row.found_settled, "runs that have one");
              });
  ByMetric<decltype(row.metrics)> metrics{row.metrics};
  visit("metrics", metrics,
        "of every metric, median and worst over the cases; null of one that does not "
        "come to one number over cases");
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
  visit.means("what a model does to impacts, found from its runs");
  visit("engine", finding.engine);
  visit("model", finding.model);
  visit("kind", finding.kind, one_of({finding_kinds.begin(), finding_kinds.end()}));
  visit("sentence", finding.sentence);
  visit("value", finding.value);
  visit("unit", finding.unit);
  visit.group("evidence", "", [&](auto& inside) {
    inside("runs", finding.runs);
    inside("impacts", finding.impacts);
    inside("shown_in", finding.shown_in,
           "the runs of the model that show it: none of them passes, at any limits, except for "
           "several-steps");
  });
}

template <class Visitor>
void fields(Visitor& visit, ModelJudgement& model) {
  visit.means("what is said of a model over all cases, at the finest step that it was run with");
  visit("engine", model.engine);
  visit("model", model.model);
  visit("step", model.step, "[s]");
  visit("cases", model.cases);
  visit("restitution", model.rebounds);
  visit("course", model.course, "how its error changes with the step, in the worst case");
  visit("told", model.told, "cases in which the position tells something");
  visit("ratio", model.ratio, "the largest ratio of a run; null where nothing can be told");
  visit("worst_case", model.worst_case, "the case with this ratio");
  visit("error", model.error, "of the position there [m]");
  visit("time", model.time, "then [s]");
  visit("impacts", model.impacts);
  visit("overstretch", model.overstretch, "the largest of a run");
  visit("energy", model.energy, "the largest of a run");
  visit("flight", model.flight, "the largest of a run");
  visit.unless_missing("rotation", model.rotation, [](auto& inside, double& rotation) {
    inside("rotation", rotation, "the largest of a run of a system");
  });
}

template <class Visitor>
void fields(Visitor& visit, CausesRow& row) {
  fields(visit, row.key);
  visit("cases", row.cases, "with parts");
  visit("deviation", row.deviation);
  visit("shares", row.shares,
        "of the sum of the sizes of all parts, mean over the cases [-]: they add up to 1");
  visit("covered", row.covered,
        in_range(0, 1,
                 "the part of the horizon that is attributed, median over the cases; what happens "
                 "later has no share"));
  visit("remainder", row.remainder, "largest, as a share of its deviation");
  visit.unless_missing("model_share", row.model_share, [](auto& inside, double& share) {
    inside("model_share", share,
           in_range(0, 1,
                    "where cables are springs and dampers of the engine, what these do in place of "
                    "the cables, of the sizes of that and of what else it does; mean over the "
                    "cases"));
  });
}

template <class Visitor>
void fields(Visitor& visit, CostRow& row) {
  fields(visit, row.key);
  visit("cost_ratio", row.cost_ratio, "median over the cases");
  visit("second_cost", row.second_cost,
        "processor time of one simulated second, median over the cases [s]");
  visit("second_spread", row.second_spread, "of that over the cases [s]");
  visit("cases", row.cases, at_least(1));
}

template <class Visitor>
void fields(Visitor& visit, ReportOptions& options) {
  visit("steps", options.steps, above(0, "[s]").not_empty());
  visit("law", options.law, one_of({"simultaneous", "poisson", "sequential", "energetic"}));
  visit("count_speed", options.count_speed, "impacts slower than this are not counted [m/s]");
  visit("early_impacts", options.early_impacts);
  visit("time_limit", options.time_limit, "on one run [s]");
  visit("memory_limit", options.memory_limit, "on one run [bytes]");
  visit("certify", options.certify, "true where each case was also solved in many digits");
}

template <class Visitor>
void fields(Visitor& visit, ProblemsSource& listed) {
  visit("file", listed.file);
  visit("version", listed.version);
}

template <class Visitor>
void fields(Visitor& visit, DistributionRow& row) {
  visit("name", row.statistic);
  visit("median", row.median);
  visit("distance", row.distance,
        in_range(0, 1,
                 "largest distance between the distribution functions, from the exact motions "
                 "(Kolmogorov and Smirnov)"));
  visit("probability", row.probability,
        in_range(0, 1,
                 "of a distance as large by chance, of this or the energy distance, corrected for "
                 "all tests together (Holm)"));
  visit("visible", row.visible,
        in_range(0, 1, "the smallest distance that would be called a difference"));
  visit("differs", row.differs);
}

template <class Visitor>
void fields(Visitor& visit, DistributionsRow& row) {
  fields(visit, row.key);
  visit("failed", row.failed, "draws without values");
  visit("statistics", row.statistics);
}

template <class Visitor>
void fields(Visitor& visit, Distributions::Statistic& statistic) {
  visit("name", statistic.name);
  visit("heading", statistic.heading);
  visit("unit", statistic.unit, "empty of a count or a share");
  visit("median", statistic.median, "of the exact motions");
}

template <class Visitor>
void fields(Visitor& visit, Distributions& distributions) {
  visit.means(
      "many draws of one case, by the exact solver and by engines, compared as distributions");
  visit("case", distributions.the_case);
  visit("draws", distributions.draws, at_least(1));
  visit("deviation", distributions.deviation,
        above(0,
              "standard deviation of each number of the start about the case's own [m], [rad], "
              "[m/s], [rad/s]"));
  visit("page", distributions.page, "a file next to the report");
  visit("statistics", distributions.statistics);
  visit("setups", distributions.setups);
}

template <class Visitor>
void fields(Visitor& visit, ShardRow& shard) {
  visit("number", shard.number, at_least(1));
  visit("of", shard.of, at_least(1));
  visit("command", shard.command);
  visit("started", shard.started);
  visit("elapsed", shard.elapsed, "0 where it did not come to its end [s]");
  visit("processor", shard.processor);
  visit("cores", shard.cores);
}

template <class Visitor>
void fields(Visitor& visit, Context& context) {
  visit("command", context.command);
  visit("started", context.started);
  visit("elapsed", context.elapsed, "[s]");
  visit("program_memory", context.program_memory, "the most the program held at once [bytes]");
  visit("worker_memory", context.worker_memory, "the most one worker process held [bytes]");
  visit("kept_runs", context.kept_runs);
  visit("processor", context.processor);
  visit("cores", context.cores);
  visit("compiler", context.compiler);
  visit("build_type", context.build_type);
  visit("flags", context.flags, "of the compiler");
  visit("commit", context.commit,
        "of the source, followed by -dirty if it was changed since; unknown outside git");
  visit("costs", context.costs);
  visit("timing", context.timing);
  visit("shards", context.shards,
        "the parts that `tautline merge` put together; none where one machine did all");
}

/// All of it but the form, the program and the list of metrics, which stand before.
template <class Visitor>
void fields(Visitor& visit, Report& report, Replay& replay) {
  visit("complete", report.complete, "false if the suite was interrupted");
  visit("planned_runs", report.planned_runs);
  visit("options", report.options);
  visit("engines", report.engines);
  visit.drawn("cases", report.cases, replay.cases);
  visit("summary", report.summary);
  visit("convergence", report.convergence);
  visit("models", report.models);
  visit("findings", report.findings);
  visit("causes", report.causes);
  visit.drawn("runs", report.runs, replay.runs);
  visit("listed", report.listed, "where listed problems come from; null without verdicts");
  visit.unless_missing("distributions", report.distributions,
                       [](auto& inside, Distributions& distributions) {
                         inside("distributions", distributions,
                                "of many draws of one case; only where they were asked for");
                       });
  visit("context", report.context, "what differs from machine to machine and from day to day");
}

}  // namespace tautline::bench
