
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <ostream>
#include <string>

#include "tautline/case_file.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::bench {
namespace {

using Strings = std::vector<std::string>;

/// A sound file; the line numbers of the table below count from here.
const std::string sound = R"(name = "ball"
duration = 20.0
gravity = [0.0, -1.0]

[body]
mass = 1.0
inertia = 0.01

[[cables]]
anchor = [0.0, 1.25]
attachment = [-0.1, 0.0]
length = 1.5
restitution = 0.9

[initial]
position = [0.1, 0.25]
)";

/// What a change of one place in the sound file must lead to.
struct BadInput {
  std::string place;
  std::string instead;
  Strings sentences;
};

void PrintTo(const BadInput& input, std::ostream* stream) {
  *stream << input.place << " -> " << input.instead;
}

std::string changed(const BadInput& input) {
  std::string text = sound;
  const std::size_t start = text.find(input.place);
  EXPECT_NE(start, std::string::npos) << input.place;
  return text.replace(start, input.place.size(), input.instead);
}

const std::string cables_right =
    "must be 1 to 8 tables [[cables]], each with anchor, attachment, length and restitution";

const std::vector<BadInput> wrong_values = {
    {"restitution = 0.9",
     "restitution = 1.2",
     {"ball.toml:13: cables[0].restitution = 1.2: must be in [0, 1]"}},
    {"restitution = 0.9",
     "restitution = nan",
     {"ball.toml:13: cables[0].restitution = nan: must be in [0, 1]"}},
    {"length = 1.5",
     "length = 0",
     {"ball.toml:12: cables[0].length = 0: must be a finite number above 0 [m]"}},
    {"mass = 1.0",
     "mass = -1.5",
     {"ball.toml:6: body.mass = -1.5: must be a finite number above 0 [kg]"}},
    {"inertia = 0.01",
     "inertia = -inf",
     {"ball.toml:7: body.inertia = -inf: must be a finite number, 0 or above [kg m^2]"}},
    {"restitution = 0.9",
     "restitution = 0.9\ncapture_speed = -1.0",
     {"ball.toml:14: cables[0].capture_speed = -1: must be a finite number, 0 or above [m/s]"}},
    {"restitution = 0.9",
     "restitution = 0.9\nrestitution_table = [[0.0, nan]]",
     {"ball.toml:14: cables[0].restitution_table[0][1] = nan: must be a finite number [m/s, -]"}},
    {"20.0", "+inf", {"ball.toml:2: duration = inf: must be a finite number above 0 [s]"}},
    {"[0.0, -1.0]",
     "[0.0, nan]",
     {"ball.toml:3: gravity[1] = nan: must be a finite number [m/s^2]"}},
    {"\n[body]",
     "angle_limit = 0.0\n[body]",
     {"ball.toml:4: angle_limit = 0: must be a finite number above 0 [rad]"}},
    {"\n[body]",
     "ceiling = inf\n[body]",
     {"ball.toml:4: ceiling = inf: must be a finite number [m]"}},
    {"\"ball\"", "\"\"", {"ball.toml:1: name = \"\": must be a string that is not empty"}},
};

