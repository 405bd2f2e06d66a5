#include "bench/solution/solution_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/base/json_list.hpp"
#include "bench/base/text.hpp"
#include "bench/solution/samples/samples.hpp"
#include "bench/solution/samples/taut_phases.hpp"
#include "bench/solution/time_errors.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {
namespace {

using Json = nlohmann::ordered_json;

Json pair_json(const Vec2& value) { return Json::array({value.x(), value.y()}); }

Json state_json(const State& state) {
  return {{"position", pair_json(state.position)},
          {"angle", state.angle},
          {"velocity", pair_json(state.velocity)},
          {"spin", state.spin}};
}

Json cable_json(const Cable& cable) {
  Json result = {{"anchor", pair_json(cable.anchor)},
                 {"attachment", pair_json(cable.attachment)},
                 {"length", cable.length},
                 {"restitution", cable.restitution}};
  if (cable.capture_speed != 0.0) {  // exactly: the default
    result["capture_speed"] = cable.capture_speed;
  }
  for (const RestitutionPoint& point : cable.restitution_table) {
    result["restitution_table"].push_back(pair_json({point.speed, point.restitution}));
  }
  return result;
}

Json errors_json(const EventErrors& errors) {
  return {{"time", errors.time},
          {"impulses", json_list(errors.impulses, [](double impulse) { return Json(impulse); })},
          {"before", state_json(errors.before)},
          {"after", state_json(errors.after)}};
}

Json event_json(const Event& event, const std::optional<EventErrors>& errors, CableSet split) {
  const auto pull = [](double impulse) { return Json(std::max(impulse, 0.0)); };  // or gravity's
  Json result = {{"time", event.time},
                 {"kind", to_string(event.kind)},
                 {"cables", event.cables.indices()},
                 {"impulses", json_list(event.impulses, pull)},
                 {"before", state_json(event.before)},
                 {"after", state_json(event.after)},
                 {"errors", errors ? errors_json(*errors) : Json(nullptr)}};
  if (!split.empty()) {
    result["indeterminate"] = split.indices();
  }
  return result;
}

/// A bound, null where there is none.
Json bound_json(const std::optional<double>& error) { return error ? Json(*error) : Json(nullptr); }

Json accumulation_json(const Accumulation& accumulation, const std::optional<double>& error) {
  return {{"start", accumulation.start},
          {"time", accumulation.time},
          {"uncertainty", bound_json(error)},
          {"cables", accumulation.cables.indices()},
          {"energy_lost", accumulation.energy_lost}};
}

Json swing_json(const Swing& swing) {
  const auto angle = [&](double value) { return swing.goes_round ? Json(nullptr) : Json(value); };
  return {{"energy", swing.energy},
          {"period", swing.period},
          {"least", angle(swing.least)},
          {"largest", angle(swing.largest)},
          {"amplitude", angle(swing.amplitude)},
          {"angle_of", swing.angle == SwingAngle::body ? "body" : "cable"},
          {"goes_round", swing.goes_round}};
}

Json lock_json(const Lock& lock, const std::optional<double>& error) {
  return {{"time", lock.time},
          {"uncertainty", bound_json(error)},
          {"cables", lock.cables.indices()},
          {"permanent", lock.permanent},
          {"rests", lock.rests},
          {"swing", lock.swing ? swing_json(*lock.swing) : Json(nullptr)}};
}

Json mark_json(const std::optional<EventMark>& mark) {
  if (!mark) {
    return nullptr;
  }
  return {
      {"time", mark->time}, {"kind", to_string(mark->kind)}, {"cables", mark->cables.indices()}};
}

/// The numbers of a cable, or their errors, one list for each kind.
template <class Number>
void add_cables(Json& object, const MotionSample& sample, const Number& number) {
  const auto list = [&](Bounded CableSample::*member) {
    return json_list(sample.cables,
                     [&](const CableSample& cable) { return Json(number(cable.*member)); });
  };
  object["gaps"] = list(&CableSample::gap);
  object["gap_rates"] = list(&CableSample::gap_rate);
  object["tensions"] = list(&CableSample::tension);
  object["energy"] = number(sample.energy);
}

Json sample_json(const MotionSample& sample) {
  Json result = {{"time", sample.time.value}};
  result.update(state_json(sample.state));
  add_cables(result, sample, [](const Bounded& one) { return one.value; });
  result["errors"] = nullptr;
  if (sample.errors) {
    result["errors"] = state_json(*sample.errors);
    add_cables(result["errors"], sample, [](const Bounded& one) { return one.error; });
  }
  return result;
}

Json tie_json(const Tie& tie) {
  return {{"kind", to_string(tie.kind)}, {"cables", tie.cables.indices()}};
}

Json bounded_json(const Bounded& one) {
  return {{"value", one.value}, {"error", one.error < 0.0 ? Json(nullptr) : Json(one.error)}};
}

Json tension_at_json(const TensionAt& extreme) {
  return {{"tension", bounded_json(extreme.tension)}, {"time", bounded_json(extreme.time)}};
}

Json phase_json(const TautPhase& phase) {
  return {{"cable", phase.cable},
          {"from", phase.from.value},
          {"until", phase.until.value},
          {"least", tension_at_json(phase.least)},
          {"largest", tension_at_json(phase.largest)},
          {"indeterminate", phase.indeterminate}};
}

Json period_json(const PeriodTension& one) {
  return {{"cable", one.cable},
          {"least", bounded_json(one.least)},
          {"largest", bounded_json(one.largest)}};
}

Json unsure_json(const Unsure& stretch) {
  return {{"from", stretch.from},
          {"until", std::isfinite(stretch.until) ? Json(stretch.until) : Json(nullptr)},
          {"tie", stretch.tie ? tie_json(*stretch.tie) : Json(nullptr)}};
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
  result["cables"] = json_list(the_case.cables, cable_json);
  result["initial"] = state_json(the_case.initial);
  return result;
}

Json last_impact_json(const LastImpact& last) {
  return {{"speed", last.speed}, {"time", last.time ? Json(*last.time) : Json(nullptr)}};
}

/// `error` is that of the time of the lock.
Json settling_json(const Settling& settling, const std::optional<double>& error) {
  return {{"last_impacts", json_list(settling.last_impacts, last_impact_json)},
          {"lock", settling.lock ? lock_json(*settling.lock, error) : Json(nullptr)}};
}

Json ledger_json(const EnergyLedger& ledger) {
  return {{"start", ledger.start},
          {"impacts", ledger.impacts},
          {"completions", ledger.completions},
          {"end", ledger.end},
          {"residual", ledger.residual}};
}

Json correct_json(const CorrectDigits& part) {
  return {{"digits", part.digits}, {"until", part.until ? Json(*part.until) : Json(nullptr)}};
}

Json certificate_json(const Certificate& certificate) {
  const std::optional<Lock>& lock = certificate.settling.lock;  // without rounding to speak of
  const auto error = lock ? std::optional(lock->uncertainty) : std::nullopt;
  const EventMatch& events = certificate.events;
  return {{"digits", certificate.digits},
          {"completion_error", certificate.completion_error},
          {"correct", json_list(certificate.correct, correct_json)},
          {"events",
           {{"same", events.count},
            {"until", events.until},
            {"all", events.all},
            {"next_in_double", mark_json(events.in_double)},
            {"next_in_digits", mark_json(events.in_digits)},
            {"in_digits", certificate.event_count}}},
          {"ending", to_string(certificate.ending)},
          {"end_time", certificate.end_time},
          {"energy", ledger_json(certificate.energy)},
          {"settling", settling_json(certificate.settling, error)}};
}

/// `object` with a line for each of its values, and for each element where that is a list: an event
/// by itself is read at a glance, and indents would nearly double what a long motion takes.
std::string in_lines(const Json& object) {
  std::string result;
  for (const auto& [key, value] : object.items()) {
    result += (result.empty() ? "{\n  " : ",\n  ") + Json(key).dump() + ": ";
    if (!value.is_array() || value.empty()) {
      result += value.dump();
      continue;
    }
    const char* before = "[\n    ";
    for (const Json& element : value) {
      result += before + element.dump();
      before = ",\n    ";
    }
    result += "\n  ]";
  }
  return result + "\n}\n";
}

}  // namespace

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

