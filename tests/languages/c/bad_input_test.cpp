// Whatever a caller gets wrong ends in a status or a sentence.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "owned.hpp"
#include "tautline/case_text.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::c::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t huge = std::numeric_limits<std::size_t>::max();

OwnedCase ball() { return from_numbers(bouncing_ball()); }

OwnedCase from_text(const std::string& text, const char* name = "case") {
  return OwnedCase(tautline_case_from_text(text.data(), text.size(), name));
}

/// The problems of a ball whose structs `change` has changed.
template <class Change>
std::string problems_with(const Change& change) {
  auto numbers = sized<tautline_planar_case>();
  numbers.mass = 1.0;
  numbers.inertia = 0.4;
  numbers.gravity[1] = -1.0;
  numbers.duration = 10.0;
  std::array<tautline_cable, 9> cables{};
  for (tautline_cable& cable : cables) {
    cable = sized<tautline_cable>();
    cable.length = 2.0;
    cable.restitution = 0.5;
  }
  std::size_t count = 1;
  change(numbers, cables, count);
  return problems_of(
      OwnedCase(tautline_case_from_numbers(&numbers, cables.data(), count, nullptr, 0, "ball")));
}

TEST(BadInput, VersionIsThatOfTheProject) {
  EXPECT_STREQ(tautline_version(), TAUTLINE_VERSION);
  EXPECT_EQ(tautline_version_number(), TAUTLINE_VERSION_NUMBER);
  EXPECT_EQ(TAUTLINE_MOST_CABLES, static_cast<int>(max_cables));
}

TEST(BadInput, NamesEndWithNull) {
  const auto count = [](const char* (*name)(std::int32_t)) {
    std::int32_t value = 0;
    while (name(value) != nullptr) {
      EXPECT_GT(std::strlen(name(value)), 0U);
      ++value;
    }
    EXPECT_EQ(name(-1), nullptr);
    EXPECT_EQ(name(std::numeric_limits<std::int32_t>::min()), nullptr);
    EXPECT_EQ(name(std::numeric_limits<std::int32_t>::max()), nullptr);
    return value;
  };
  EXPECT_EQ(count(tautline_status_text), TAUTLINE_BROKEN + 1);
  EXPECT_EQ(count(tautline_law_name), 4);
  EXPECT_EQ(count(tautline_event_kind_name), 3);
  EXPECT_EQ(count(tautline_ending_name), TAUTLINE_OVERFLOW + 1);
}

TEST(BadInput, CoordinatesHaveNamesAndUnits) {
  const OwnedCase good = ball();
  ASSERT_EQ(tautline_coordinates(good.get()), 6U);
  std::string words;
  for (std::size_t index = 0; index < 6; ++index) {
    words += std::string(tautline_coordinate_name(good.get(), index)) + " [" +
             tautline_coordinate_unit(good.get(), index) + "] ";
  }
  EXPECT_EQ(words, "x [m] y [m] angle [rad] vx [m/s] vy [m/s] spin [rad/s] ");
  EXPECT_EQ(tautline_coordinate_name(good.get(), 6), nullptr);
  EXPECT_EQ(tautline_coordinate_unit(good.get(), huge), nullptr);
  EXPECT_EQ(tautline_coordinates(nullptr), 0U);
  EXPECT_EQ(tautline_coordinate_name(nullptr, 0), nullptr);
  EXPECT_EQ(tautline_cables(nullptr), 0U);
  EXPECT_EQ(tautline_cables(from_text("x").get()), 0U);
}

