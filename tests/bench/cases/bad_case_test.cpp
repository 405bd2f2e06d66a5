#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

/// A good case file with one line replaced, and the one sentence it must give.
struct BadCase {
  std::string name;
  std::string line;         // of the good file
  std::string replacement;  //
  std::string sentence;     // after "case.toml:"
};

void PrintTo(const BadCase& bad, std::ostream* out) { *out << bad.name; }

/// A standard breakwater whose cables may be given other lengths.
std::string good_file() {
  return R"(name = "test"
duration = 20.0
gravity = [0.0, -1.0]
[body]
mass = 1.0
inertia = 0.01
[[cables]]
anchor = [-1.0, 1.2]
attachment = [-0.1, 0.0]
length = 1.5
restitution = 0.9
[[cables]]
anchor = [1.0, 1.2]
attachment = [0.1, 0.0]
length = 1.5
restitution = 0.8
[initial]
position = [0.1, 0.1]
velocity = [0.2, -0.1]
)";
}

std::string replaced(std::string text, const std::string& line, const std::string& by) {
  for (std::size_t place = text.find(line); place != std::string::npos;
       place = text.find(line, place + by.size())) {
    text.replace(place, line.size(), by);
  }
  return text;
}

Outcome solve_text(const std::string& text) {
  const TemporaryFolder folder;
  return program({"solve", folder.file("case.toml", text).string()});
}

TEST(CaseFile, ThatIsGoodSolves) { EXPECT_EQ(solve_text(good_file()).code, 0); }

class BadCaseFile : public testing::TestWithParam<BadCase> {};

TEST_P(BadCaseFile, GivesOneSentenceAndExitCode2) {
  const auto& [name, line, replacement, sentence] = GetParam();
  const std::string text = replaced(good_file(), line, replacement);
  ASSERT_NE(text, good_file());
  const Outcome outcome = solve_text(text);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.output, "");
  const std::size_t place = outcome.errors.find("case.toml:");
  ASSERT_NE(place, std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.errors.substr(place, sentence.size() + 10), "case.toml:" + sentence);
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
}

INSTANTIATE_TEST_SUITE_P(
    Each, BadCaseFile,
    testing::Values(
        BadCase{"UnknownKey", "restitution = 0.8", "restitution = 0.8\ntension = 3",
                "17: cables[1].tension = 3: unknown key, must be anchor, attachment, length, "
                "restitution, capture_speed, restitution_table or taut"},
        BadCase{"WrongType", "mass = 1.0", "mass = \"heavy\"",
                "5: body.mass = \"heavy\": is a string, must be a finite number above 0 [kg]"},
        BadCase{"Nan", "mass = 1.0", "mass = nan",
                "5: body.mass = nan: must be a finite number above 0 [kg]"},
        BadCase{"Infinity", "position = [0.1, 0.1]", "position = [inf, 0.1]",
                "18: initial.position[0] = inf: must be a finite number [m]"},
        BadCase{"ZeroLength", "length = 1.5\nrestitution = 0.8", "length = 0.0\nrestitution = 0.8",
                "15: cables[1].length = 0: must be a finite number above 0 [m]"},
        BadCase{"NegativeMass", "mass = 1.0", "mass = -2.0",
                "5: body.mass = -2: must be a finite number above 0 [kg]"},
        BadCase{"RestitutionAbove1", "restitution = 0.8", "restitution = 1.2",
                "16: cables[1].restitution = 1.2: must be in [0, 1]"},
        BadCase{"RestitutionBelow0", "restitution = 0.8", "restitution = -0.1",
                "16: cables[1].restitution = -0.1: must be in [0, 1]"},
        BadCase{"Overstretch", "position = [0.1, 0.1]", "position = [0.6, 0.1]",
                "7: cable 0: overstretched at the start by 0.36010752377"},
        BadCase{"CannotFloat", "length = 1.5", "length = 0.85",
                "7: cables 0 and 1 cannot reach: their anchors are 2 m apart, lengths and body "
                "span only 1.9 m; the body cannot float"}),
    [](const auto& test) { return test.param.name; });

TEST(BadCaseFile, OfEveryOtherKindGivesASentenceWithExitCode2) {
  const TemporaryFolder folder;
  const auto refuses = [](const std::string& path, const std::string& sentence) {
    const Outcome outcome = program({"solve", path});
    EXPECT_EQ(outcome.code, 2) << path;
    EXPECT_NE(outcome.errors.find(sentence), std::string::npos) << path << ": " << outcome.errors;
  };
  const std::string big = folder.file("big.toml", "").string();
  std::filesystem::resize_file(big, std::uintmax_t{1} << 30U);
  refuses(big, "is 1073741824 bytes long, must be at most 1048576");
  std::filesystem::create_directory(folder.path() / "folder.toml");
  refuses((folder.path() / "folder.toml").string(), "is a directory, must be a file");
  refuses((folder.path() / "none.toml").string(), "no such file");
  refuses(folder
              .file("junk.toml", std::string("\x7f"
                                             "ELF\x02\x01\0\0\xff\xfe",
                                             10))
              .string(),
          "");
  const std::string empty = folder.file("empty.toml", "").string();
  for (const char* key :
       {"name", "duration", "gravity", "body.mass", "body.inertia", "cables", "initial.position"}) {
    refuses(empty, std::string(key) + ": is missing");
  }
  std::string nine = good_file();
  for (int more = 0; more < 7; ++more) {
    nine.insert(nine.find("[initial]"),
                "[[cables]]\nanchor = [0.0, 1.2]\nattachment = [0.0, 0.0]\nlength = 3.0\n"
                "restitution = 1.0\n");
  }
  refuses(folder.file("nine.toml", nine).string(), "9 given, must be 1 to 8");
}

}  // namespace
}  // namespace tautline::test
