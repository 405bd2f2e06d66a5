#include "bench/tools/reproduce/source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

#include "tautline/scenarios.hpp"

namespace tautline::bench {

namespace {

// Table 5.1, "Parameters and Initial Conditions": every row, in the order of its print.
constexpr PrintedCase table_1[] = {
    {"r", "1910121100 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"r", "2910121100 2.5 2.332 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"r", "1911121100 1.5 1.200 0.9 0.1 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"r", "2911121100 2.5 2.332 0.9 0.1 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"r", "1921121100 1.5 1.269 0.9 0.2 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"r", "2921121100 2.5 2.369 0.9 0.2 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"e", "1110121100 1.5 1.200 1.0 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"e", "1910121100 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"e", "1710121100 1.5 1.200 0.7 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"e", "1510121100 1.5 1.200 0.5 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a, b = 0 (circle)", "1910121100 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a, b = 0 (circle)", "1920121100 1.5 1.269 0.9 0.2 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a, b = 0 (circle)", "1930121100 1.5 1.327 0.9 0.3 0.0 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a = b (square)", "1911121100 1.5 1.200 0.9 0.1 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a = b (square)", "1922121100 1.5 1.269 0.9 0.2 0.2 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a = b (square)", "1933121100 1.5 1.327 0.9 0.3 0.3 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a > b (rectangle)", "1911121100 1.5 1.200 0.9 0.1 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a > b (rectangle)", "1921121100 1.5 1.269 0.9 0.2 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"a > b (rectangle)", "1931121100 1.5 1.327 0.9 0.3 0.1 0.1 0.2 0.1 -0.1 0.0 0.0"},
    {"theta", "1910121100 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.00 0.0"},
    {"theta", "19101211050 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.05 0.0"},
    {"theta", "1910121110 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.10 0.0"},
    {"theta", "19101211150 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.15 0.0"},
    {"vtheta", "1910121100 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.00"},
    {"vtheta", "19101211002 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.02"},
    {"vtheta", "19101211005 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.05"},
    {"vtheta", "1910121101 1.5 1.200 0.9 0.1 0.0 0.1 0.2 0.1 -0.1 0.0 0.10"},
    {"point mass", "1900461100 1.5 1.118 0.9 0.0 0.0 0.4 0.6 1.0 -0.1 0.0 0.0"},
};

// Table 5.2, "Moments of Inertia for Different Shapes".
constexpr PrintedInertia table_2[] = {
    {"circle", "0.1 0 0.010"},      {"circle", "0.2 0 0.040"},      {"circle", "0.3 0 0.090"},
    {"square", "0.1 0.1 0.007"},    {"square", "0.2 0.2 0.027"},    {"square", "0.3 0.3 0.060"},
    {"rectangle", "0.1 0.1 0.007"}, {"rectangle", "0.2 0.1 0.017"}, {"rectangle", "0.3 0.1 0.033"},
};

// Table 5.3, "Comparison of Point-Mass Breakwater Solution with the Rigid-Body Breakwater
// Solution"; - and + are before and after the impact.
constexpr PrintedState table_3[] = {
    {"1st time step", "0.010000 0.406000 0.600000 0.998950 -0.110000 -1.882983 -0.258983"},
    {"1st impact -", "0.154875 0.492925 0.600000 0.972519 -0.254875 -1.974424 0.000000"},
    {"1st impact +", "0.154875 0.492925 -0.576028 0.972519 -0.140248 -1.974424 0.000000"},
    {"t = 15", "15.000000 -0.018886 -0.197788 0.104275 0.397382 -0.184164 -0.259710"},
    {"last impact -", "26.448888 -0.001603 0.085187 0.001436 -0.076411 0.000000 -0.006031"},
    {"last impact +", "26.448888 -0.001603 0.085184 0.001436 -0.076414 0.000000 -0.006031"},
};

}  // namespace

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
      "breakwater/NUMBER are the cases of Table 5.1 of\n{}.\nA number spells its case, digit by "
      "digit. For the standard case:\n\n{}\n",
      source, case_number_table().plain());
  for (const std::string& rule : case_number_rules()) {
    text += rule + "\n";
  }
  return text;
}

std::span<const PrintedCase> printed_table_5_1() { return table_1; }
std::span<const PrintedInertia> printed_table_5_2() { return table_2; }
std::span<const PrintedState> printed_table_5_3() { return table_3; }

const PrintedState& find_printed_state(std::string_view instant) {
  const auto* const found =
      std::find_if(std::begin(table_3), std::end(table_3),
                   [&](const PrintedState& row) { return row.instant == instant; });
  if (found == std::end(table_3)) {
    throw std::out_of_range("no row " + std::string(instant) + " in Table 5.3");
  }
  return *found;
}

std::vector<std::string_view> split(std::string_view cells) {
  std::vector<std::string_view> result;
  while (!cells.empty()) {
    const std::size_t end = std::min(cells.find(' '), cells.size());
    result.push_back(cells.substr(0, end));
    cells.remove_prefix(std::min(end + 1, cells.size()));
  }
  return result;
}

double printed_value(std::string_view cell) {
  double value = 0.0;
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

double half_unit(std::string_view cell) {
  const std::size_t point = cell.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : cell.size() - point - 1;
  return 0.5 * std::pow(10.0, -static_cast<double>(decimals));
}

}  // namespace tautline::bench
