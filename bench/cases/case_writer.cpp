#include <nlohmann/json.hpp>

#include "bench/base/text.hpp"
#include "bench/base/value.hpp"
#include "tautline/case_text.hpp"

namespace tautline::bench {
namespace {

/// A TOML float. `shortest` may look like an integer, which has no -0 and ends at 2^63.
std::string number(double value) {
  const std::string text = shortest(value);
  return text.find_first_not_of("+-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string pair(const Vec2& value) {
  return "[" + number(value.x()) + ", " + number(value.y()) + "]";
}

std::string pairs(const std::vector<RestitutionPoint>& table) {
  std::string result;
  for (const RestitutionPoint& point : table) {
    result += (result.empty() ? "[" : ", ") + pair({point.speed, point.restitution});
  }
  return result + "]";
}

std::string case_text(const Case& the_case) {
  std::string text = "name = " + toml_string(the_case.name) + "\n";
  const auto line = [&text](const std::string& key, const std::string& value) {
    text += key + " = " + value + "\n";
  };
  line("duration", number(the_case.duration));
  line("gravity", pair(the_case.gravity));
  if (the_case.angle_limit) {
    line("angle_limit", number(*the_case.angle_limit));
  }
  if (the_case.ceiling) {
    line("ceiling", number(*the_case.ceiling));
  }
  text += "\n[body]\n";
  line("mass", number(the_case.body.mass));
  line("inertia", number(the_case.body.inertia));
  for (const Cable& cable : the_case.cables) {
    text += "\n[[cables]]\n";
    line("anchor", pair(cable.anchor));
    line("attachment", pair(cable.attachment));
    line("length", number(cable.length));
    line("restitution", number(cable.restitution));
    if (cable.capture_speed != 0.0) {  // exactly: the default
      line("capture_speed", number(cable.capture_speed));
    }
    if (!cable.restitution_table.empty()) {
      line("restitution_table", pairs(cable.restitution_table));
    }
  }
  text += "\n[initial]\n";
  line("position", pair(the_case.initial.position));
  line("angle", number(the_case.initial.angle));
  line("velocity", pair(the_case.initial.velocity));
  line("spin", number(the_case.initial.spin));
  return text;
}

}  // namespace
}  // namespace tautline::bench

namespace tautline {

std::string write_case(const Case& the_case) { return bench::case_text(the_case); }

std::string write_case_json(const Case& the_case) {
  using Json = nlohmann::ordered_json;
  const auto pair = [](const Vec2& value) -> Json { return {value.x(), value.y()}; };
  Json json;
  json["name"] = the_case.name;
  json["duration"] = the_case.duration;
  json["gravity"] = pair(the_case.gravity);
  if (the_case.angle_limit) {
    json["angle_limit"] = *the_case.angle_limit;
  }
  if (the_case.ceiling) {
    json["ceiling"] = *the_case.ceiling;
  }
  json["body"] = {{"mass", the_case.body.mass}, {"inertia", the_case.body.inertia}};
  json["cables"] = Json::array();
  for (const Cable& cable : the_case.cables) {
    Json& entry = json["cables"].emplace_back();
    entry["anchor"] = pair(cable.anchor);
    entry["attachment"] = pair(cable.attachment);
    entry["length"] = cable.length;
    entry["restitution"] = cable.restitution;
    if (cable.capture_speed != 0.0) {  // exactly: the default
      entry["capture_speed"] = cable.capture_speed;
    }
    for (const RestitutionPoint& point : cable.restitution_table) {
      entry["restitution_table"].push_back({point.speed, point.restitution});
    }
  }
  const State& start = the_case.initial;
  json["initial"] = {{"position", pair(start.position)},
                     {"angle", start.angle},
                     {"velocity", pair(start.velocity)},
                     {"spin", start.spin}};
  // a name that is not UTF-8 is not written as it is: nothing is thrown
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tautline
