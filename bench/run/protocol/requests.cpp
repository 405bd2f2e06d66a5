#include <utility>

#include "bench/data/coordinates.hpp"
#include "bench/run/protocol/json.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {
namespace {

Json pair_json(const Vec2& value) { return Json::array({json_of(value.x()), json_of(value.y())}); }

std::string request(int id, const char* method, Json params) {
  Json message = {{"jsonrpc", "2.0"}, {"id", id}, {"method", method}};
  if (!params.is_null()) {
    message["params"] = std::move(params);
  }
  return message.dump();
}

/// Points [speed, e], linear in between; of two at one speed the later one holds from there on.
Json restitution_table(const Cable& cable) {
  Json table = Json::array();
  if (cable.capture_speed > 0.0) {
    const double captured = cable.capture_speed;
    table = {{0.0, 0.0}, {captured, 0.0}, {captured, restitution(cable, captured)}};
  }
  for (const RestitutionPoint& point : cable.restitution_table) {
    if (cable.capture_speed <= 0.0 || point.speed > cable.capture_speed) {
      table.push_back({point.speed, point.restitution});
    }
  }
  return table;
}

Json case_json(const Case& the_case, bool follows_speed) {
  Json cables = Json::array();
  for (const Cable& cable : the_case.cables) {
    const bool table = follows_speed && depends_on_speed(cable);
    cables.push_back({{"anchor", pair_json(cable.anchor)},
                      {"attachment", pair_json(cable.attachment)},
                      {"length", cable.length},
                      {"restitution", table ? restitution_table(cable) : Json(cable.restitution)}});
  }
  const State& start = the_case.initial;
  return {{"name", the_case.name},
          {"duration", the_case.duration},
          {"gravity", pair_json(the_case.gravity)},
          {"body", {{"mass", the_case.body.mass}, {"inertia", the_case.body.inertia}}},
          {"cables", std::move(cables)},
          {"initial",
           {{"position", pair_json(start.position)},
            {"angle", start.angle},
            {"velocity", pair_json(start.velocity)},
            {"spin", start.spin}}}};
}

}  // namespace

std::string info_request(int id) { return request(id, "info", nullptr); }

std::string start_request(int id, const Case& the_case, const ChildModel& model,
                          const RunSettings& settings) {
  // the event driver takes the restitution at each speed itself
  const bool table = model.follows_speed && !model.by_events;
  Json params = {{"case", case_json(the_case, table)},
                 {"model", model.model.name},
                 {"step", settings.step},
                 {"law", to_string(settings.law)}};
  if (!settings.parameters.empty()) {
    params["parameters"] = settings.parameters;
  }
  return request(id, "start", std::move(params));
}

std::string step_request(int id, double dt, std::size_t count) {
  return request(id, "step", {{"dt", dt}, {"count", count}});
}

std::string fly_request(int id, double dt) { return request(id, "fly", {{"dt", dt}}); }

std::string place_request(int id, const State& state) {
  Json row = Json::array();
  for (const auto& one : coordinates(state)) {
    row.push_back(json_of(one.value));
  }
  return request(id, "place", {{"state", std::move(row)}});
}

std::string solve_request(int id, CableSet cables, const CableVector& rates) {
  Json row = Json::array();
  for (const double rate : rates) {
    row.push_back(json_of(rate));
  }
  return request(id, "solve", {{"cables", cables.indices()}, {"rates", std::move(row)}});
}

}  // namespace tautline::bench
