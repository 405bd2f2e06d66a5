#include "bench/run/json.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/check/claims.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr int engines_schema = 1;
constexpr int check_schema = 1;
constexpr int calibration_schema = 1;

constexpr std::size_t longest_sentence = 1000;  // [bytes], of what an engine makes long

ordered_json settings_json(const std::vector<Setting>& settings) {
  ordered_json rows = ordered_json::array();
  for (const Setting& setting : settings) {
    rows.push_back({{"name", setting.name}, {"value", setting.value}, {"reason", setting.reason}});
  }
  return rows;
}

ordered_json parameters_json(const std::vector<Parameter>& parameters) {
  ordered_json rows = ordered_json::array();
  for (const Parameter& one : parameters) {
    rows.push_back({{"name", one.name},
                    {"low", one.low},
                    {"high", one.high},
                    {"scale", one.logarithmic ? "log" : "linear"},
                    {"step_power", one.step_power}});
  }
  return rows;
}

ordered_json engine_object(const EngineInfo& info) {
  ordered_json models = ordered_json::array();
  for (const Model& model : info.models) {
    models.push_back({{"name", model.name},
                      {"sentence", model.sentence},
                      {"maker", to_string(model.maker)},
                      {"settings", settings_json(model.settings)}});
    if (!model.parameters.empty()) {
      models.back()["parameters"] = parameters_json(model.parameters);
      models.back()["code"] = model.code;
    }
  }
  return {{"name", info.name},
          {"version", info.version},
          {"precision", info.precision},
          {"models", std::move(models)}};
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

ordered_json model_json(const CheckedModel& model) {
  ordered_json claims = ordered_json::array();
  for (const SettledClaim& settled : model.claims) {
    claims.push_back(claim_json(settled));
  }
  return {{"model", model.name},
          {"holds", broken_claims(model.claims).empty()},
          {"findings", std::move(claims)}};
}

}  // namespace

std::string engine_json(const EngineInfo& info) { return engine_object(info).dump(); }

std::string engines_json(const std::vector<RegisteredEngine>& engines) {
  ordered_json list = ordered_json::array();
  for (const RegisteredEngine& engine : engines) {
    ordered_json row =
        engine.info ? engine_object(*engine.info) : ordered_json{{"name", engine.name}};
    row["plugin"] = engine.plugin.string();
    row["failure"] = printable(engine.failure);
    row["missing"] = engine.missing;
    row["package"] = engine.package;
    list.push_back(std::move(row));
  }
  return ordered_json{{"schema", engines_schema}, {"engines", std::move(list)}}.dump(2) + "\n";
}

std::string check_json(const RegisteredEngine& engine, const std::vector<CheckedModel>& models) {
  ordered_json rows = ordered_json::array();
  bool all = true;
  for (const CheckedModel& model : models) {
    all = all && broken_claims(model.claims).empty();
    rows.push_back(model_json(model));
  }
  const ordered_json result = {{"schema", check_schema},
                               {"engine",
                                {{"name", engine.info->name},
                                 {"version", engine.info->version},
                                 {"precision", engine.info->precision},
                                 {"plugin", engine.plugin.string()}}},
                               {"holds", all},
                               {"models", std::move(rows)}};
  return result.dump(2) + "\n";
}

std::string calibration_json(const RegisteredEngine& engine, const CalibrationRequest& request,
                             const Calibration& found) {
  ordered_json held_out = ordered_json::array();
  for (const HeldOut& one : found.held_out) {
    held_out.push_back({{"speed", one.strike.speed},
                        {"arm", one.strike.arm},
                        {"inertia", one.strike.inertia},
                        {"spin_part", one.strike.spin_part},
                        {"restitution", one.restitution}});
  }
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
                               {"held_out", std::move(held_out)},
                               {"not_reached", found.why},
                               {"evaluations", found.evaluations},
                               {"interrupted", found.interrupted}};
  return result.dump(2) + "\n";
}

}  // namespace tautline::bench
