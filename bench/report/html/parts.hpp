#pragma once

#include <initializer_list>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "bench/base/html.hpp"

namespace tautline::bench {

// What the sections of the report page share.

/// The engine that is the exact solution itself.
inline constexpr std::string_view control = "exact";

/// The value of `key`; null where `object` is none or has no such key.
[[nodiscard]] const nlohmann::ordered_json& member(const nlohmann::ordered_json& object,
                                                   const char* key);

/// The string of `key`, which `object` has.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& object, const char* key);

/// The same text for rows that agree in `keys`.
[[nodiscard]] std::string key_of(const nlohmann::ordered_json& row,
                                 std::initializer_list<const char*> keys);

/// The member `value` of the rows of `list`, by `key_of`.
[[nodiscard]] std::map<std::string, nlohmann::ordered_json> costs(
    const nlohmann::ordered_json& list, const char* value, std::initializer_list<const char*> keys);

/// The cost found there, or null.
[[nodiscard]] nlohmann::ordered_json found_in(
    const std::map<std::string, nlohmann::ordered_json>& costs, const std::string& key);

/// The heading of settling times: by which threshold.
[[nodiscard]] std::string settled_heading(const nlohmann::ordered_json& report);

/// A place for a chart: what it shows, which a reader without script is told.
[[nodiscard]] std::string chart_place(const std::string& id, const std::string& shows);

}  // namespace tautline::bench
