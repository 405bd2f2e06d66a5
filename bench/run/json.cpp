#include "bench/run/json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "bench/base/json_list.hpp"
#include "bench/base/text.hpp"
#include "bench/check/claims.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr int engines_schema = 1;
constexpr int check_schema = 1;
constexpr int calibration_schema = 1;

constexpr std::size_t longest_sentence = 1000;  // [bytes], of what an engine makes long

ordered_json setting_json(const Setting& setting) {
  return {{"name", setting.name}, {"value", setting.value}, {"reason", setting.reason}};
}

ordered_json parameter_json(const Parameter& one) {
  return {{"name", one.name},
          {"low", one.low},
          {"high", one.high},
          {"scale", one.logarithmic ? "log" : "linear"},
          {"step_power", one.step_power}};
}

ordered_json model_json(const Model& model) {
  ordered_json row = {{"name", model.name},
                      {"sentence", model.sentence},
                      {"maker", to_string(model.maker)},
                      {"settings", json_list(model.settings, setting_json)}};
  if (!model.parameters.empty()) {
    row["parameters"] = json_list(model.parameters, parameter_json);
    row["code"] = model.code;
  }
  return row;
}

ordered_json engine_object(const EngineInfo& info) {
  return {{"name", info.name},
          {"version", info.version},
          {"precision", info.precision},
          {"models", json_list(info.models, model_json)}};
}

ordered_json row_of(const RegisteredEngine& engine) {
  ordered_json row =
      engine.info ? engine_object(*engine.info) : ordered_json{{"name", engine.name}};
  row["plugin"] = engine.plugin.string();
  row["failure"] = printable(engine.failure);
  row["missing"] = engine.missing;
  row["package"] = engine.package;
  return row;
}

/// A number that is not finite is null.
ordered_json claim_json(const SettledClaim& settled) {
  const Claim* const claim = find_claim(settled.claim);
  ordered_json row = {{"claim", settled.claim},
                      {"found", settled.found},
                      {"limit", settled.limit},
                      {"holds", settled.holds},
                      {"sentence", printable(settled.sentence, longest_sentence)},
                      {"claimed", claim != nullptr ? claim->sentence : quiet_sentence},
                      {"reason", claim != nullptr ? claim->reason : quiet_reason}};
  if (!settled.known.empty()) {
    row["known"] = printable(settled.known, longest_sentence);
  }
  return row;
}

ordered_json checked_json(const CheckedModel& model) {
  return {{"model", model.name},
          {"holds", broken_claims(model.claims).empty()},
          {"findings", json_list(model.claims, claim_json)}};
}

ordered_json held_out_json(const HeldOut& one) {
  return {{"speed", one.strike.speed},
          {"arm", one.strike.arm},
          {"inertia", one.strike.inertia},
          {"spin_part", one.strike.spin_part},
          {"restitution", one.restitution}};
}

}  // namespace

std::string engines_json(const std::vector<RegisteredEngine>& engines) {
  const ordered_json result = {{"schema", engines_schema}, {"engines", json_list(engines, row_of)}};
  return result.dump(2) + "\n";
}

std::string check_json(const RegisteredEngine& engine, const std::vector<CheckedModel>& models) {
  const bool all = std::all_of(models.begin(), models.end(), [](const CheckedModel& model) {
    return broken_claims(model.claims).empty();
  });
  const ordered_json result = {{"schema", check_schema},
                               {"engine",
                                {{"name", engine.info->name},
                                 {"version", engine.info->version},
                                 {"precision", engine.info->precision},
                                 {"plugin", engine.plugin.string()}}},
                               {"holds", all},
                               {"models", json_list(models, checked_json)}};
  return result.dump(2) + "\n";
}

std::string calibration_json(const RegisteredEngine& engine, const CalibrationRequest& request,
                             const Calibration& found) {
  ordered_json fixed = ordered_json::array();
  for (const auto& [name, value] : request.fixed) {
    fixed.push_back(name);
  }
  const ordered_json result = {{"schema", calibration_schema},
                               {"engine",
                                {{"name", engine.info->name},
                                 {"version", engine.info->version},
                                 {"plugin", engine.plugin.string()}}},
                               {"model", request.model.name},
                               {"restitution", request.restitution},
                               {"speeds", {request.slowest, request.fastest}},
                               {"step", request.step},
                               {"tolerance", request.tolerance},
                               {"reached", found.reached(request.tolerance)},
                               {"parameters", found.parameters},
                               {"fixed", std::move(fixed)},
                               {"code", printable(found.code, longest_sentence)},
                               {"worst", found.worst},
                               {"mean", found.mean},
                               {"held_out", json_list(found.held_out, held_out_json)},
                               {"not_reached", found.why},
                               {"evaluations", found.evaluations},
                               {"interrupted", found.interrupted}};
  return result.dump(2) + "\n";
}

}  // namespace tautline::bench