const std::vector<BadInput> wrong_types = {
    {"20.0",
     "\"20\"",
     {"ball.toml:2: duration = \"20\": is a string, must be a finite number above 0 [s]"}},
    {"\"ball\"", "7", {"ball.toml:1: name = 7: is an integer, must be a string that is not empty"}},
    {"mass = 1.0",
     "mass = true",
     {"ball.toml:6: body.mass = true: is a boolean, must be a finite number above 0 [kg]"}},
    {"mass = 1.0",
     "mass = 1979-05-27",
     {"ball.toml:6: body.mass = 1979-05-27: is a date or time, must be a finite number above 0 "
      "[kg]"}},
    {"mass = 1.0",
     "mass = {kg = 1}",
     {"ball.toml:6: body.mass: is a table, must be a finite number above 0 [kg]"}},
    {"[0.0, -1.0]",
     "-9.81",
     {"ball.toml:3: gravity = -9.81: is a number, must be two numbers [x, y] [m/s^2]"}},
    {"[0.0, -1.0]",
     "[0, -1, 0]",
     {"ball.toml:3: gravity = [0, -1, 0]: is an array of length 3, must be two numbers [x, y] "
      "[m/s^2]"}},
    {"[0.0, -1.0]",
     "[]",
     {"ball.toml:3: gravity = []: is an array of length 0, must be two numbers [x, y] [m/s^2]"}},
    {"[0.0, -1.0]",
     "[0, \"down\"]",
     {"ball.toml:3: gravity[1] = \"down\": is a string, must be a finite number [m/s^2]"}},
    {"\n[body]\nmass = 1.0\ninertia = 0.01",
     "body = 3",
     {"ball.toml: body.mass: is missing, must be a finite number above 0 [kg]",
      "ball.toml: body.inertia: is missing, must be a finite number, 0 or above [kg m^2]",
      "ball.toml:4: body = 3: is an integer, must be a table"}},
    {"restitution = 0.9",
     "restitution = 0.9\nrestitution_table = 0.5",
     {"ball.toml:14: cables[0].restitution_table = 0.5: is a number, must be an array of pairs "
      "[speed, restitution] [m/s, -]"}},
    {"restitution = 0.9",
     "restitution = 0.9\nrestitution_table = []",
     {"ball.toml:14: cables[0].restitution_table = []: none given, must be an array of pairs "
      "[speed, restitution] [m/s, -]"}},
    {"restitution = 0.9",
     "restitution = 0.9\nrestitution_table = [[0.0, 0.9], 1.0]",
     {"ball.toml:14: cables[0].restitution_table[1] = 1: is a number, must be two numbers [speed, "
      "restitution] [m/s, -]"}},
    {"[[cables]]", "[cables]", {"ball.toml:9: cables: is a table, " + cables_right}},
};

const std::vector<BadInput> wrong_keys = {
    {"length = 1.5",
     "lenght = 1.5",
     {"ball.toml:9: cables[0].length: is missing, must be a finite number above 0 [m]",
      "ball.toml:12: cables[0].lenght = 1.5: unknown key; did you mean length?"}},
    {"\n[body]",
     "colour = \"red\"\n[body]",
     {"ball.toml:4: colour = \"red\": unknown key, must be name, duration, gravity, angle_limit, "
      "ceiling, body, cables or initial"}},
    {"\n[body]",
     "\"\\u001b[2J\" = 1\n[body]",
     {"ball.toml:4: \\x1b[2J = 1: unknown key, must be name, duration, gravity, angle_limit, "
      "ceiling, body, cables or initial"}},
    {"[body]",
     "[bdoy]",
     {"ball.toml: body.mass: is missing, must be a finite number above 0 [kg]",
      "ball.toml: body.inertia: is missing, must be a finite number, 0 or above [kg m^2]",
      "ball.toml:5: bdoy: unknown key; did you mean body?"}},
    {"name = \"ball\"\n", "", {"ball.toml: name: is missing, must be a string that is not empty"}},
    {"gravity = [0.0, -1.0]\n",
     "",
     {"ball.toml: gravity: is missing, must be two numbers [x, y] [m/s^2]"}},
    {"position = [0.1, 0.25]\n",
     "spni = 1\n",
     {"ball.toml:15: initial.position: is missing, must be two numbers [x, y] [m]",
      "ball.toml:16: initial.spni = 1: unknown key; did you mean spin?"}},
    {"name = \"ball\"\n",
     "name = \"ball\"\nname = \"ball\"\n",
     {"ball.toml:2: column 8: not TOML: Error while parsing key-value pair: cannot redefine "
      "existing string 'name'"}},
};

const std::vector<BadInput> wrong_cases = {
    {"length = 1.5",
     "length = 0.75",
     {"ball.toml:9: cable 0: overstretched at the start by 0.25 m: its ends are "
      "1 m apart, its length is 0.75 m; a length of 1 m would do"}},
    {"inertia = 0.01",
     "inertia = 0",
     {"ball.toml:7: body: inertia 0 is for a point mass, whose attachments are all [0, 0]; give an "
      "inertia above 0 [kg m^2]"}},
    {"restitution = 0.9",
     "restitution = 0.9\nrestitution_table = [[1.0, 0.9], [0.5, 0.8]]",
     {"ball.toml:9: cable 0: restitution_table[1]: speed 0.5 must be above the one before, 1 "
      "[m/s]"}},
    {"\n[body]",
     "ceiling = 0.1\n[body]",
     {"ball.toml:9: cable 0: attachment starts at height 0.25, above ceiling 0.1"}},
};

