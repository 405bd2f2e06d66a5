#include "bench/run/wire.hpp"

#include <cstdint>
#include <cstring>
#include <limits>

namespace tautline::bench {
namespace {

constexpr std::size_t numbers_per_point = 7;  // time, position, angle, velocity, spin

using nlohmann::ordered_json;

ordered_json state_row(const State& state) {
  return {state.position.x(), state.position.y(), state.angle,
          state.velocity.x(), state.velocity.y(), state.spin};
}

/// JSON writes NaN as null; a rate of a run that diverged may be one.
double number_from(const ordered_json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

State state_from(const ordered_json& row) {
  return {Vec2(number_from(row.at(0)), number_from(row.at(1))), number_from(row.at(2)),
          Vec2(number_from(row.at(3)), number_from(row.at(4))), number_from(row.at(5))};
}

}  // namespace

std::string to_bytes(const Message& message) {
  const std::string head = message.head.dump();
  const std::uint64_t sizes[2] = {head.size(), message.numbers.size()};
  std::string bytes(sizeof sizes, '\0');
  std::memcpy(bytes.data(), sizes, sizeof sizes);
  bytes += head;
  const std::size_t start = bytes.size();
  const std::size_t size = message.numbers.size() * sizeof(double);
  bytes.resize(start + size);
  if (size > 0) {
    std::memcpy(bytes.data() + start, message.numbers.data(), size);
  }
  return bytes;
}

std::optional<Message> from_bytes(std::string_view bytes) {
  std::uint64_t sizes[2] = {};
  if (bytes.size() < sizeof sizes) {
    return std::nullopt;
  }
  std::memcpy(sizes, bytes.data(), sizeof sizes);
  bytes.remove_prefix(sizeof sizes);
  if (sizes[0] > bytes.size() || sizes[1] != (bytes.size() - sizes[0]) / sizeof(double)) {
    return std::nullopt;
  }
  Message message;
  message.head = ordered_json::parse(bytes.substr(0, sizes[0]), nullptr, false);
  if (message.head.is_discarded()) {
    return std::nullopt;
  }
  message.numbers.resize(sizes[1]);
  if (sizes[1] > 0) {
    std::memcpy(message.numbers.data(), bytes.data() + sizes[0], sizes[1] * sizeof(double));
  }
  return message;
}

Message trajectory_message(const Trajectory& trajectory) {
  Message message;
  ordered_json impacts = ordered_json::array();
  for (const RecordedImpact& impact : trajectory.impacts) {
    impacts.push_back({impact.time,
                       impact.cable,
                       impact.impulse,
                       impact.rate_before,
                       impact.rate_after,
                       impact.steps,
                       state_row(impact.before),
                       state_row(impact.after),
                       {impact.stray[0], impact.stray[1], impact.stray[2]}});
  }
  message.head = {{"step", trajectory.step},
                  {"stride", trajectory.stride},
                  {"impacts", std::move(impacts)},
                  {"slow_impacts", trajectory.slow_impacts},
                  {"overstretch", trajectory.overstretch},
                  {"largest_energy", trajectory.largest_energy},
                  {"diverged", trajectory.diverged}};
  if (trajectory.stop) {
    message.head["stop"] = {{"time", trajectory.stop->time}, {"reason", trajectory.stop->reason}};
  }
  message.numbers.reserve(trajectory.points.size() * numbers_per_point);
  for (const auto& [time, state] : trajectory.points) {
    for (const double value : {time, state.position.x(), state.position.y(), state.angle,
                               state.velocity.x(), state.velocity.y(), state.spin}) {
      message.numbers.push_back(value);
    }
  }
  return message;
}

Trajectory trajectory_from(const Message& message) {
  const ordered_json& head = message.head;
  Trajectory result;
  result.step = head.at("step");
  result.stride = head.at("stride");
  for (const ordered_json& row : head.at("impacts")) {
    result.impacts.push_back(
        {number_from(row.at(0)), row.at(1), number_from(row.at(2)), number_from(row.at(3)),
         number_from(row.at(4)), row.at(5), state_from(row.at(6)), state_from(row.at(7)),
         Eigen::Vector3d(number_from(row.at(8).at(0)), number_from(row.at(8).at(1)),
                         number_from(row.at(8).at(2)))});
  }
  result.slow_impacts = head.at("slow_impacts");
  result.overstretch = number_from(head.at("overstretch"));
  result.largest_energy = number_from(head.at("largest_energy"));
  result.diverged = head.at("diverged");
  if (head.contains("stop")) {
    result.stop = {head.at("stop").at("time"), head.at("stop").at("reason")};
  }
  const std::vector<double>& n = message.numbers;
  for (std::size_t i = 0; i + numbers_per_point <= n.size(); i += numbers_per_point) {
    result.points.push_back(
        {n[i], {Vec2(n[i + 1], n[i + 2]), n[i + 3], Vec2(n[i + 4], n[i + 5]), n[i + 6]}});
  }
  return result;
}

ordered_json engine_json(const EngineInfo& info) {
  ordered_json models = ordered_json::array();
  for (const Model& model : info.models) {
    ordered_json settings = ordered_json::array();
    for (const Setting& setting : model.settings) {
      settings.push_back(
          {{"name", setting.name}, {"value", setting.value}, {"reason", setting.reason}});
    }
    models.push_back(
        {{"name", model.name}, {"sentence", model.sentence}, {"settings", std::move(settings)}});
  }
  return {{"name", info.name},
          {"version", info.version},
          {"precision", info.precision},
          {"models", std::move(models)}};
}

EngineInfo engine_from(const ordered_json& json) {
  EngineInfo info{json.at("name"), json.at("version"), json.at("precision"), {}};
  for (const ordered_json& row : json.at("models")) {
    Model model{row.at("name"), row.at("sentence"), {}};
    for (const ordered_json& setting : row.at("settings")) {
      model.settings.push_back({setting.at("name"), setting.at("value"), setting.at("reason")});
    }
    info.models.push_back(std::move(model));
  }
  return info;
}

}  // namespace tautline::bench
