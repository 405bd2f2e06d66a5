#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace tautline::bench {

/// `report` as JSON that a person can read line by line and a tool can compare line by line: every
/// key of the outer objects and every row of their tables has a line of its own, and is compact
/// within it.
[[nodiscard]] std::string compact_json(const nlohmann::ordered_json& report);

}  // namespace tautline::bench
