#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <span>
#include <utility>

#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/run/protocol/json.hpp"
#include "bench/run/protocol/messages.hpp"

namespace tautline::bench {
namespace {

/// The protocols of this program. A child of the first is an engine of the plane.
constexpr int first_protocol = 1;
constexpr int latest_protocol = 2;

/// A quaternion is one of an orientation if its square is 1 up to this [-]: float leaves 1e-6.
constexpr double quaternion_rounding = 1e-4;

// the codes of JSON-RPC that mean more than the engine's own sentence
constexpr int parse_error = -32700;
constexpr int invalid_request = -32600;
constexpr int unknown_method = -32601;

/// Longer sentences of an engine are cut [bytes].
constexpr std::size_t longest_message = 1000;

[[noreturn]] void refuse_line(std::string_view line) {
  const bool bare = line.find("NaN") != line.npos || line.find("Infinity") != line.npos;
  const char* const right = !line.starts_with('{')
                                ? "what a library prints must go to standard error"
                            : bare ? "JSON has no NaN, say \"NaN\""
                                   : "a message is whole JSON, and its numbers are doubles";
  throw ProtocolError(
      fmt::format("the engine wrote on its standard output what is no message: {}; {}",
                  line.empty() ? "an empty line" : printable(line, excerpt_length), right));
}

[[noreturn]] void refuse_error(const Json& error, std::string_view method) {
  const Part part(error, "error", method);
  const double code = part.at("code").number();
  const std::string message = printable(part.at("message").text(), longest_message);
  if (code == unknown_method) {
    throw EngineRefusal(fmt::format("the engine does not know the method {}", method));
  }
  if (code == parse_error || code == invalid_request) {
    throw EngineRefusal(fmt::format("the engine could not read what it was asked: {}", message));
  }
  throw EngineRefusal(message);
}

/// What came back for a request: the message around a result.
class Answer {
 public:
  Answer(std::string_view line, int id, std::string_view method)
      : message_(Json::parse(line, nullptr, false)), method_(method) {
    if (!message_.is_object()) {
      refuse_line(line);
    }
    const Part message(message_, "", method);
    message.has_only({"jsonrpc", "id", "result", "error"});
    if (message.at("jsonrpc").text() != "2.0") {
      message.at("jsonrpc").refuse("\"2.0\"");
    }
    const auto error = message_.find("error");
    const auto its_id = message_.find("id");
    // it may not have read the id
    const bool of_none = error != message_.end() && (its_id == message_.end() || its_id->is_null());
    if (!of_none && (its_id == message_.end() || *its_id != id)) {
      message.at("id").refuse(fmt::format("{}, as in the request", id));
    }
    if (error != message_.end()) {
      refuse_error(*error, method);
    }
    static_cast<void>(message.at("result"));
  }
  [[nodiscard]] Part result() const { return {message_.at("result"), "", method_}; }

