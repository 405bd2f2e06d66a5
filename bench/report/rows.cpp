#include "bench/report/rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/base/text.hpp"
#include "bench/report/attribution_json.hpp"
#include "bench/report/replay_data.hpp"
#include "bench/solution/solution_json.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

template <class Value>
ordered_json or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json who(const ReferenceCase& reference, const EngineInfo& engine, const PlannedRun& run) {
  return {{"case", reference.the_case.name},
          {"engine", engine.name},
          {"model", run.model.name},
          {"step", run.step}};
}

/// When the exact motion first has a taut cable [s]; its end without one. A simulation
/// that does not follow the motion on taut cables may stop there.
double first_taut(const Solution& solution) {
  const auto& events = solution.events();
  const auto found = std::find_if(events.begin(), events.end(),
                                  [](const Event& event) { return event.kind == EventKind::taut; });
  return found != events.end() ? found->time : solution.end_time();
}

/// "finished", "stopped", "diverged" or "failed", and the reason of the last three.
std::pair<std::string, std::string> status(const ReferenceCase& reference, const RunReply& reply) {
  if (!reply.trajectory) {
    return {"failed", printable(reply.failure)};
  }
  const Trajectory& run = *reply.trajectory;
  if (run.diverged) {
    return {"diverged", fmt::format("the body left every reasonable range after t = {:.6g}",
                                    run.points.back().time)};
  }
  if (run.stop) {
    const bool early = !reaches(run, std::min(reference.horizon, first_taut(reference.solution)));
    return {early ? "failed" : "stopped",
            (early ? "gave up before the horizon: " : "") + printable(run.stop->reason)};
  }
  return {"finished", ""};
}

/// A number that is null where the run has no sample in the window.
ordered_json if_covered(const Deviation& deviation, double value) {
  return deviation.covered > 0.0 ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json window_json(const Metrics& metrics, std::size_t window) {
  const Deviation& deviation = metrics.deviation[window];
  const ImpactMatch& impacts = metrics.impacts[window];
  return {{"until", deviation.until},
          {"covered", deviation.covered},
          {"position_error", if_covered(deviation, deviation.position)},
          {"angle_error", if_covered(deviation, deviation.angle)},
          {"velocity_error", if_covered(deviation, deviation.velocity)},
          {"impacts",
           {{"exact", impacts.exact},
            {"found", impacts.found},
            {"matched", impacts.matched},
            {"missed", impacts.exact - impacts.matched},
            {"first_time_error", or_null(impacts.first_time_error)},
            {"worst_time_error", or_null(impacts.worst_time_error)}}}};
}

ordered_json settling_match_json(const Metrics& metrics) {
  ordered_json impacts = ordered_json::array();
  for (const LastImpactMatch& last : metrics.last_impacts) {
    impacts.push_back(
        {{"speed", last.speed}, {"exact", or_null(last.exact)}, {"found", or_null(last.found)}});
  }
  ordered_json swing = nullptr;
  if (const auto& match = metrics.swing) {
    swing = {{"from", match->from},
             {"until", match->until},
             {"energy", {{"exact", match->exact_energy}, {"found", match->energy}}},
             {"amplitude", {{"exact", match->exact_amplitude}, {"found", match->amplitude}}}};
  }
  return {{"last_impacts", std::move(impacts)},
          {"later_impacts", metrics.later_impacts},
          {"swing", std::move(swing)}};
}

ordered_json metrics_json(const Metrics& metrics) {
  ordered_json json;
  for (const Window window : windows) {
    json[std::string(to_string(window))] = window_json(metrics, static_cast<std::size_t>(window));
  }
  json["settling"] = settling_match_json(metrics);
  json["long_impacts"] = metrics.long_impacts;
  json["overstretch"] = metrics.overstretch;
  json["energy"] = {{"largest_gain", metrics.energy_gain}, {"error", metrics.energy_error}};
  json["restitution"] = nullptr;
  if (const auto& measured = metrics.restitution) {
    json["restitution"] = {{"count", measured->count},
                           {"smallest", measured->smallest},
                           {"mean", measured->mean},
                           {"largest", measured->largest},
                           {"worst_error", measured->worst}};
  }
  return json;
}

}  // namespace

ordered_json run_row(const ReferenceCase& reference, const EngineInfo& engine,
                     const PlannedRun& run, const RunReply& reply, const CompareOptions& options) {
  ordered_json row = who(reference, engine, run);
  const auto [word, reason] = status(reference, reply);
  row["status"] = word;
  row["reason"] = reason;
  row["output_tail"] = nullptr;
  if (!reply.trajectory && !reply.output_tail.empty()) {
    row["output_tail"] = printable(reply.output_tail.substr(
        reply.output_tail.size() - std::min(reply.output_tail.size(), quotable_length)));
  }
  row["metrics"] = nullptr;
  row["path"] = nullptr;
  row["impacts"] = nullptr;
  row["audit"] = nullptr;
  row["attribution"] = nullptr;
  if (reply.trajectory) {
    row["stride"] = reply.trajectory->stride;
    row["recorded_impacts"] = reply.trajectory->impacts.size();
    row["slow_impacts"] = reply.trajectory->slow_impacts;
    row["metrics"] =
        metrics_json(compare(reference.the_case, reference.solution, reference.settling,
                             reference.horizon, *reply.trajectory, options));
    row["path"] =
        run_path_json(reference.the_case, *reply.trajectory, run.path_samples, options.count_speed);
    row["impacts"] = run_impacts_json(reference.the_case, *reply.trajectory, options.count_speed);
    row["attribution"] = attribution_json(
        attribute(reference.the_case, reference.solution, reference.horizon, *reply.trajectory,
                  {reference.law, noise_of(engine.precision), options.count_speed}));
  }
  return row;
}

ordered_json timing_row(const ReferenceCase& reference, const EngineInfo& engine,
                        const PlannedRun& run, const RunReply& reply) {
  if (!reply.trajectory) {
    return nullptr;
  }
  ordered_json row = who(reference, engine, run);
  row["memory"] = reply.cost.memory;
  row["step_cost"] = reply.cost.step;
  row["reference_cost"] = reply.cost.reference;
  row["cost_ratio"] = reply.cost.reference > 0.0 ? reply.cost.step / reply.cost.reference : 0.0;
  return row;
}

ordered_json case_row(const ReferenceCase& reference, const CompareOptions& options) {
  const Solution& solution = reference.solution;
  const Case& the_case = reference.the_case;
  ordered_json row = {
      {"name", the_case.name},
      {"cables", the_case.cables.size()},
      {"duration", the_case.duration},
      {"ending", to_string(solution.ending())},
      {"end_time", solution.end_time()},
      {"horizon", reference.horizon},
      {"counted_impacts", counted_impacts(the_case, solution, options.count_speed).size()},
      {"start_energy", energy(the_case, the_case.initial)},
      {"end_energy", energy(the_case, solution.at(solution.end_time()))},
      {"settling", ordered_json::parse(settling_json(reference.settling))}};
  add_exact_motion(the_case, solution, row);
  return row;
}

}  // namespace tautline::bench
