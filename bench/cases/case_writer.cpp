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

/// The members of a JSON object; numbers, pairs and strings are written as in TOML.
class Members {
 public:
  void add(std::string_view key, const std::string& value) {
    text_ += (text_.empty() ? "{\"" : ", \"") + std::string(key) + "\": " + value;
  }
  [[nodiscard]] std::string text() const { return text_ + "}"; }

 private:
  std::string text_;
};

std::string cable_json(const Cable& cable) {
  Members members;
  members.add("anchor", pair(cable.anchor));
  members.add("attachment", pair(cable.attachment));
  members.add("length", number(cable.length));
  members.add("restitution", number(cable.restitution));
  if (cable.capture_speed != 0.0) {  // exactly: the default
    members.add("capture_speed", number(cable.capture_speed));
  }
  if (!cable.restitution_table.empty()) {
    members.add("restitution_table", pairs(cable.restitution_table));
  }
  return members.text();
}

std::string case_json(const Case& the_case) {
  Members body;
  body.add("mass", number(the_case.body.mass));
  body.add("inertia", number(the_case.body.inertia));
  std::string cables;
  for (const Cable& cable : the_case.cables) {
    cables += (cables.empty() ? "[" : ", ") + cable_json(cable);
  }
  Members initial;
  initial.add("position", pair(the_case.initial.position));
  initial.add("angle", number(the_case.initial.angle));
  initial.add("velocity", pair(the_case.initial.velocity));
  initial.add("spin", number(the_case.initial.spin));
  Members all;
  all.add("name", toml_string(the_case.name));
  all.add("duration", number(the_case.duration));
  all.add("gravity", pair(the_case.gravity));
  if (the_case.angle_limit) {
    all.add("angle_limit", number(*the_case.angle_limit));
  }
  if (the_case.ceiling) {
    all.add("ceiling", number(*the_case.ceiling));
  }
  all.add("body", body.text());
  all.add("cables", cables + "]");
  all.add("initial", initial.text());
  return all.text();
}

}  // namespace
}  // namespace tautline::bench

namespace tautline {

std::string write_case(const Case& the_case) { return bench::case_text(the_case); }

std::string write_case_json(const Case& the_case) { return bench::case_json(the_case); }

}  // namespace tautline