 private:
  Json message_;
  std::string_view method_;
};

/// The numbers of a state, for a sentence.
std::string words_of(StateForm form) {
  if (form.bodies == 0) {
    return "x, y, angle, vx, vy, spin";
  }
  return std::string("x, y, z, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz") +
         (form.bodies > 1 ? " of each body" : "");
}

bool are_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// Refuses `row`, whose numbers are `numbers`, where a body that is somewhere has no orientation.
void refuse_orientations(const Part& row, std::span<const double> numbers, StateForm form) {
  constexpr std::size_t before = 3;      // numbers of a body
  constexpr std::size_t quaternion = 4;  // numbers of an orientation
  for (std::size_t body = 0; body < form.bodies; ++body) {
    const std::size_t place = body_width * body + before;
    double square = 0.0;
    for (const double number : numbers.subspan(place, quaternion)) {
      square += number * number;
    }
    if (are_finite(numbers.subspan(body_width * body, body_width)) &&
        !(std::abs(square - 1.0) <= quaternion_rounding)) {
      row[place].refuse("the first of four numbers whose squares add up to 1");
    }
  }
}

std::vector<double> state_part(const Part& part, StateForm form) {
  std::vector<double> row;
  part.append_numbers(row, form.width(), words_of(form));
  refuse_orientations(part, row, form);
  return row;
}

Origin origin_from(const std::string& word) {
  for (const Origin origin : {Origin::engine_default, Origin::engine_demo}) {
    if (word == to_string(origin)) {
      return origin;
    }
  }
  return Origin::ours;
}

std::vector<Setting> settings_part(const Part& part) {
  std::vector<Setting> result;
  for (std::size_t index = 0; index < part.size(); ++index) {
    const Part row = part[index];
    row.has_only({"name", "value", "reason", "origin"});
    result.push_back({row.at("name").text(), row.at("value").text(), row.at("reason").text()});
    if (const auto origin = row.find("origin")) {
      result.back().origin = origin_from(origin->one_of({"engine_default", "engine_demo", "ours"}));
    }
  }
  return result;
}

Maker maker_from(const std::string& word) {
  for (const Maker maker : {Maker::engine, Maker::tautline}) {
    if (word == to_string(maker)) {
      return maker;
    }
  }
  return Maker::by_hand;
}

/// Nothing in mechanics goes with a higher power of time.
constexpr double largest_power = 4.0;

std::vector<Parameter> parameters_part(const Part& part) {
  std::vector<Parameter> result;
  for (std::size_t index = 0; index < part.size(); ++index) {
    const Part row = part[index];
    row.has_only({"name", "low", "high", "scale", "step_power"});
    Parameter one{row.at("name").name(), row.at("low").number(), row.at("high").number()};
    if (const auto scale = row.find("scale")) {
      one.logarithmic = scale->one_of({"linear", "log"}) == "log";
    }
    if (const auto power = row.find("step_power")) {
      const double whole = power->number();
      if (!(std::abs(whole) <= largest_power) || whole != std::round(whole)) {
        power->refuse("a whole number from -4 to 4");
      }
      one.step_power = static_cast<int>(whole);
    }
    if (!(one.low < one.high) || !std::isfinite(one.high - one.low) ||
        (one.logarithmic && !(one.low > 0.0))) {
      row.at("low").refuse("below high, and above 0 on a scale of logarithms");
    }
    result.push_back(std::move(one));
  }
  return result;
}

/// An impulse of a cable, which pulls and never pushes.
void refuse_push(const Part& impulse, double value) {
  if (!(value >= 0.0 && std::isfinite(value))) {
    impulse.refuse("an impulse of at least 0");
  }
}

ChildModel model_part(const Part& part) {
  ChildModel result;
  result.model.name = part.at("name").name();
  result.model.sentence = part.at("sentence").text();
  part.has_only({"name", "sentence", "maker", "drive", "follows_speed", "tension", "settings",
                 "parameters", "code", "in_space"});
  result.model.maker = maker_from(part.at("maker").one_of({"engine", "by_hand", "tautline"}));
  if (const auto drive = part.find("drive")) {
    result.by_events = drive->one_of({"steps", "events"}) == "events";
  }
  if (const auto follows = part.find("follows_speed")) {
    result.follows_speed = follows->flag();
  }
  if (const auto tension = part.find("tension")) {
    result.tells_tension = tension->flag();
  }
  if (const auto settings = part.find("settings")) {
    result.model.settings = settings_part(*settings);
  }
  if (const auto parameters = part.find("parameters")) {
    result.model.parameters = parameters_part(*parameters);
  }
  if (const auto code = part.find("code")) {
    result.model.code = code->text();
  }
  if (const auto in_space = part.find("in_space")) {
    result.model.in_space = settings_part(*in_space);
  }
  return result;
}

/// Springs and dampers. What they must be is looked at where they are recorded.
std::vector<SoftRow> soft_part(const Part& part) {
  std::vector<SoftRow> result;
  for (std::size_t index = 0; index < part.size(); ++index) {
    const Part row = part[index];
    row.has_only({"stiffness", "damping", "load"});
    result.push_back({row.at("stiffness").number(), row.at("damping").number()});
    if (const auto load = row.find("load")) {
      result.back().load = load->number();
    }
  }
  return result;
}

/// The dimensions of an engine's world: [2], or [2, 3].
int dimensions_part(const Part& part) {
  constexpr const char* right = "[2] or [2, 3]";
  if (part.size() == 0 || part.size() > 2 || part[0].number() != 2.0 ||
      (part.size() == 2 && part[1].number() != 3.0)) {
    part.refuse(right);
  }
  return static_cast<int>(part.size()) + 1;
}

}  // namespace

State state_from(const double* row) {
  return {Vec2(row[0], row[1]), row[2], Vec2(row[3], row[4]), row[5]};
}

SpatialSystemState state_from(const double* row, std::size_t bodies, double time) {
  SpatialSystemState result;
  result.time = time;
  for (std::size_t body = 0; body < bodies; ++body) {
    SpatialState& one = result.bodies.emplace_back();
    for (const auto& coordinate : coordinates(one)) {
      coordinate.value = *row++;
    }
    one.orientation.normalize();  // an engine in float rounds it
  }
  return result;
}

std::vector<double> numbers_of(const State& state) {
  std::vector<double> result;
  for (const auto& one : coordinates(state)) {
    result.push_back(one.value);
  }
  return result;
}

std::vector<double> numbers_of(const SpatialSystemState& state) {
  std::vector<double> result;
  for (const SpatialState& body : state.bodies) {
    for (const auto& one : coordinates(body)) {
      result.push_back(one.value);
    }
  }
  return result;
}

std::size_t StateForm::width() const { return bodies == 0 ? state_width : body_width * bodies; }

ChildInfo info_answer(std::string_view line, int id) {
  const Answer answer(line, id, "info");
  const Part info = answer.result();
  const double protocol = info.at("protocol").number();
  if (protocol != first_protocol && protocol != latest_protocol) {
    info.at("protocol")
        .refuse(fmt::format("{} or {}, the protocols of this program", first_protocol,
                            latest_protocol));
  }
  ChildInfo result;
  result.name = info.at("name").name();
  result.version = info.at("version").text();
  result.precision = info.at("precision").one_of({"float64", "float32"});
  const Part models = info.at("models");
  info.has_only({"protocol", "name", "version", "precision", "models", "dimensions"});
  const auto dimensions = info.find("dimensions");
  if (dimensions && protocol == latest_protocol) {
    result.dimensions = dimensions_part(*dimensions);
  } else if (dimensions) {
    dimensions->refuse("left out: protocol 1 has the plane alone");
  }
  std::set<std::string> seen;
  for (std::size_t index = 0; index < models.size(); ++index) {
    result.models.push_back(model_part(models[index]));
    if (!seen.insert(result.models.back().model.name).second) {
      models[index].at("name").refuse("another name than the models before it have");
    }
    if (result.models.back().model.in_space && result.dimensions == 2) {
      models[index]
          .at("in_space")
          .refuse("left out, or the engine's protocol 2 and its dimensions [2, 3]");
    }
  }
  if (result.models.empty()) {
    models.refuse("at least one model");
  }
  return result;
}

ChildStart start_answer(std::string_view line, int id, StateForm form) {
  const Answer answer(line, id, "start");
  const Part start = answer.result();
  start.has_only({"state", "rounding", "soft"});
  ChildStart result;
  result.state = state_part(start.at("state"), form);
  if (const auto rounding = start.find("rounding")) {
    rounding->has_only({"gap", "rate"});
    result.rounding = {rounding->at("gap").number(), rounding->at("rate").number()};
    for (const char* const key : {"gap", "rate"}) {
      if (const double value = rounding->at(key).number(); !(value > 0.0 && value < 1.0)) {
        rounding->at(key).refuse("above 0 and below 1");
      }
    }
  }
  if (const auto soft = start.find("soft")) {
    result.soft = soft_part(*soft);
  }
  return result;
}

ChildSteps step_answer(std::string_view line, int id, std::size_t cables, std::size_t count,
                       StateForm form) {
  const Answer answer(line, id, "step");
  const Part result = answer.result();
  result.has_only({"steps", "stopped"});
  const Part rows = result.at("steps");
  ChildSteps steps;
  steps.width = form.width() + cables;
  if (const auto stopped = result.find("stopped")) {
    stopped->has_only({"time", "reason"});
    steps.stopped = {stopped->at("time").number(),
                     printable(stopped->at("reason").text(), longest_message)};
  }
  if (rows.size() > count || (rows.size() < count && !steps.stopped)) {
    throw ProtocolError(fmt::format("the engine answered {} steps where {} were asked{}",
                                    rows.size(), count,
                                    rows.size() < count ? ", and not why it stopped" : ""));
  }
  steps.values.reserve(rows.size() * steps.width);
  for (std::size_t index = 0; index < rows.size(); ++index) {
    rows[index].append_numbers(steps.values, steps.width,
                               words_of(form) + ", then the impulse of each cable");
    const std::span<const double> row = std::span(steps.values).last(steps.width);
    refuse_orientations(rows[index], row, form);
    // a body that is nowhere has left its cables too
    const bool somewhere = are_finite(row.first(form.width()));
    for (std::size_t cable = form.width(); cable < row.size() && somewhere; ++cable) {
      refuse_push(rows[index][cable], row[cable]);
    }
  }
  return steps;
}

std::vector<double> state_answer(std::string_view line, int id, std::string_view method,
                                 StateForm form) {
  const Answer answer(line, id, method);
  answer.result().has_only({"state"});
  return state_part(answer.result().at("state"), form);
}

ChildSolve solve_answer(std::string_view line, int id, std::size_t cables, StateForm form) {
  const Answer answer(line, id, "solve");
  answer.result().has_only({"impulses", "state"});
  std::vector<double> impulses;
  const Part given = answer.result().at("impulses");
  given.append_numbers(impulses, cables, "one for each of the cables");
  for (std::size_t cable = 0; cable < cables; ++cable) {
    refuse_push(given[cable], impulses[cable]);
  }
  return {Eigen::Map<const Eigen::VectorXd>(impulses.data(), static_cast<Eigen::Index>(cables)),
          state_part(answer.result().at("state"), form)};
}

}  // namespace tautline::bench