TEST(BadInput, NullIsRefused) {
  const OwnedCase good = ball();
  const OwnedMotion motion = solved(good);
  const double time = 0.0;
  double number = 0.0;
  tautline_case_free(nullptr);
  tautline_motion_free(nullptr);
  EXPECT_EQ(tautline_problems(nullptr, nullptr, 0), std::strlen("case: is null"));
  EXPECT_EQ(tautline_notes(nullptr, nullptr, 0), 0U);
  EXPECT_EQ(tautline_case_name(nullptr, nullptr, 0), 0U);
  EXPECT_EQ(problems_of(OwnedCase(tautline_case_from_text(nullptr, 5, nullptr))),
            "case: text is null");
  EXPECT_EQ(
      problems_of(OwnedCase(tautline_case_from_numbers(nullptr, nullptr, 1, nullptr, 0, nullptr))),
      "tautline_planar_case: is null\ntautline_cable: is null");
  tautline_motion* none = nullptr;
  EXPECT_EQ(tautline_solve(nullptr, nullptr, &none), TAUTLINE_NULL);
  EXPECT_EQ(tautline_solve(good.get(), nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_summarise(nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_summarise(motion.get(), nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_settle(motion.get(), nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_settle(nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_states(nullptr, &time, 1, &number, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_states(motion.get(), nullptr, 1, &number, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_tensions(nullptr, &time, 1, &number, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_energy(nullptr, &time, 1, &number, nullptr, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_state_errors(nullptr, &time, 1, &number, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_events(nullptr, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_NULL);
  EXPECT_EQ(tautline_arcs(nullptr, 0, 0, nullptr, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_accumulations(nullptr, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_NULL);
  EXPECT_EQ(tautline_horizon(nullptr, nullptr, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_unsure(nullptr, 0, 0, nullptr, nullptr, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(
      tautline_event_errors(nullptr, 0, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
      TAUTLINE_NULL);
  EXPECT_EQ(tautline_gaps(nullptr, &time, 1, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_gaps(good.get(), nullptr, 1, nullptr, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_case_text(nullptr, TAUTLINE_TOML, nullptr, 0, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_case_vary(good.get(), nullptr, &time, 1, nullptr, nullptr), TAUTLINE_NULL);
  tautline_case* varied = nullptr;
  EXPECT_EQ(tautline_case_vary(good.get(), nullptr, &time, 1, &varied, nullptr), TAUTLINE_NULL);
  EXPECT_EQ(tautline_sweep(nullptr, 1, nullptr, 1, nullptr, 0, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_NULL);
  const std::array<const tautline_case*, 2> cases = {good.get(), nullptr};
  std::size_t wrong = 7;
  EXPECT_EQ(
      tautline_sweep(cases.data(), 2, nullptr, 1, nullptr, 0, nullptr, nullptr, nullptr, &wrong),
      TAUTLINE_NULL);
  EXPECT_EQ(wrong, 1U);
  // outputs that nobody wants are skipped, and nothing is asked of nothing
  EXPECT_EQ(
      tautline_events(motion.get(), 0, 3, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr),
      TAUTLINE_OK);
  EXPECT_EQ(tautline_states(motion.get(), nullptr, 0, nullptr, nullptr, nullptr), TAUTLINE_OK);
  EXPECT_EQ(tautline_horizon(motion.get(), nullptr, nullptr, nullptr), TAUTLINE_OK);
  EXPECT_EQ(tautline_sweep(nullptr, 0, nullptr, 0, nullptr, 0, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_OK);
}

TEST(BadInput, SizesOfStructsAreChecked) {
  for (const std::int32_t size : {0, -1, 8, 104, 116, 5000, std::numeric_limits<int>::min(),
                                  std::numeric_limits<int>::max()}) {
    EXPECT_EQ(problems_with([&](auto& numbers, auto&, auto&) { numbers.size = size; }),
              "tautline_planar_case: size " + std::to_string(size) +
                  " is not that of the struct: must be sizeof(tautline_planar_case), 112 in this "
                  "version, and the members that it does not know 0");
    EXPECT_NE(problems_with([&](auto&, auto& cables, auto&) {
                cables[0].size = size;
              }).find("must be sizeof(tautline_cable), 72 in this version"),
              std::string::npos);
    const OwnedCase good = ball();
    const OwnedMotion motion = solved(good);
    auto options = sized<tautline_options>();
    auto summary = sized<tautline_summary>();
    auto settling = sized<tautline_settling>();
    options.size = summary.size = settling.size = size == 104 ? 40 : size;
    tautline_motion* none = nullptr;
    EXPECT_EQ(tautline_solve(good.get(), &options, &none), TAUTLINE_BAD_OPTION);
    EXPECT_EQ(tautline_summarise(motion.get(), &summary), TAUTLINE_BAD_SIZE);
    EXPECT_EQ(tautline_settle(motion.get(), &settling), TAUTLINE_BAD_SIZE);
    const tautline_case* one = good.get();
    EXPECT_EQ(tautline_sweep(&one, 1, nullptr, 1, nullptr, 0, &summary, nullptr, nullptr, nullptr),
              TAUTLINE_BAD_SIZE);
  }
}

TEST(BadInput, StructsOfALaterVersionAreTakenIfTheirNewMembersAreZero) {
  struct Later {
    tautline_options options;
    double added[2];
  };
  Later later{};
  later.options.size = sizeof later;
  later.options.law = TAUTLINE_POISSON;
  const OwnedCase good = ball();
  EXPECT_TRUE(solved(good, &later.options));
  later.added[1] = 1.0;
  tautline_motion* none = nullptr;
  EXPECT_EQ(tautline_solve(good.get(), &later.options, &none), TAUTLINE_BAD_OPTION);
  EXPECT_EQ(none, nullptr);

  struct LaterSummary {
    tautline_summary summary;
    double added;
  };
  std::array<LaterSummary, 3> swept{};
  for (LaterSummary& one : swept) {
    one.added = 5.0;
  }
  swept[0].summary.size = sizeof(LaterSummary);
  const std::array<const tautline_case*, 3> cases = {good.get(), good.get(), good.get()};
  ASSERT_EQ(tautline_sweep(cases.data(), 3, nullptr, 1, nullptr, 0, &swept[0].summary, nullptr,
                           nullptr, nullptr),
            TAUTLINE_OK);
  for (const LaterSummary& one : swept) {
    EXPECT_EQ(one.summary.size, static_cast<std::int32_t>(sizeof(LaterSummary)));
    EXPECT_EQ(one.summary.end_time, 10.0);
    EXPECT_EQ(one.added, 0.0);
  }
}

TEST(BadInput, WrongNumbersGetSentences) {
  EXPECT_EQ(problems_with([](auto& numbers, auto&, auto&) { numbers.mass = nan; }),
            "body: mass nan must be a finite number above 0 [kg]");
  EXPECT_EQ(problems_with([](auto& numbers, auto&, auto&) { numbers.start[5] = infinity; }),
            "initial: spin inf is not a finite number");
  EXPECT_EQ(problems_with([](auto& numbers, auto&, auto&) { numbers.has = 4; }),
            "tautline_planar_case: has 4 has unknown bits: must be a sum of TAUTLINE_HAS_...");
  EXPECT_EQ(problems_with([](auto& numbers, auto&, auto&) { numbers.has = 1; }),
            "angle_limit 0 must be a finite number above 0 [rad]");
  EXPECT_EQ(problems_with([](auto&, auto&, auto& count) { count = 9; }),
            "cables: 9 given; a case has 1 to 8");
  EXPECT_EQ(problems_with([](auto&, auto&, auto& count) { count = 0; }),
            "cables: 0 given; a case has 1 to 8");
  EXPECT_EQ(problems_with([](auto&, auto&, auto& count) { count = huge; }),
            "cables: " + std::to_string(huge) + " given; a case has 1 to 8");
  EXPECT_EQ(problems_with([](auto&, auto& cables, auto&) { cables[0].table_points = 3; }),
            "cable 0: table_points 3 must be 0 or above, and no more than the table has left: 0");
  EXPECT_EQ(problems_with([](auto&, auto& cables, auto&) { cables[0].reserved = 3; }),
            "cable 0: reserved 3 must be 0");
  EXPECT_EQ(problems_with([](auto&, auto& cables, auto& count) {
              count = 2;
              cables[1].restitution = 1.5;
              cables[0].length = nan;
            }),
            "cable 0: length nan must be a finite number above 0 [m]\n"
            "cable 1: restitution 1.5 is outside [0, 1]");
  auto numbers = sized<tautline_planar_case>();
  const auto cable = sized<tautline_cable>();
  const std::array<double, 4> table = {0.0, 1.0, 1.0, 0.5};
  EXPECT_NE(problems_of(
                OwnedCase(tautline_case_from_numbers(&numbers, &cable, 1, table.data(), 2, "\xff")))
                .find("name: must be text in UTF-8 that is not empty\n"
                      "table: has 2 points, the cables take 0"),
            std::string::npos);
  EXPECT_NE(problems_of(
                OwnedCase(tautline_case_from_numbers(&numbers, &cable, 1, nullptr, huge, nullptr)))
                .find("table: is null"),
            std::string::npos);
}

TEST(BadInput, NamesAreUtf8) {
  auto numbers = sized<tautline_planar_case>();
  numbers.mass = numbers.inertia = numbers.duration = 1.0;
  auto cable = sized<tautline_cable>();
  cable.length = 1.0;
  const auto accepted = [&](const char* name) {
    const OwnedCase made(tautline_case_from_numbers(&numbers, &cable, 1, nullptr, 0, name));
    const bool good = problems_of(made).empty();
    if (good) {  // then its text reads back, with the same name
      const OwnedCase again = from_text(text_of(made, TAUTLINE_TOML));
      std::array<char, 100> text{};
      tautline_case_name(again.get(), text.data(), text.size());
      EXPECT_STREQ(text.data(), name);
    }
    return good;
  };
  for (const char* name :
       {"ball", "Seil \xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\x8E\x88", "\"\\'#\t"}) {
    EXPECT_TRUE(accepted(name)) << name;
  }
  for (const char* name : {"", "\x80", "\xC3", "\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80",
                           "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "a\xE2\x82"}) {
    EXPECT_FALSE(accepted(name)) << name;
  }
}

TEST(BadInput, TextIsRefusedWithTheSentencesOfTheProgram) {
  for (const std::string& text :
       {std::string("name = 3\nduration = -1\n"), std::string("= 1"), std::string(""),
        std::string("name = 'x'\nlenght = 2\n[[cables]]\n[[cables]]\ntaut = 3\n"),
        std::string(5000, 'a'), std::string("a\0b", 3), std::string(R"({"name": 3})"),
        std::string("{"), std::string(R"({"a": 1e999})"), std::string("{\0}", 3)}) {
    const auto expected = read_case_text(text, "x/y.toml").problems;
    ASSERT_FALSE(expected.empty());
    std::string lines;
    for (const std::string& sentence : expected) {
      lines += (lines.empty() ? "" : "\n") + sentence;
    }
    EXPECT_EQ(problems_of(from_text(text, "x/y.toml")), lines);
  }
  EXPECT_EQ(problems_of(from_text(std::string(longest_case_file + 1, ' '), "x")),
            "x: is 1048577 bytes long, must be at most 1048576");
}

TEST(BadInput, JsonAndTomlOfACaseGetTheSameSentences) {
  const std::string toml =
      "name = ''\nduration = -1\nlenght = 2\ngravity = [0, 'down']\n"
      "cables = [{length = 0.0, anchor = [1], restitution_table = []}]\n";
  const std::string json =
      R"({"name": "", "duration": -1, "lenght": 2, "gravity": [0, "down"],
          "cables": [{"length": 0.0, "anchor": [1], "restitution_table": []}]})";
  const auto sorted_without_lines = [](const std::string& lines) {
    std::vector<std::string> sentences;
    for (std::size_t at = 0; at < lines.size();) {
      const std::size_t end = std::min(lines.find('\n', at), lines.size());
      std::string one = lines.substr(at, end - at);
      const std::size_t colon = one.find(": ");
      sentences.push_back(one.substr(colon + 2));
      at = end + 1;
    }
    std::sort(sentences.begin(), sentences.end());
    return sentences;
  };
  const auto of_toml = sorted_without_lines(problems_of(from_text(toml)));
  EXPECT_EQ(sorted_without_lines(problems_of(from_text(json))), of_toml);
  EXPECT_GT(of_toml.size(), 8U);
}

TEST(BadInput, JsonHasNothingThatTomlHasNot) {
  const auto said = [](const std::string& text) { return problems_of(from_text(text, "c")); };
  EXPECT_EQ(said(R"({"name": "a", "name": "b"})"), "c: name: is given twice");
  EXPECT_EQ(said(R"({"cables": [{"length": 1}, {"length": null}]})"),
            "c: cables[1].length: is null, leave the key out instead");
  EXPECT_EQ(
      said("{" + std::string(1000, ' ') + "\"a\":" + std::string(100'000, '[')),
      "c: a[0][0][0][0][0][0][0][0][0][0][0][0][0][0][0]: is nested more than 16 levels deep");
  EXPECT_EQ(said("{\n\"a\": 1e999}"), "c:2: column 10: not JSON: number overflow parsing '1e999'");
  EXPECT_EQ(said("\xEF\xBB\xBF {\"a\": NaN}").substr(0, 23), "c:1: column 11: not JSO");
  EXPECT_EQ(said(R"({"a": 1} 2)").substr(0, 25), "c:1: column 10: not JSON:");
  EXPECT_EQ(said(std::string("{\"a\":\n 1}\0", 10)),
            "c:2: holds a zero byte: must be a text file (JSON)");
  EXPECT_EQ(said("{\"a\": \"\xff\"}").substr(0, 24), "c:1: column 8: not JSON:");
  EXPECT_EQ(said("[1]").substr(0, 2), "c:");
}

TEST(BadInput, TextIsCutToItsRoom) {
  const OwnedCase bad = from_text("name = 3");
  const std::string whole = problems_of(bad);
  std::array<char, 8> text{};
  text.fill('x');
  EXPECT_EQ(tautline_problems(bad.get(), text.data(), 5), whole.size());
  EXPECT_EQ(std::string(text.data()), whole.substr(0, 4));
  EXPECT_EQ(text[5], 'x');
  EXPECT_EQ(tautline_problems(bad.get(), text.data(), 0), whole.size());
  EXPECT_EQ(tautline_problems(bad.get(), nullptr, 5), whole.size());
}

TEST(BadInput, ACaseWithProblemsIsNotSolved) {
  const OwnedCase bad = from_text("name = 3");
  tautline_motion* motion = nullptr;
  EXPECT_EQ(tautline_solve(bad.get(), nullptr, &motion), TAUTLINE_BAD_CASE);
  EXPECT_EQ(motion, nullptr);
  EXPECT_EQ(tautline_case_text(bad.get(), TAUTLINE_TOML, nullptr, 0, nullptr), TAUTLINE_BAD_CASE);
  EXPECT_EQ(tautline_case_text(ball().get(), 2, nullptr, 0, nullptr), TAUTLINE_BAD_OPTION);
  tautline_case* varied = nullptr;
  EXPECT_EQ(tautline_case_vary(bad.get(), nullptr, nullptr, 0, &varied, nullptr),
            TAUTLINE_BAD_CASE);
  EXPECT_EQ(tautline_gaps(bad.get(), nullptr, 0, nullptr, nullptr), TAUTLINE_BAD_CASE);
  EXPECT_EQ(tautline_sweep_varied(bad.get(), nullptr, 0, nullptr, 1, nullptr, 1, nullptr, 0,
                                  nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_BAD_CASE);
}

TEST(BadInput, OptionsAreChecked) {
  const auto said = [](const auto& change) {
    auto options = sized<tautline_options>();
    change(options);
    std::array<char, 1000> text{};
    tautline_option_problems(&options, text.data(), text.size());
    tautline_motion* motion = nullptr;
    const std::int32_t status = tautline_solve(ball().get(), &options, &motion);
    tautline_motion_free(motion);
    EXPECT_EQ(status, text[0] == '\0' ? TAUTLINE_OK : TAUTLINE_BAD_OPTION);
    return std::string(text.data());
  };
  EXPECT_EQ(tautline_option_problems(nullptr, nullptr, 0), 0U);
  EXPECT_EQ(said([](auto&) {}), "");
  EXPECT_EQ(said([](auto& o) { o.law = 4; }), "law 4 is unknown: must be 0 to 3");
  EXPECT_EQ(said([](auto& o) {
              o.law = -1;
              o.completion_error = nan;
              o.max_events = -3;
            }),
            "law -1 is unknown: must be 0 to 3\n"
            "completion_error nan must be 0, for the default, to 1\n"
            "max_events -3 must be above 0, or 0 for the default");
  EXPECT_EQ(said([](auto& o) { o.completion_speed = -1.0; }),
            "completion_speed -1 must be 0, for the default, to 1e+20");
  EXPECT_EQ(said([](auto& o) { o.max_events = std::numeric_limits<int>::max(); }), "");
}

TEST(BadInput, TimesOutsideTheMotionAreNamed) {
  const OwnedCase good = ball();
  const OwnedMotion motion = solved(good);
  for (const double bad : {-1e-300, nan, 10.000000000000002, infinity, -infinity}) {
    const std::array<double, 3> times = {0.0, 10.0, bad};
    std::array<double, 18> to{};
    std::size_t wrong = 9;
    EXPECT_EQ(tautline_states(motion.get(), times.data(), 3, to.data(), nullptr, &wrong),
              TAUTLINE_BAD_TIME);
    EXPECT_EQ(wrong, 2U);
    EXPECT_EQ(to, (std::array<double, 18>{}));  // nothing is written
    EXPECT_EQ(tautline_tensions(motion.get(), times.data(), 3, to.data(), nullptr),
              TAUTLINE_BAD_TIME);
    EXPECT_EQ(tautline_energy(motion.get(), times.data(), 3, to.data(), nullptr, nullptr, nullptr),
              TAUTLINE_BAD_TIME);
    EXPECT_EQ(tautline_state_errors(motion.get(), times.data(), 3, to.data(), nullptr, nullptr),
              TAUTLINE_BAD_TIME);
  }
  const std::array<double, 2> times = {1.0, nan};
  const tautline_case* one = good.get();
  std::size_t wrong = 9;
  EXPECT_EQ(tautline_sweep(&one, 1, nullptr, 1, times.data(), 2, nullptr, nullptr, nullptr, &wrong),
            TAUTLINE_BAD_TIME);
  EXPECT_EQ(wrong, 1U);
}

TEST(BadInput, RowsThatAreNotThereAreRefused) {
  const OwnedCase good = ball();
  const OwnedMotion motion = solved(good);
  auto summary = sized<tautline_summary>();
  ASSERT_EQ(tautline_summarise(motion.get(), &summary), TAUTLINE_OK);
  const auto rows = static_cast<std::size_t>(summary.events);
  const auto asked = [&](std::size_t first, std::size_t count) {
    return tautline_events(motion.get(), first, count, nullptr, nullptr, nullptr, nullptr, nullptr,
                           nullptr);
  };
  EXPECT_EQ(asked(0, rows), TAUTLINE_OK);
  EXPECT_EQ(asked(rows, 0), TAUTLINE_OK);
  EXPECT_EQ(asked(rows, 1), TAUTLINE_BAD_RANGE);
  EXPECT_EQ(asked(0, rows + 1), TAUTLINE_BAD_RANGE);
  EXPECT_EQ(asked(huge, huge), TAUTLINE_BAD_RANGE);
  EXPECT_EQ(asked(1, huge), TAUTLINE_BAD_RANGE);
  const double time = 0.0;
  EXPECT_EQ(tautline_states(motion.get(), &time, huge, nullptr, nullptr, nullptr),
            TAUTLINE_BAD_RANGE);
  EXPECT_EQ(tautline_gaps(good.get(), &time, huge / 8, nullptr, nullptr), TAUTLINE_BAD_RANGE);
  const tautline_case* one = good.get();
  EXPECT_EQ(tautline_sweep(&one, huge, nullptr, 1, nullptr, 0, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_BAD_RANGE);
  EXPECT_EQ(tautline_sweep(&one, 1, nullptr, 1, &time, huge, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_BAD_RANGE);
  EXPECT_EQ(tautline_sweep_varied(one, nullptr, 0, nullptr, huge, nullptr, 1, nullptr, 0, nullptr,
                                  nullptr, nullptr, nullptr),
            TAUTLINE_BAD_RANGE);
  EXPECT_EQ(tautline_sweep(&one, 1, nullptr, -1, nullptr, 0, nullptr, nullptr, nullptr, nullptr),
            TAUTLINE_BAD_THREADS);
  EXPECT_EQ(tautline_sweep(&one, 1, nullptr, std::numeric_limits<int>::max(), nullptr, 0, nullptr,
                           nullptr, nullptr, nullptr),
            TAUTLINE_OK);
}

TEST(BadInput, NamesOfNoNumberAreNamed) {
  const OwnedCase good = ball();
  const std::array<double, 2> values = {0.5, 0.5};
  for (const char* bad : {"lenght", "", "length_1", "restitution_", "velocity", "\xff"}) {
    const std::array<const char*, 2> names = {"restitution", bad};
    std::size_t wrong = 9;
    tautline_case* varied = nullptr;
    EXPECT_EQ(tautline_case_vary(good.get(), names.data(), values.data(), 2, &varied, &wrong),
              TAUTLINE_UNKNOWN_NAME)
        << bad;
    EXPECT_EQ(wrong, 1U);
    EXPECT_EQ(varied, nullptr);
    EXPECT_EQ(tautline_sweep_varied(good.get(), names.data(), 2, values.data(), 1, nullptr, 1,
                                    nullptr, 0, nullptr, nullptr, nullptr, nullptr),
              TAUTLINE_UNKNOWN_NAME);
  }
  const std::array<const char*, 2> names = {"x", nullptr};
  tautline_case* varied = nullptr;
  EXPECT_EQ(tautline_case_vary(good.get(), names.data(), values.data(), 2, &varied, nullptr),
            TAUTLINE_NULL);
}

TEST(BadInput, CablesThatStartTautMoveTheStart) {
  auto numbers = sized<tautline_planar_case>();
  numbers.mass = numbers.inertia = numbers.duration = 1.0;
  numbers.gravity[1] = -1.0;
  numbers.start[1] = -0.9995;
  auto cable = sized<tautline_cable>();
  cable.length = 1.0;
  cable.taut = 1;
  const OwnedCase made(tautline_case_from_numbers(&numbers, &cable, 1, nullptr, 0, nullptr));
  ASSERT_EQ(problems_of(made), "");
  std::array<char, 200> notes{};
  EXPECT_GT(tautline_notes(made.get(), notes.data(), notes.size()), 0U);
  EXPECT_STREQ(notes.data(), "cable 0 starts taut: the start changes its position by 0.0005 m");
  const double time = 0.0;
  std::array<double, 6> state{};
  std::int32_t taut = 0;
  ASSERT_EQ(tautline_states(solved(made).get(), &time, 1, state.data(), &taut, nullptr),
            TAUTLINE_OK);
  EXPECT_EQ(taut, 1);
  EXPECT_EQ(state[1], -1.0);
}

}  // namespace
}  // namespace tautline::c::test