const std::vector<BadInput> wrong_text = {
    {"20.0",
     "",
     {"ball.toml:2: column 12: not TOML: Error while parsing key-value pair: expected "
      "value, saw '\\n'"}},
    {"20.0",
     "1e999",
     {"ball.toml:2: column 17: not TOML: Error while parsing floating-point: "
      "'1e999' is not representable in 64 bits"}},
    {"ball\"", "\xff\"", {"ball.toml:1: column 8: not TOML: Encountered invalid utf-8 sequence"}},
    {"20.0",
     "2\u00e9",
     {"ball.toml:2: column 13: not TOML: Error while parsing decimal integer: expected digit, "
      "saw '\u00e9'"}},
    {"20.0", std::string("\0", 1), {"ball.toml:2: holds a zero byte: must be a text file (TOML)"}},
    {"\n[body]",
     "# " + std::string(5000, '-') + "\n[body]",
     {"ball.toml:4: is 5002 bytes long, a line has at most 4096"}},
};

class BadInputs : public testing::TestWithParam<BadInput> {};

TEST_P(BadInputs, LeadToExactlyTheseSentences) {
  const CaseReading reading = read_case_text(changed(GetParam()), "ball.toml");
  EXPECT_EQ(reading.problems, GetParam().sentences);
  EXPECT_FALSE(reading.the_case);
}

INSTANTIATE_TEST_SUITE_P(Values, BadInputs, testing::ValuesIn(wrong_values));
INSTANTIATE_TEST_SUITE_P(Types, BadInputs, testing::ValuesIn(wrong_types));
INSTANTIATE_TEST_SUITE_P(Keys, BadInputs, testing::ValuesIn(wrong_keys));
INSTANTIATE_TEST_SUITE_P(Cases, BadInputs, testing::ValuesIn(wrong_cases));
INSTANTIATE_TEST_SUITE_P(Text, BadInputs, testing::ValuesIn(wrong_text));

/// How the changed file breaks the schema of case files; none where JSON cannot have its numbers.
std::optional<std::string> broken_rules_of(const BadInput& input) {
  static const auto schema = nlohmann::json::parse(test::content_of(TAUTLINE_CASE_SCHEMA));
  const std::string text = changed(input);
  const bool finite =
      text.find("nan") == std::string::npos && text.find("inf") == std::string::npos;
  const nlohmann::json file = test::file_as_json(text);
  return finite && !file.is_null() ? std::optional(tautline::test::broken_rules(file, schema))
                                   : std::nullopt;
}

TEST(CaseSchema, RefusesValuesTypesAndKeysAndLeavesRulesOfTheWholeCaseToTheReader) {
  std::size_t refused = 0;
  for (const auto& list : {wrong_values, wrong_types, wrong_keys}) {
    for (const BadInput& input : list) {
      const auto broken = broken_rules_of(input);
      const bool is_right_in_space =
          input.sentences.front().find("is an array of length 3") != std::string::npos;
      EXPECT_EQ(broken == "", is_right_in_space) << input.place << " -> " << input.instead;
      refused += broken ? 1U : 0U;
    }
  }
  EXPECT_GE(refused, 25U);
  for (const BadInput& input : wrong_cases) {
    EXPECT_EQ(broken_rules_of(input), "") << input.place << " -> " << input.instead;
  }
}

TEST(CaseText, EveryNumberHasItsRange) {
  const std::string all = "angle_limit = 1.5\nceiling = 9.5\n" + sound +
                          "angle = 0.125\nvelocity = [0.5, 0.75]\n" + "spin = 0.625\n";
  const std::string full = std::string(all).replace(
      all.find("restitution = 0.9"), 17,
      "restitution = 0.9\ncapture_speed = 0.0625\nrestitution_table = [[0.3, 0.8]]");
  ASSERT_TRUE(read_case_text(full, "ball.toml").the_case);
  std::size_t numbers = 0;
  for (std::size_t at = 0; at < full.size(); ++at) {
    const bool starts =
        (std::isdigit(static_cast<unsigned char>(full[at])) != 0 || full[at] == '-') &&
        (full[at - 1] == ' ' || full[at - 1] == '[');
    if (!starts) {
      continue;
    }
    ++numbers;
    const std::size_t end = std::min(full.find_first_of(",]\n", at), full.size());
    for (const char* wrong :
         {"nan", "inf", "-inf", "1e300", "-1e300", "9223372036854775807000.0"}) {
      const std::string text = std::string(full).replace(at, end - at, wrong);
      const CaseReading reading = read_case_text(text, "ball.toml");
      EXPECT_FALSE(reading.the_case) << text;
      EXPECT_FALSE(reading.problems.empty()) << text;
    }
  }
  EXPECT_EQ(numbers, 22U);
}

