#include "bench/report/html/parts.hpp"

#include <fmt/format.h>

namespace tautline::bench {

using nlohmann::ordered_json;

const ordered_json& member(const ordered_json& object, const char* key) {
  static const ordered_json none = nullptr;
  return object.is_object() && object.contains(key) ? object.at(key) : none;
}

std::string text_of(const ordered_json& object, const char* key) { return object.at(key); }

std::string key_of(const ordered_json& row, std::initializer_list<const char*> keys) {
  std::string result;
  for (const char* key : keys) {
    result += row.at(key).dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  }
  return result;
}

/// The cost of a step over that of a closed-form flight, by what `keys` of the row say.
std::map<std::string, ordered_json> costs(const ordered_json& list, const char* value,
                                          std::initializer_list<const char*> keys) {
  std::map<std::string, ordered_json> result;
  for (const ordered_json& row : list) {
    result[key_of(row, keys)] = row.at(value);
  }
  return result;
}

ordered_json found_in(const std::map<std::string, ordered_json>& costs, const std::string& key) {
  const auto found = costs.find(key);
  return found == costs.end() ? ordered_json() : found->second;
}

namespace {

/// The threshold of the settling time that the tables give [m/s]; null without a case.
ordered_json settling_speed(const ordered_json& report) {
  const ordered_json& cases = report.at("cases");
  return cases.empty() ? ordered_json()
                       : cases.at(0).at("settling").at("last_impacts").at(0).at("speed");
}

}  // namespace

std::string settled_heading(const ordered_json& report) {
  const ordered_json speed = settling_speed(report);
  return speed.is_number() ? fmt::format("last impact > {:g} m/s", speed.get<double>())
                           : "last impact";
}

std::string chart_place(const std::string& id, const std::string& shows) {
  return fmt::format(
      "<div class=\"chart\" id=\"{0}\" role=\"figure\" aria-label=\"{1}\">"
      "<p class=\"no-script\">{1} Drawn by script only.</p></div>\n",
      id, html_text(shows));
}

}  // namespace tautline::bench
