#include "bench/vectors/vector_output.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <string_view>

#include "bench/base/text.hpp"
#include "bench/data/coordinates.hpp"
#include "bench/data/describer.hpp"
#include "bench/data/motion_fields.hpp"
#include "bench/solution/cable_words.hpp"

namespace tautline::bench {
namespace {

/// What the file says to a person who has nothing but the file.
constexpr const char* rule =
    "A scheme of first order with steps of h [s] may be off by 2 * h * fastest * growth [m] at a "
    "row; "
    "it is off by the root of dx^2 + dy^2 + (radius * dangle)^2. A row says nothing about steps "
    "longer "
    "than its own `step`.";

const std::vector<std::string>& state_names() {
  static const std::vector<std::string> names = [] {
    State state;
    std::vector<std::string> result;
    for (const auto& one : coordinates(state)) {
      result.emplace_back(one.name);
    }
    return result;
  }();
  return names;
}

std::string kind_of(const VectorRow& row) {
  return row.kind ? std::string(to_string(*row.kind)) : "sample";
}

template <class Numbers>
std::string spaced(const Numbers& numbers) {
  std::string result;
  for (const double number : numbers) {
    result += (result.empty() ? "" : " ") + shortest(number);
  }
  return result;
}

}  // namespace

template <class Visitor>
void fields(Visitor& visit, VectorRow& row) {
  visit.means("an instant; of an event with the state after it");
  visit("time", row.time, "[s]");
  visit("kind", kind_of(row), one_of({"sample", "impact", "taut", "slack"}));
  visit("state", std::vector<double>(row.state.begin(), row.state.end()),
        Says("in the order of the vector's `state`").of(6));
  visit(
      "growth", row.growth,
      "the largest factor so far by which the motion has magnified a small difference of its start "
      "[-]; null from where it is not known");
  visit("step", row.step, at_least(0, "the longest step that the row can judge [s]"));
  visit.if_any("energy", row.energy, "of a sample [J]");
  const auto cables = row.kind ? std::optional(row.cables) : std::nullopt;
  visit.if_any("cables", cables, "of an event");
  visit.if_any(
      "rate", row.rate,
      "of an impact: the rate at which the gap closes before it, the largest of its cables "
      "[m/s]");
  const auto impulses = row.impulses.empty() ? std::nullopt : std::optional(row.impulses);
  visit.if_any("impulses", impulses,
               "of each of its cables [N s]; missing where their split is not determined");
  std::optional<std::vector<double>> velocity;
  if (row.velocity) {
    velocity.emplace(row.velocity->begin(), row.velocity->end());
  }
  visit.if_any("before", velocity, Says("vx, vy and spin before the impact").of(3));
}

template <class Visitor>
void fields(Visitor& visit, Vector& vector) {
  visit("format", std::string(vector_format), one_of({vector_format}));
  visit("rule", std::string(rule), "how to judge a scheme with fixed steps by the rows");
  visit("case", vector.the_case, "with the keys of a case file");
  visit("law", std::string(to_string(vector.law)), "of impacts on several cables at once");
  visit("state", state_names(), "the order of the numbers of a state: m, m, rad, m/s, m/s, rad/s");
  visit("radius", vector.radius, at_least(0, "of gyration [m]; 0 of a body that is a point"));
  visit("fastest", vector.fastest, at_least(0, "speed of all rows, with the turn [m/s]"));
  visit("slowest", vector.slowest, above(0, "impacts that close slower have no row [m/s]"));
  visit("ends", vector.ends,
        "lock: at the last row the cables become taut that stay so; else what ends the motion");
  visit("rows", vector.rows, Says("in rising time").not_empty());
}

std::string vector_schema_json() {
  return text_of(headed("Test vector of `tautline vector`",
                        "An exact motion, by which an engine can check itself.",
                        schema_of(Vector())));
}

std::string vector_json(const Vector& vector) { return in_lines(json_of(vector)); }

std::string vector_text(const Vector& vector) {
  const Case& the_case = vector.the_case;
  const State& start = the_case.initial;
  std::string text = fmt::format(
      "{}\n"
      "# {}\n"
      "# body MASS INERTIA; cable ANCHOR_X ANCHOR_Y ATTACHMENT_X ATTACHMENT_Y LENGTH RESTITUTION, "
      "then "
      "`capture SPEED` or `table SPEED RESTITUTION ...`\n"
      "# sample|impact|taut|slack TIME {} GROWTH STEP, then of a sample its ENERGY; of an event "
      "its "
      "CABLES; of an impact also RATE, VX VY SPIN before it, and its IMPULSES unless they are not "
      "determined. GROWTH 0: not known\n"
      "case {}\nlaw {}\nbody {} {}\ngravity {} {}\nstart {}\nduration {}\n",
      vector_format, rule, fmt::join(state_names(), " "), printable(the_case.name),
      to_string(vector.law), shortest(the_case.body.mass), shortest(the_case.body.inertia),
      shortest(the_case.gravity.x()), shortest(the_case.gravity.y()),
      spaced(std::array{start.position.x(), start.position.y(), start.angle, start.velocity.x(),
                        start.velocity.y(), start.spin}),
      shortest(the_case.duration));
  for (const Cable& cable : the_case.cables) {
    text += "cable " + spaced(std::array{cable.anchor.x(), cable.anchor.y(), cable.attachment.x(),
                                         cable.attachment.y(), cable.length, cable.restitution});
    if (cable.capture_speed > 0.0) {
      text += " capture " + shortest(cable.capture_speed);
    }
    if (!cable.restitution_table.empty()) {
      text += " table";
    }
    for (const RestitutionPoint& point : cable.restitution_table) {
      text += " " + spaced(std::array{point.speed, point.restitution});
    }
    text += "\n";
  }
  text += fmt::format("radius {}\nfastest {}\nslowest {}\nends {}\n", shortest(vector.radius),
                      shortest(vector.fastest), shortest(vector.slowest), vector.ends);
  for (const VectorRow& row : vector.rows) {
    text += fmt::format("{} {} {} {} {}", kind_of(row), shortest(row.time), spaced(row.state),
                        shortest(row.growth.value_or(0.0)), shortest(row.step));
    text += row.energy ? " " + shortest(*row.energy) : "";
    text += row.kind ? " " + cable_list(row.cables) : "";
    if (row.velocity) {
      text += " " + shortest(*row.rate) + " " + spaced(*row.velocity);
    }
    text += row.impulses.empty() ? "" : " " + spaced(row.impulses);
    text += "\n";
  }
  return text;
}

}  // namespace tautline::bench