TEST(CaseText, SoundFileIsReadWithZeroForWhatMayBeLeftOut) {
  const CaseReading reading = read_case_text(sound, "ball.toml");
  ASSERT_TRUE(reading.the_case) << reading.problems.front();
  EXPECT_EQ(reading.the_case->name, "ball");
  EXPECT_EQ(reading.the_case->gravity, Vec2(0.0, -1.0));
  EXPECT_EQ(reading.the_case->cables.size(), 1U);
  EXPECT_EQ(reading.the_case->initial.position, Vec2(0.1, 0.25));
  EXPECT_EQ(reading.the_case->initial.velocity, Vec2(0.0, 0.0));
  EXPECT_EQ(reading.the_case->initial.angle, 0.0);
  EXPECT_EQ(reading.the_case->initial.spin, 0.0);
  EXPECT_FALSE(reading.the_case->angle_limit);
  EXPECT_FALSE(reading.the_case->ceiling);
}

TEST(CaseText, IntegersStandForNumbers) {
  const BadInput integers = {"[0.0, -1.0]", "[0, -1]", {}};
  const CaseReading reading = read_case_text(changed(integers), "ball.toml");
  ASSERT_TRUE(reading.the_case) << reading.problems.front();
  EXPECT_EQ(reading.the_case->gravity, Vec2(0.0, -1.0));
}

TEST(CaseText, RestitutionMayDependOnTheSpeed) {
  const BadInput table = {
      "restitution = 0.9",
      "restitution = 0.9\ncapture_speed = 0.125\nrestitution_table = [[0, 1], [2.5, 0.5]]",
      {}};
  const CaseReading reading = read_case_text(changed(table), "ball.toml");
  ASSERT_TRUE(reading.the_case) << reading.problems.front();
  const Cable& cable = reading.the_case->cables.front();
  EXPECT_EQ(cable.capture_speed, 0.125);
  ASSERT_EQ(cable.restitution_table.size(), 2U);
  EXPECT_EQ(cable.restitution_table[1].speed, 2.5);
  EXPECT_EQ(cable.restitution_table[1].restitution, 0.5);
  const Cable plain = read_case_text(sound, "ball.toml").the_case->cables.front();
  EXPECT_FALSE(depends_on_speed(plain));
  // a case without them is written as before they existed
  EXPECT_EQ(write_case(bouncing_ball()).find("capture_speed"), std::string::npos);
  EXPECT_EQ(write_case(bouncing_ball()).find("restitution_table"), std::string::npos);
}

/// The sound file with a start 1e-7 m too far or too near, and its cable taut.
std::string typed(const std::string& y, const std::string& taut) {
  std::string text = changed({"[0.1, 0.25]", "[0.1, " + y + "]", {}});
  const std::string key = "restitution = 0.9";
  return text.replace(text.find(key), key.size(), key + "\n" + taut);
}

TEST(CaseText, ATypedStartIsMadeTautWhereTheCableAsksForIt) {
  for (const char* const y : {"-0.2500001", "-0.2499999"}) {
    const CaseReading reading = read_case_text(typed(y, "taut = true"), "ball.toml");
    ASSERT_TRUE(reading.the_case) << reading.problems.front();
    const Case& found = *reading.the_case;
    EXPECT_LE(std::abs(gap(found.cables[0], found.initial)), 1e-15) << y;
    // the arm of 0.1 m turns as easily as the body moves, as I / arm^2 is its mass: half and half
    const double half = (std::stod(y) + 0.25) / 2.0;
    EXPECT_NEAR(found.initial.position.y(), -0.25 + half, 1e-12);
    EXPECT_NEAR(found.initial.angle, 10.0 * half, 1e-11);
    EXPECT_EQ(found.initial.position.x(), 0.1);
    EXPECT_EQ(
        reading.notes,
        Strings{"ball.toml:16: cable 0 starts taut: the start changes its position by 5e-08 m, "
                "angle by 5e-07 rad"})
        << y;
    // what it was changed to is written, and is not changed again
    const CaseReading again = read_case_text(write_case(found), "again.toml");
    ASSERT_TRUE(again.the_case);
    EXPECT_EQ(again.the_case->initial.position, found.initial.position);
    const CaseReading asked = read_case_text(write_case(found), "again.toml", CableSet::of(0));
    ASSERT_TRUE(asked.the_case);
    EXPECT_EQ(asked.the_case->initial.position, found.initial.position);
    EXPECT_EQ(asked.notes, Strings{});
  }
}