std::string solution_json(const Case& the_case, const SolveOptions& options,
                          const Solution& solution, const Settling& settling,
                          std::span<const double> sample_times,
                          const std::optional<Certificate>& certificate) {
  const State end_state = solution.at(solution.end_time());
  const Uncertainty uncertainty(the_case, solution, options);
  Json result = {
      {"schema", solution_schema},
      {"case", case_json(the_case)},
      {"options",
       {{"law", to_string(options.law)},
        {"completion_error", options.completion.error},
        {"max_events", options.max_events},
        {"max_steps", options.max_steps}}},
      {"events", Json::array()},
      {"ending", to_string(solution.ending())},
      {"end_time", solution.end_time()},
      {"end_state", state_json(end_state)},
      {"energy", ledger_json(energy_ledger(the_case, solution))},
      {"settling", settling_json(settling, lock_error(solution, settling, uncertainty))}};
  for (std::size_t index = 0; index < solution.events().size(); ++index) {
    result["events"].push_back(
        event_json(solution.events()[index], uncertainty.events()[index],
                   indeterminate(options.law, the_case, solution.events()[index])));
  }
  if (settling.lock && settling.lock->swing) {
    const auto tensions = period_tensions(the_case, solution.events().back().after,
                                          settling.lock->cables, *settling.lock->swing,
                                          uncertainty.energy(solution.end_time()).value_or(-1.0));
    result["settling"]["lock"]["swing"]["tensions"] = json_list(tensions, period_json);
  }
  result["unsure"] = json_list(uncertainty.unsure(), unsure_json);
  result["accumulations"] = json_list(solution.accumulations(), [&](const Accumulation& one) {
    return accumulation_json(one, limit_error(solution, uncertainty, one));
  });
  result["taut"] = json_list(taut_phases(the_case, solution, uncertainty), phase_json);
  if (!sample_times.empty()) {
    result["samples"] = json_list(sample_times, [&](double time) {
      return sample_json(sample_at(the_case, solution, uncertainty, time));
    });
  }
  if (certificate) {
    result["certificate"] = certificate_json(*certificate);
  }
  return in_lines(result);
}

}  // namespace tautline::bench
