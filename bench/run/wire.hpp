#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/run/record.hpp"
#include "tautline/engine.hpp"

namespace tautline::bench {

// How a worker process and the program talk: a JSON object, then raw numbers.

/// A message: an object and an array of numbers too long for JSON.
struct Message {
  nlohmann::ordered_json head;
  std::vector<double> numbers;
};

[[nodiscard]] std::string to_bytes(const Message& message);

/// None if `bytes` is not a whole message: the writer died.
[[nodiscard]] std::optional<Message> from_bytes(std::string_view bytes);

[[nodiscard]] Message trajectory_message(const Trajectory& trajectory);
[[nodiscard]] Trajectory trajectory_from(const Message& message);

[[nodiscard]] nlohmann::ordered_json engine_json(const EngineInfo& info);
[[nodiscard]] EngineInfo engine_from(const nlohmann::ordered_json& json);

}  // namespace tautline::bench
