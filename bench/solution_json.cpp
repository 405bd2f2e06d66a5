#include "bench/solution_json.hpp"

#include "bench/text.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

using Json = nlohmann::ordered_json;

Json pair_json(const Vec2& value) { return Json::array({value.x(), value.y()}); }

Json cable_json(const Cable& cable) {
  return {{"anchor", pair_json(cable.anchor)},
          {"attachment", pair_json(cable.attachment)},
          {"length", cable.length},
          {"restitution", cable.restitution}};
}

Json event_json(const Event& event) {
  Json impulses = Json::array();
  for (const double impulse : event.impulses) {
    impulses.push_back(impulse);
  }
  return {{"time", event.time},
          {"kind", to_string(event.kind)},
          {"cables", event.cables.indices()},
          {"impulses", std::move(impulses)},
          {"before", state_json(event.before)},
          {"after", state_json(event.after)}};
}

Json accumulation_json(const Accumulation& accumulation) {
  return {{"time", accumulation.time},
          {"uncertainty", accumulation.uncertainty},
          {"cables", accumulation.cables.indices()},
          {"state", state_json(accumulation.state)},
          {"energy", accumulation.energy}};
}

Json sample_json(double time, const State& state) {
  Json result = {{"time", time}};
  result.update(state_json(state));
  return result;
}

}  // namespace

Json state_json(const State& state) {
  return {{"position", pair_json(state.position)},
          {"angle", state.angle},
          {"velocity", pair_json(state.velocity)},
          {"spin", state.spin}};
}

Json case_json(const Case& the_case) {
  Json result = {{"name", the_case.name},
                 {"duration", the_case.duration},
                 {"gravity", pair_json(the_case.gravity)}};
  if (the_case.angle_limit) {
    result["angle_limit"] = *the_case.angle_limit;
  }
  if (the_case.ceiling) {
    result["ceiling"] = *the_case.ceiling;
  }
  result["body"] = {{"mass", the_case.body.mass}, {"inertia", the_case.body.inertia}};
  result["cables"] = Json::array();
  for (const Cable& cable : the_case.cables) {
    result["cables"].push_back(cable_json(cable));
  }
  result["initial"] = state_json(the_case.initial);
  return result;
}

std::vector<std::string> sample_problems(const Solution& solution,
                                         std::span<const double> sample_times) {
  std::vector<std::string> result;
  for (const double time : sample_times) {
    if (!(time >= 0.0 && time <= solution.end_time())) {
      result.push_back("sample time " + shortest(time) + " is outside [0, " +
                       shortest(solution.end_time()) + "]: the solution ends there (" +
                       std::string(to_string(solution.ending())) + ")");
    }
  }
  return result;
}

Json solution_json(const Case& the_case, const SolveOptions& options, const Solution& solution,
                   std::span<const double> sample_times) {
  const State end_state = solution.at(solution.end_time());
  Json result = {
      {"schema", solution_schema},
      {"case", case_json(the_case)},
      {"options", {{"capture_speed", options.capture_speed}, {"max_events", options.max_events}}},
      {"events", Json::array()},
      {"ending", to_string(solution.ending())},
      {"end_time", solution.end_time()},
      {"end_state", state_json(end_state)},
      {"energy",
       {{"start", energy(the_case, the_case.initial)}, {"end", energy(the_case, end_state)}}}};
  for (const Event& event : solution.events()) {
    result["events"].push_back(event_json(event));
  }
  if (solution.accumulation()) {
    result["accumulation"] = accumulation_json(*solution.accumulation());
  }
  if (!sample_times.empty()) {
    result["samples"] = Json::array();
    for (const double time : sample_times) {
      result["samples"].push_back(sample_json(time, solution.at(time)));
    }
  }
  return result;
}

}  // namespace tautline::bench
