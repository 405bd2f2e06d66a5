#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "bench/base/text.hpp"
#include "tautline/case_file.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

using test::bits;

/// Any number a case may have: every exponent up to the limit, subnormal numbers and -0.
double any_finite() {
  const auto value = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
  if (!std::isfinite(value)) {
    return -0.0;
  }
  return std::abs(value) > largest_number ? 1.0 / value : value;
}

double any_positive() {
  const double value = std::abs(any_finite());
  return value > 0.0 ? value : std::numeric_limits<double>::denorm_min();
}

double any_divisor() { return std::max(any_positive(), smallest_divisor); }

/// A number of full precision in (-10, 10).
double moderate() {
  const auto unit = *rc::gen::arbitrary<std::int64_t>();
  return 10.0 * (static_cast<double>(unit) / 0x1p63);
}

Vec2 any_pair() { return {any_finite(), any_finite()}; }
Vec2 moderate_pair() { return {moderate(), moderate()}; }

std::string any_name() {
  const auto piece = rc::gen::element<std::string>("a", "B", "7", "/", "..", " ", "\"", "\\", "\n",
                                                   "\r", "\t", "#", "'", "\x1b", "\x7f", "é", "重");
  std::string name = "n";
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(piece)) {
    name += part;
  }
  return name;
}

/// A case that breaks no rule, with numbers as wild as the rules allow.
Case any_case() {
  Case result;
  result.name = any_name();
  result.body = {any_divisor(), any_divisor()};
  result.gravity = any_pair();
  result.initial = {moderate_pair(), moderate(), any_pair(), any_finite()};
  result.duration = any_positive();
  const int count = *rc::gen::inRange(1, static_cast<int>(max_cables) + 1);
  for (int index = 0; index < count; ++index) {
    Cable cable;
    cable.anchor = moderate_pair();
    cable.attachment = moderate_pair();
    const double distance = (attachment_point(result.initial, cable) - cable.anchor).norm();
    cable.length = distance + 0.01 + std::abs(moderate());
    cable.restitution = std::abs(moderate()) / 10.0;
    if (*rc::gen::arbitrary<bool>()) {
      cable.capture_speed = std::abs(any_finite());
    }
    double speed = 0.0;
    for (int points = *rc::gen::inRange(0, 4); points > 0; --points) {
      speed += 0.01 + std::abs(moderate());
      cable.restitution_table.push_back({speed, std::abs(moderate()) / 10.0});
    }
    result.cables.push_back(cable);
  }
  if (*rc::gen::arbitrary<bool>()) {
    result.angle_limit = 20.0 + moderate();
  }
  if (*rc::gen::arbitrary<bool>()) {
    result.ceiling = 100.0 + moderate();
  }
  return result;
}

/// Puts a number that may break a rule in the place of one of the case's numbers.
void spoil(Case& the_case) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double value = *rc::gen::element(0.0, -0.0, -1.0, 1.0, 1.5, 1e21, 1e-61, 1e308, infinity,
                                         -infinity, std::numeric_limits<double>::quiet_NaN());
  Cable& cable = the_case.cables.front();
  State& initial = the_case.initial;
  *(*rc::gen::element(&the_case.body.mass, &the_case.body.inertia, &the_case.duration,
                      &the_case.gravity.x(), &initial.position.y(), &initial.angle,
                      &initial.velocity.x(), &initial.spin, &cable.anchor.x(),
                      &cable.attachment.y(), &cable.length, &cable.restitution,
                      &cable.capture_speed)) = value;
}

/// A case or sentences, never both or neither; each sentence is one legible line about the source.
void check_is_an_answer(const CaseReading& reading) {
  RC_ASSERT(reading.the_case.has_value() == reading.problems.empty());
  if (reading.the_case) {
    RC_ASSERT(problems(*reading.the_case).empty());
  }
  for (const std::string& sentence : reading.problems) {
    RC_ASSERT(sentence.starts_with("source:"));
    RC_ASSERT(printable(sentence, sentence.size()) == sentence);
  }
}

TEST(CaseRoundTrip, EveryShippedCaseKeepsEveryBit) {
  for (const Case& the_case : shipped_cases()) {
    const CaseReading reading = read_case_text(write_case(the_case), "source");
    ASSERT_TRUE(reading.the_case) << reading.problems.front();
    EXPECT_EQ(reading.the_case->name, the_case.name);
    EXPECT_EQ(bits(*reading.the_case), bits(the_case)) << the_case.name;
  }
}

RC_GTEST_PROP(CaseRoundTrip, AnyCaseKeepsEveryBit, ()) {
  const Case the_case = any_case();
  const std::string text = write_case(the_case);
  RC_LOG() << text;
  const CaseReading reading = read_case_text(text, "source");
  RC_ASSERT(reading.problems == std::vector<std::string>{});
  RC_ASSERT(reading.the_case->name == the_case.name);
  RC_ASSERT(bits(*reading.the_case) == bits(the_case));
}

RC_GTEST_PROP(CaseRoundTrip, TheReaderRefusesExactlyWhatTheRulesRefuse, ()) {
  Case the_case = any_case();
  spoil(the_case);
  const std::string text = write_case(the_case);
  RC_LOG() << text;
  RC_ASSERT(read_case_text(text, "source").problems.empty() == problems(the_case).empty());
}

RC_GTEST_PROP(CaseReader, AnswersToAnyBytes, (const std::string& bytes)) {
  check_is_an_answer(read_case_text(bytes, "source"));
}

RC_GTEST_PROP(CaseReader, AnswersToADamagedFile, ()) {
  std::string text = write_case(any_case());
  const auto damages = *rc::gen::container<std::vector<std::pair<std::uint16_t, std::string>>>(
      rc::gen::arbitrary<std::pair<std::uint16_t, std::string>>());
  for (const auto& [place, bytes] : damages) {
    const std::size_t start = place % (text.size() + 1);
    text.replace(start, std::min<std::size_t>(place % 7, text.size() - start), bytes);
  }
  RC_LOG() << text;
  check_is_an_answer(read_case_text(text, "source"));
}

RC_GTEST_PROP(CaseReader, AnswersToAnyTokensOfTheLanguage, ()) {
  const auto token = rc::gen::element<std::string>(
      "[", "]", "[[", "]]", "{", "}", "=", ",", ".", "\n", "\"", "'''", "\"\"\"", "#", "cables",
      "body", "initial", "mass", "position", "length", "name", "1", "-0", "1e9", "nan", "0x1F",
      "1979-05-27T07:32:00Z", "true", " ", "\\", "\\u0000", "_", "+");
  std::string text;
  for (const std::string& part : *rc::gen::container<std::vector<std::string>>(token)) {
    text += part;
  }
  check_is_an_answer(read_case_text(text, "source"));
}

}  // namespace
}  // namespace tautline::bench
