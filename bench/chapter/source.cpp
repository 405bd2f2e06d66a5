#include "bench/chapter/source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "tautline/scenarios.hpp"

namespace tautline::bench {

std::vector<CaseDigit> standard_digits() {
  struct Quantity {
    const char* name;
    double value;
  };
  const auto [number, body] = table_5_1().front();
  const State& start = body.initial;
  std::vector<CaseDigit> digits;
  for (const auto& [name, value] : {Quantity{"r", body.r},
                                    {"e", body.e},
                                    {"a", body.a},
                                    {"b", body.b},
                                    {"x", start.position.x()},
                                    {"vx", start.velocity.x()},
                                    {"y", start.position.y()},
                                    {"vy", start.velocity.y()},
                                    {"theta", start.angle},
                                    {"vtheta", start.spin}}) {
    digits.push_back({std::string(1, number[digits.size()]), name, fmt::format("{:g}", value)});
  }
  return digits;
}

Table case_number_table() {
  std::vector<std::string> digits = {"digit"};
  std::vector<std::string> quantities = {"quantity"};
  std::vector<std::string> values = {"value"};
  for (const auto& [digit, quantity, value] : standard_digits()) {
    digits.push_back(digit);
    quantities.push_back(quantity);
    values.push_back(value);
  }
  Table table(digits, digits.size());
  table.add(quantities);
  table.add(values);
  return table;
}

std::vector<std::string> case_number_rules() {
  return {
      "r is the length of both cables: 1 for 1.5, 2 for 2.5.",
      "e is the restitution of both: 9 for 0.9, 1 for 1.0.",
      "a and b are half the width and depth of the body: a box, a ring if b = 0, a point if a = 0 "
      "too.",
      "x, vx, y, vy, theta and vtheta are the start, without signs; 1 is 1.0 for y of the point "
      "mass.",
      "All but r are in tenths; theta and vtheta with two digits in hundredths: 05 for 0.05."};
}

std::string case_number_text() {
  std::string source(source_chapter);
  source.erase(std::remove(source.begin(), source.end(), '*'), source.end());
  std::string text = fmt::format(
      "breakwater/NUMBER are the cases of Table 5.1 of\n{}.\n"
      "A number spells its case, digit by digit. That of the standard case:\n\n{}\n",
      source, case_number_table().plain());
  for (const std::string& rule : case_number_rules()) {
    text += rule + "\n";
  }
  return text;
}

}  // namespace tautline::bench