TEST(CaseText, WithoutTautAStartIsReadAsItIsTyped) {
  const CaseReading open = read_case_text(typed("-0.2499999", "taut = false"), "ball.toml");
  ASSERT_TRUE(open.the_case);
  EXPECT_EQ(open.the_case->initial.position.y(), -0.2499999);
  EXPECT_EQ(open.notes, Strings{});
  const Strings problems = read_case_text(typed("-0.2500001", ""), "ball.toml").problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_TRUE(problems.front().ends_with("m would do, or taut = true, which moves the start"))
      << problems.front();
}

TEST(CaseText, TautTakesUpNoMoreThanAThousandthOfTheLength) {
  for (const char* const y : {"-0.26", "-0.24"}) {
    const CaseReading reading = read_case_text(typed(y, "taut = true"), "ball.toml");
    ASSERT_EQ(reading.problems.size(), 1U) << y;
    EXPECT_TRUE(reading.problems.front().starts_with("ball.toml:9: cable 0: cannot start taut: "))
        << reading.problems.front();
  }
  EXPECT_EQ(read_case_text(typed("-0.25", "taut = 1"), "ball.toml").problems,
            Strings{"ball.toml:14: cables[0].taut = 1: is an integer, must be true or false"});
  EXPECT_EQ(read_case_text(sound, "ball.toml", CableSet::of(3)).problems,
            Strings{"ball.toml: cable 3 cannot start taut: the case has 1 cable"});
}

TEST(CaseText, EmptyFileLacksEveryKeyThatIsRequired) {
  EXPECT_EQ(read_case_text("", "empty.toml").problems,
            (Strings{"empty.toml: name: is missing, must be a string that is not empty",
                     "empty.toml: duration: is missing, must be a finite number above 0 [s]",
                     "empty.toml: gravity: is missing, must be two numbers [x, y] [m/s^2]",
                     "empty.toml: body.mass: is missing, must be a finite number above 0 [kg]",
                     // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): one sentence, two lines
                     "empty.toml: body.inertia: is missing, must be a finite number, 0 or above "
                     "[kg m^2]",
                     "empty.toml: cables: is missing, " + cables_right,
                     "empty.toml: initial.position: is missing, must be two numbers [x, y] [m]"}));
}

TEST(CaseText, SeveralProblemsComeTogetherInTheOrderOfTheirLines) {
  std::string text = sound;
  text.replace(text.find("20.0"), 4, "-20.0");
  text.replace(text.find("0.9"), 3, "9");
  EXPECT_EQ(read_case_text(text, "ball.toml").problems,
            (Strings{"ball.toml:2: duration = -20: must be a finite number above 0 [s]",
                     "ball.toml:13: cables[0].restitution = 9: must be in [0, 1]"}));
}

TEST(CaseText, NineCablesAreOneTooMany) {
  std::string text = sound;
  const std::size_t start = text.find("[[cables]]");
  const std::string cable = text.substr(start, text.find("[initial]") - start);
  for (int extra = 0; extra < 8; ++extra) {
    text.insert(start, cable);
  }
  EXPECT_EQ(read_case_text(text, "ball.toml").problems,
            Strings{"ball.toml:57: cables: 9 given, " + cables_right});
}

TEST(CaseText, RulesOfTheCaseNameTheLineTheyAreAbout) {
  std::string text = sound;
  text.replace(text.find("\n[body]"), 1, "angle_limit = 1.5\n");
  text += "angle = -2\n";
  EXPECT_EQ(read_case_text(text, "ball.toml").problems.front(),
            "ball.toml:17: initial: angle -2 is beyond angle_limit 1.5");
}

TEST(CaseText, FloodOfProblemsIsCutWithTheirNumber) {
  std::string text = sound.substr(0, sound.find("\n[body]"));
  for (int key = 0; key < 50'000; ++key) {
    text.append("k").append(std::to_string(key)).append(" = 1\n");
  }
  const Strings problems = read_case_text(text, "ball.toml").problems;
  ASSERT_EQ(problems.size(), 101U);
  EXPECT_EQ(problems.back(), "ball.toml: and 49904 more problems");
}

}  // namespace
}  // namespace tautline::bench
