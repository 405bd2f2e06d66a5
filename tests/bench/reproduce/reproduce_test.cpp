#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "bench/tools/reproduce/source.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/reproduce/reproduced.hpp"

namespace tautline::test {
namespace {

using bench::test::names_in;
using nlohmann::json;

using Reproduce = Reproduced;

TEST_F(Reproduce, WritesEveryFileThatItNames) {
  EXPECT_EQ(chapter().at("schema"), 1);
  EXPECT_EQ(chapter().at("tables").size(), 3U);
  EXPECT_EQ(chapter().at("figures").size(), 15U);
  const std::string markdown = content_of(out() / "chapter.md");
  for (const char* list : {"tables", "figures"}) {
    for (const json& one : chapter().at(list)) {
      const std::string file = one.at("file");
      EXPECT_TRUE(std::filesystem::exists(out() / "chapter" / file)) << file;
      EXPECT_NE(markdown.find(file), std::string::npos) << file;
    }
  }
  for (int number = 6; number <= 20; ++number) {
    const std::string name = "5." + std::to_string(number);
    EXPECT_EQ(entry("figures", "name", name).at("columns").get<std::vector<std::string>>(),
              data(name).headings)
        << name;
  }
}

TEST_F(Reproduce, Table51HasTheParametersOfTheShippedCases) {
  const json& table = entry("tables", "name", "Table 5.1");
  EXPECT_EQ(table.at("rows").size(), 28U);
  std::map<std::string, TableRow> shipped;
  for (const TableRow& row : table_5_1()) {
    shipped.emplace(row.number, row);
  }
  std::map<std::string, int> seen;
  for (const json& row : table.at("rows")) {
    const std::string number = row.at(1);
    ++seen[number];
    ASSERT_TRUE(shipped.contains(number)) << number;
    const Breakwater& p = shipped.at(number).parameters;
    const State& start = p.initial;
    const std::array<double, 10> expected = {p.r,
                                             p.e,
                                             p.a,
                                             p.b,
                                             start.position.x(),
                                             start.velocity.x(),
                                             start.position.y(),
                                             start.velocity.y(),
                                             start.angle,
                                             start.spin};
    const std::array<std::size_t, 10> columns = {2, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    for (std::size_t index = 0; index < columns.size(); ++index) {
      const std::string printed = row.at(columns[index]);
      EXPECT_EQ(bench::printed_value(printed), expected[index]) << number << ": " << printed;
    }
    EXPECT_NEAR(bench::printed_value(row.at(3).get<std::string>()),
                std::sqrt(p.r * p.r - (1.0 - p.a) * (1.0 - p.a)), 0.5e-3)
        << number << ": h";
  }
  EXPECT_EQ(seen.size(), 21U);
}

TEST_F(Reproduce, Table51SaysHowEachCaseEnds) {
  for (const json& row : entry("tables", "name", "Table 5.1").at("rows")) {
    const std::string number = row.at(1);
    const char* const expected = number == "1110121100"   ? "bounces on"
                                 : number == "1900461100" ? "rest"
                                                          : "swing";
    EXPECT_EQ(cell("Table 5.1", {row.at(0), number}, "outcome"), expected) << number;
  }
  // solved with 60 digits by an independent program, written before this one
  const double printed = 0.5e-8;
  EXPECT_NEAR(cell("Table 5.1", {"r", "1910121100"}, "swing energy").get<double>(), 0.01967914,
              printed);
  EXPECT_NEAR(cell("Table 5.1", {"r", "2911121100"}, "swing energy").get<double>(), 0.007799975,
              printed);
  const double uncertain = 1e-4;  // of a limit time, completed at bounces of 1e-5 or so
  EXPECT_NEAR(cell("Table 5.1", {"r", "1910121100"}, "lock").get<double>(), 8.128808, uncertain);
  EXPECT_NEAR(cell("Table 5.1", {"point mass", "1900461100"}, "lock").get<double>(), 29.2015,
              uncertain);
}

TEST_F(Reproduce, Table52IsRightToItsLastDigit) {
  for (const json& row : entry("tables", "name", "Table 5.2").at("rows")) {
    const double exact = row.at(4);
    EXPECT_NEAR(bench::printed_value(row.at(3).get<std::string>()), exact, 0.5e-3) << row;
    const double a = bench::printed_value(row.at(1).get<std::string>());
    const double b = bench::printed_value(row.at(2).get<std::string>());
    // Eqs. 5.5 and 5.6
    EXPECT_NEAR(exact, row.at(0) == "circle" ? a * a : (a * a + b * b) / 3.0, 1e-16) << row;
  }
}

TEST_F(Reproduce, Table53IsOffWhereTheChapterLostDigits) {
  const auto error = [](const char* instant, const char* quantity) {
    return cell("Table 5.3", {instant, quantity}, "error").get<double>();
  };
  EXPECT_NEAR(cell("Table 5.3", {"1st impact -", "t"}, "exact").get<double>(), 0.1548752355, 5e-11);
  EXPECT_NEAR(error("t = 15", "vx"), -1.03e-5, 5e-8);
  EXPECT_NEAR(error("t = 15", "vy"), -3.34e-6, 5e-9);
  for (const char* quantity : {"t", "x", "vx", "y", "vy"}) {
    EXPECT_LE(std::abs(error("1st impact -", quantity)), 0.5e-6) << quantity;
    EXPECT_LE(std::abs(error("1st impact +", quantity)), 0.5e-6) << quantity;
  }
  // the printed state at "the last impact" is another motion's by then
  EXPECT_GT(std::abs(error("last impact -", "vx")), 0.1);
  // g1 is that of the step's end, not of the impact: (1 - x)^2 + (h - y)^2 - r^2
  const double h = std::sqrt(1.25);
  const auto g1 = [h](double x, double y) {
    return (1.0 - x) * (1.0 - x) + (h - y) * (h - y) - 2.25;
  };
  EXPECT_NEAR(error("1st impact -", "g1"), -1.974424 - g1(0.492925, 0.972519), 2e-6);
  EXPECT_NEAR(-1.974424, g1(0.4 + 0.6 * 0.16, 1.0 - 0.1 * 0.16 - 0.16 * 0.16 / 2.0), 0.5e-6);
}

TEST_F(Reproduce, MotionsAreFiniteRiseAndShowBothSidesOfEachImpact) {
  for (const json& figure : chapter().at("figures")) {
    const Csv csv = data(figure.at("name"));
    ASSERT_GT(csv.rows.size(), 10U) << figure.at("name");
    const bool motion = csv.headings.back() == "kind";
    double time = 0.0;
    std::size_t impacts = 0;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
      ASSERT_EQ(csv.rows[row].size(), csv.headings.size()) << figure.at("name") << " row " << row;
      const std::size_t numbers = csv.headings.size() - (motion ? 2 : 0);
      for (std::size_t column = 0; column < numbers; ++column) {
        ASSERT_TRUE(std::isfinite(std::stod(csv.rows[row][column])));
      }
      const double now = csv.number(row, "t [sqrt(S/g)]");
      ASSERT_GE(now, time) << figure.at("name") << " row " << row;
      time = now;
      if (motion && csv.rows[row][csv.column("event")] == "before") {
        const auto& after = csv.rows.at(row + 1);
        ASSERT_EQ(after[csv.column("event")], "after");
        ASSERT_EQ(after.front(), csv.rows[row].front()) << "one instant";
        // completing an accumulation takes back its last bounces, v^2 / (2 c) high for v < 1e-5
        const bool impact = csv.rows[row].back() == "impact";
        ASSERT_NEAR(csv.number(row + 1, "x [S]"), csv.number(row, "x [S]"), impact ? 0.0 : 1e-9)
            << figure.at("name") << " row " << row << ": the body does not jump";
        impacts += impact ? 1U : 0U;
      }
    }
    EXPECT_EQ(impacts > 0, motion) << figure.at("name");
  }
}

TEST_F(Reproduce, ImpactSpeedsFollowTheLawAndEndWithTheRightEnergy) {
  // e, and what is left of 0.125: solved with 60 digits by an independent program
  const std::map<std::string, std::array<double, 2>> expected = {{"5.15", {1.0, 0.125}},
                                                                 {"5.16", {0.9, 0.019679140}},
                                                                 {"5.17", {0.7, 0.024357762}},
                                                                 {"5.18", {0.5, 0.030367409}}};
  for (const auto& [figure, numbers] : expected) {
    const auto [e, left] = numbers;
    const Csv csv = data(figure);
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
      const double before = csv.number(row, "vn before [sqrt(gS)]");
      const double after = csv.number(row, "vn after [sqrt(gS)]");
      ASSERT_GT(before, 0.0);
      ASSERT_NEAR(after, -e * before, 1e-11) << figure << " row " << row;  // twelve digits
      const double loss =
          csv.number(row, "energy before [mgS]") - csv.number(row, "energy after [mgS]");
      ASSERT_GE(loss, -1e-12) << figure << " row " << row;
    }
    EXPECT_NEAR(csv.number(csv.rows.size() - 1, "energy after [mgS]"), left, 1e-8) << figure;
  }
}

TEST_F(Reproduce, BoundariesAreWhereTheCablesAreTaut) {
  const Case the_case = breakwater(table_5_1().front().parameters, "standard");
  const Csv csv(out() / "chapter/figure_5_06_boundary.csv");
  ASSERT_GT(csv.rows.size(), 100U);
  for (std::size_t row = 0; row < csv.rows.size(); ++row) {
    State state;
    state.position = {csv.number(row, "x [S]"), csv.number(row, "y on g1 = 0 [S]")};
    // a digit of y moves the gap by less, twelve are written
    EXPECT_NEAR(gap(the_case.cables[1], state), 0.0, 1e-11) << row;
    state.position.y() = csv.number(row, "y on g2 = 0 [S]");
    EXPECT_NEAR(gap(the_case.cables[0], state), 0.0, 1e-11) << row;
  }
}

TEST_F(Reproduce, ThePointMassIsTheBodyWithoutLeverArms) {
  EXPECT_EQ(content_of(out() / "chapter/figure_5_19.csv"),
            content_of(out() / "chapter/figure_5_20.csv"));
  const json& numbers = entry("corrections", "where", "Sections 5.1 and 5.8.2").at("numbers");
  const double point = numbers.at("point_mass");
  const json& smallest = numbers.at("bodies").back();
  EXPECT_NEAR(smallest.at("inertia_1").get<double>(), point, 1e-4);
  EXPECT_GT(std::abs(smallest.at("ring").get<double>() - point), 0.1);
}

TEST_F(Reproduce, CorrectionsAreShownByNumbers) {
  const auto numbers = [](const char* where) -> const json& {
    return entry("corrections", "where", where).at("numbers");
  };
  const json& slope = numbers("Eq. 5.66");
  EXPECT_GT(slope.at("poses").get<int>(), 9000);
  EXPECT_EQ(slope.at("wrong"), slope.at("poses"));
  const json& spin = numbers("Section 5.5.2");
  // an independent draw kept the sign in 5801 of 9983; three standard deviations of each are 3 %
  EXPECT_NEAR(spin.at("kept").get<double>() / spin.at("impacts").get<double>(), 0.58, 0.03);
  const json& time = numbers("Eq. 5.24");
  EXPECT_NEAR(time.at("ratio").get<double>(), std::sqrt(10.0 / 9.81), 1e-12);
  EXPECT_NEAR(numbers("Section 5.8.1, e = 1").at("time").get<double>(), 10.42331, 0.5e-5);
  const json& law = numbers("Section 5.5");
  EXPECT_NEAR(law.at("sequential_lock").get<double>(), 1.469766, 2e-5);
  EXPECT_NEAR(law.at("sequential_energy").get<double>(), 0.030455507, 1e-9);
  EXPECT_NEAR(law.at("lock").get<double>(), 1.532917, 2e-5);
  const json& start = numbers("Table 5.1");
  EXPECT_EQ(start.at("cases"), 21);
  EXPECT_EQ(start.at("case"), "19101211150");
  EXPECT_NEAR(start.at("largest_g").get<double>(), -0.0047, 0.5e-4);
}

TEST_F(Reproduce, ASecondRunWritesTheSameBytes) {
  const TemporaryFolder folder;
  const Outcome outcome = program({"reproduce", "--out", folder.path().string(), "--json", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, content_of(out() / "chapter.json"));
  for (const char* file : {"chapter.md", "chapter.html", "chapter.json"}) {
    EXPECT_EQ(content_of(folder.path() / file), content_of(out() / file)) << file;
  }
  const auto names = names_in(out() / "chapter");
  EXPECT_EQ(names_in(folder.path() / "chapter"), names);
  for (const std::string& name : names) {
    EXPECT_TRUE(content_of(folder.path() / "chapter" / name) ==
                content_of(out() / "chapter" / name))
        << name;
  }
}

TEST(ReproduceOutput, ThatCannotBeWrittenIsOneSentence) {
  const TemporaryFolder folder;
  const std::string file = folder.file("taken", "").string();
  Outcome outcome = program({"reproduce", "--out", file});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("is not a folder"), std::string::npos) << outcome.errors;
  outcome = program({"reproduce", "--out", folder.path().string()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("holds files"), std::string::npos) << outcome.errors;
  outcome = program({"reproduce", "--out", ""});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("--out: is empty"), std::string::npos) << outcome.errors;
  outcome = program({"reproduce", "--out", "/proc/nowhere"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("cannot make the folder /proc/nowhere"), std::string::npos)
      << outcome.errors;
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
}

TEST(ReproduceOutput, OnAFullDiskIsAFailureWithoutHalfAFile) {
  const TemporaryFolder folder;
  // no file may grow past 16 kB: the first figure does
  const Outcome outcome =
      program({"reproduce", "--out", (folder.path() / "r").string()}, "ulimit -f 16;");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("cannot write"), std::string::npos) << outcome.errors;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "r/chapter.json"));
  for (const std::string& name : names_in(folder.path() / "r/chapter")) {
    EXPECT_TRUE(name.starts_with("table_")) << name << " was left";
  }
}

}  // namespace
}  // namespace tautline::test
