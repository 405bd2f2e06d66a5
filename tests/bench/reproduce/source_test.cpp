#include "bench/tools/reproduce/source.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// The digits of `value` in a case number by the rules that are told: tenths without the sign, but
/// hundredths in two digits where tenths do not do, and 1 for 1.0.
std::string spelt(double value) {
  const long hundredths = std::lround(100.0 * std::abs(value));
  if (hundredths == 100) {
    return "1";
  }
  std::string text = std::to_string(hundredths / 10);
  return hundredths % 10 == 0 ? text : text + std::to_string(hundredths % 10);
}

TEST(CaseNumbers, SpellTheirCasesByTheRulesThatAreTold) {
  for (const auto& [number, body] : table_5_1()) {
    const State& start = body.initial;
    std::string expected = body.r == 1.5 ? "1" : "2";
    for (const double value : {body.e, body.a, body.b, start.position.x(), start.velocity.x(),
                               start.position.y(), start.velocity.y(), start.angle, start.spin}) {
      expected += spelt(value);
    }
    EXPECT_EQ(number, expected);
  }
}

TEST(CaseNumbers, NameTheStandardCaseDigitByDigit) {
  std::string number;
  for (const auto& [digit, quantity, value] : standard_digits()) {
    number += digit;
    EXPECT_FALSE(quantity.empty());
    EXPECT_EQ(spelt(std::stod(value)), quantity == "r" ? "15" : digit) << quantity;
  }
  EXPECT_EQ(number, table_5_1().front().number);
}

TEST(CaseNumbers, AreToldInLinesOfATerminal) {
  const std::string text = case_number_text();
  EXPECT_NE(text.find("A. L. Farmer, Free Motions of a Rigid-Body Breakwater, 1999"),
            std::string::npos);
  constexpr std::size_t longest_line = 100;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    EXPECT_LE(end - at, longest_line) << text.substr(at, end - at);
    at = end + 1;
  }
}

}  // namespace
}  // namespace tautline::bench
