#include <utility>

#include "bench/run/protocol/json.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {
namespace {

template <class Numbers>
Json numbers_json(const Numbers& numbers) {
  Json result = Json::array();
  for (const double number : numbers) {
    result.push_back(number_json(number));
  }
  return result;
}

std::string request(int id, const char* method, Json params) {
  Json message = {{"jsonrpc", "2.0"}, {"id", id}, {"method", method}};
  if (!params.is_null()) {
    message["params"] = std::move(params);
  }
  return message.dump();
}

/// Points [speed, e], linear in between; of two at one speed the later one holds from there on.
template <class TheCable>
Json restitution_table(const TheCable& cable) {
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

template <class TheCable>
Json restitution_json(const TheCable& cable, bool follows_speed) {
  return follows_speed && depends_on_speed(cable) ? restitution_table(cable)
                                                  : Json(cable.restitution);
}

Json case_json(const Case& the_case, bool follows_speed) {
  Json cables = Json::array();
  for (const Cable& cable : the_case.cables) {
    cables.push_back({{"anchor", numbers_json(cable.anchor)},
                      {"attachment", numbers_json(cable.attachment)},
                      {"length", cable.length},
                      {"restitution", restitution_json(cable, follows_speed)}});
  }
  const State& start = the_case.initial;
  return {{"name", the_case.name},
          {"duration", the_case.duration},
          {"gravity", numbers_json(the_case.gravity)},
          {"body", {{"mass", the_case.body.mass}, {"inertia", the_case.body.inertia}}},
          {"cables", std::move(cables)},
          {"initial",
           {{"position", numbers_json(start.position)},
            {"angle", start.angle},
            {"velocity", numbers_json(start.velocity)},
            {"spin", start.spin}}}};
}

/// A function of time, as pieces of polynomials, and waves. A child needs no other form.
template <int N>
Json function_json(const Function<N>& function) {
  Json pieces = Json::array();
  for (const auto& piece : function.pieces) {
    Json polynomial = Json::array();
    for (const auto& coefficient : piece.coefficients) {
      polynomial.push_back(numbers_json(coefficient));
    }
    pieces.push_back({{"from", number_json(piece.from)}, {"polynomial", std::move(polynomial)}});
  }
  Json waves = Json::array();
  for (const auto& wave : function.waves) {
    waves.push_back({{"amplitude", numbers_json(wave.amplitude)},
                     {"frequency", wave.frequency},
                     {"phase", wave.phase}});
  }
  return {{"pieces", std::move(pieces)}, {"waves", std::move(waves)}};
}

Json end_json(const SpatialEnd& end) {
  if (end.body) {
    return {{"body", *end.body}, {"at", numbers_json(end.at)}};
  }
  return {{"at", numbers_json(end.at)}, {"motion", function_json(end.motion)}};
}

Json case_json(const SpatialSystem& system, bool follows_speed) {
  Json bodies = Json::array();
  for (const SpatialBody& body : system.bodies) {
    bodies.push_back({{"name", body.name},
                      {"mass", body.mass},
                      {"inertia", numbers_json(body.inertia)},
                      {"drag", body.drag},
                      {"spin_drag", body.spin_drag},
                      {"force", function_json(body.force)},
                      {"moment", function_json(body.moment)}});
  }
  Json cables = Json::array();
  for (const SpatialCable& cable : system.cables) {
    Json ends = Json::array();
    for (std::size_t i = 0; i <= cable.segments(); ++i) {
      ends.push_back(end_json(cable.end(i)));
    }
    Json one = {{"ends", std::move(ends)},
                {"length", function_json(cable.length)},
                {"restitution", restitution_json(cable, follows_speed)}};
    if (cable.from_time) {
      one["from_time"] = *cable.from_time;
    }
    if (cable.cut_at) {
      one["cut_at"] = *cable.cut_at;
    }
    cables.push_back(std::move(one));
  }
  return {{"name", system.name},
          {"duration", system.duration},
          {"gravity", function_json(system.gravity)},
          {"bodies", std::move(bodies)},
          {"cables", std::move(cables)},
          {"initial", numbers_json(numbers_of(system.initial))}};
}

template <class TheCase>
std::string start_text(int id, const TheCase& the_case, const ChildModel& model,
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

}  // namespace

std::string info_request(int id) { return request(id, "info", nullptr); }

std::string start_request(int id, const Case& the_case, const ChildModel& model,
                          const RunSettings& settings) {
  return start_text(id, the_case, model, settings);
}

std::string start_request(int id, const SpatialSystem& system, const ChildModel& model,
                          const RunSettings& settings) {
  return start_text(id, system, model, settings);
}

std::string step_request(int id, double dt, std::size_t count) {
  return request(id, "step", {{"dt", dt}, {"count", count}});
}

std::string fly_request(int id, double dt) { return request(id, "fly", {{"dt", dt}}); }

std::string place_request(int id, const State& state) {
  return request(id, "place", {{"state", numbers_json(numbers_of(state))}});
}

std::string place_request(int id, const SpatialSystemState& state) {
  return request(id, "place",
                 {{"state", numbers_json(numbers_of(state))}, {"time", number_json(state.time)}});
}

std::string solve_request(int id, CableSet cables, const CableVector& rates) {
  return request(id, "solve", {{"cables", cables.indices()}, {"rates", numbers_json(rates)}});
}

}  // namespace tautline::bench
