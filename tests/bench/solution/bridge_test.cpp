// The bridge from elastic cables to inextensible ones: what is between them, by the stiffness.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/tools/bridge/bridge.hpp"
#include "tautline/case_text.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

/// The standard case with this restitution.
Case standard_with(double restitution) {
  std::vector<Case> all = shipped_cases();
  Case& found = *std::find_if(all.begin(), all.end(),
                              [](const Case& one) { return one.name == "breakwater/1910121100"; });
  for (Cable& cable : found.cables) {
    cable.restitution = restitution;
  }
  return found;
}

Bridge bridge_in(const BridgeReading& reading) {
  EXPECT_EQ(reading.problem, "");
  return reading.bridge.value_or(Bridge());
}

/// Numbers of two digits are right to half a unit of the second.
constexpr double of_two_digits = 0.05;

/// What another solver of both motions found of the standard case, in two digits: how late impacts
/// 2 and 5 are, and by how much exit speed over entry speed differs from the restitution.
struct Published {
  double restitution;
  double stiffness;          // [N/m]
  double second;             // [s]
  double fifth;              // [s]
  double restitution_error;  // [-], the largest; 0: not published
};
constexpr Published published[] = {
    {.9, 1e4, 5.7e-3, 1.7e-2, 1.7e-2}, {.9, 1e6, 5.8e-4, 1.4e-3, 1.5e-3},
    {.9, 1e8, 5.8e-5, 1.4e-4, 1.5e-4}, {.9, 1e10, 5.8e-6, 1.4e-5, 1.5e-5},
    {.7, 1e4, 6.1e-3, 1.5e-1, 0.0},    {.7, 1e6, 6.2e-4, 1.4e-2, 0.0},
    {.7, 1e8, 6.2e-5, 1.4e-3, 0.0},    {.7, 1e10, 6.2e-6, 1.4e-4, 0.0}};

TEST(Bridge, HasTheShiftsOfAnotherSolver) {
  for (const double restitution : {.9, .7}) {
    const Bridge bridge = bridge_in(bridge_of(standard_with(restitution), {1e4, 1e10, 5}));
    ASSERT_EQ(bridge.impacts.size(), 5U) << bridge.why;
    for (const Published& one : published) {
      if (one.restitution != restitution) {  // the same number, not a computed one
        continue;
      }
      const auto row =
          std::find_if(bridge.rows.begin(), bridge.rows.end(), [&](const BridgeRow& found) {
            return std::abs(found.stiffness / one.stiffness - 1.0) < 1e-9;
          });
      ASSERT_NE(row, bridge.rows.end()) << one.stiffness;
      EXPECT_NEAR(std::abs(row->contacts[1].shift), one.second, of_two_digits * one.second);
      EXPECT_NEAR(std::abs(row->contacts[4].shift), one.fifth, of_two_digits * one.fifth);
      if (one.restitution_error > 0.0) {
        EXPECT_NEAR(row->restitution_error, one.restitution_error,
                    of_two_digits * one.restitution_error);
      }
    }
  }
}

/// Of a case in the plane, of several bodies, of moving ends, and of space.
TEST(Bridge, FallsWithTheRootOfTheStiffness) {
  const std::vector<AnyCase> cases = {standard_with(.9),
                                      standard_with(1.0),
                                      bouncing_ball(),
                                      test::named(shipped_systems(), "breakwater-and-ball"),
                                      test::named(shipped_systems(), "breakwater-shaken"),
                                      test::named(shipped_spatial_systems(), "tethered-ball")};
  for (const AnyCase& any : cases) {
    const Bridge bridge = bridge_in(bridge_of(any, {}));
    ASSERT_GE(bridge.rows.size(), 5U) << name_of(any);
    ASSERT_TRUE(bridge.deviation_slope && bridge.shift_slope);
    EXPECT_NEAR(*bridge.deviation_slope, expected_slope, slope_tolerance) << name_of(any);
    EXPECT_NEAR(*bridge.shift_slope, expected_slope, slope_tolerance) << name_of(any);
    // the first contact begins with the impact, and every later one at another instant
    EXPECT_NEAR(bridge.rows.back().contacts.front().shift, 0.0, 1e-12) << name_of(any);
    EXPECT_NE(bridge.rows.back().contacts.back().shift, 0.0) << name_of(any);
  }
}

/// A ball that falls from rest: the first contact is the closed form of a damped oscillator under a
/// load, in 20 digits (docs/snap.md, "Under a load", with v = 1 m/s).
TEST(Bridge, HasTheRestitutionOfAContactUnderALoad) {
  const SystemReading reading = read_system_text(
      "name = \"drop\"\nduration = 0.3\ngravity = [0.0, -9.81]\n[[bodies]]\nmass = 1.0\n"
      "position = [0.0, -1.0]\nvelocity = [0.0, -1.0]\n[[cables]]\nfrom = { body = \"body\" }\n"
      "to = [0.0, 0.0]\nlength = 1.0\nrestitution = 0.74407939772177968881\n",
      "drop.toml");
  ASSERT_TRUE(reading.system);
  const Bridge bridge = bridge_in(bridge_of(*reading.system, {1e4, 1e5, 1}));
  ASSERT_EQ(bridge.impacts.size(), 1U) << bridge.why;
  EXPECT_NEAR(bridge.cables.front().damping_ratio, 0.1, 1e-14);
  // rounding of a length is eps L against a stretch of v / w = L / 100
  EXPECT_NEAR(bridge.rows.front().contacts.front().restitution_error,
              .7263610024201973040 - .74407939772177968881, 1e-13);
}

TEST(Bridge, ComparesTheImpactsThatKeepTheirOrder) {
  const Bridge soft = bridge_in(bridge_of(standard_with(.9), {1e3, 1e8, 8}));
  EXPECT_EQ(soft.impacts.size(), 2U);
  EXPECT_EQ(soft.why,
            "with 1000 N/m no whole contact of one cable comes in the place of impact 3; a larger "
            "stiffness has more of them");
  const Bridge stiff = bridge_in(bridge_of(standard_with(.9), {1e6, 1e8, 8}));
  EXPECT_EQ(stiff.impacts.size(), 8U);
  EXPECT_EQ(stiff.why, "");
  const Bridge fewer = bridge_in(bridge_of(standard_with(.9), {1e6, 1e8, 1}));
  ASSERT_EQ(fewer.impacts.size(), 1U);
  EXPECT_GT(fewer.until, fewer.impacts.front().time);
  EXPECT_LT(fewer.until, stiff.impacts[1].time);
}

TEST(Bridge, SaysWhyThereIsNone) {
  const auto problem = [](const AnyCase& any, const BridgeOptions& options = {}) {
    const BridgeReading reading = bridge_of(any, options);
    EXPECT_FALSE(reading.bridge);
    return reading.problem;
  };
  System elastic = as_system(standard_with(.9));
  elastic.cables[1].elasticity.emplace().stiffness = {1e4};
  EXPECT_EQ(problem(elastic).find("cable 1 is elastic already; "), 0U) << problem(elastic);
  Case by_speed = standard_with(.9);
  by_speed.cables[0].restitution_table = {{0.1, 0.9}, {1.0, 0.5}};
  EXPECT_EQ(problem(by_speed),
            "cable 0 has a restitution that depends on the speed, to which no one damping ratio "
            "belongs");
  Case short_one = standard_with(.9);
  short_one.duration = 0.01;
  EXPECT_EQ(problem(short_one), "there is no impact to compare: nothing happens until t = 0.01");
  Case both = standard_with(.9);
  for (const Case& one : shipped_cases()) {
    both = one.name == "level-beam" ? one : both;
  }
  EXPECT_NE(problem(both).find("several cables take part in an impact"), std::string::npos);
}

TEST(Bridge, SaysOfEachDifferenceWhetherItHasAnExponent) {
  const auto ends_with = [](const Bridge& bridge, const std::string& words) {
    const std::string text = bridge_text(bridge, unlimited);
    EXPECT_TRUE(text.ends_with(words + "\n")) << words << "\nis not the end of\n" << text;
  };
  Bridge alone = bridge_in(bridge_of(standard_with(.9), {1e6, 1e8, 1}));
  EXPECT_FALSE(alone.shift_slope) << "of rounding";
  ASSERT_TRUE(alone.deviation_slope);
  alone.deviation_slope = -0.5;
  ends_with(
      alone,
      "The deviation falls with k^-0.500. The shift has no exponent: the first contact begins "
      "with its impact. For large k the deviation falls with k^-0.5.");
  alone.deviation_slope.reset();
  ends_with(alone,
            "The deviation has no exponent: at a stiffness it is 0. The shift has no exponent: the "
            "first contact begins with its impact.");
  Bridge several = bridge_in(bridge_of(standard_with(.9), {1e6, 1e8, 2}));
  ASSERT_TRUE(several.shift_slope);
  several.deviation_slope = several.shift_slope = -0.51;
  ends_with(
      several,
      "The deviation falls with k^-0.510. The shift falls with k^-0.510. For large k both fall "
      "with k^-0.5.");
  several.deviation_slope.reset();
  several.shift_slope = -0.4;
  EXPECT_NE(
      bridge_text(several, unlimited)
          .find("The deviation has no exponent: at a stiffness it is 0. The shift falls with "
                "k^-0.400. For large k the shift falls with k^-0.5. These stiffnesses are not all"),
      std::string::npos);
}

TEST(Bridge, IsWrittenInThreeWays) {
  const Bridge bridge = bridge_in(bridge_of(standard_with(.9), {1e5, 1e7, 3}));
  const std::string text = bridge_text(bridge, unlimited);
  for (const char* const words :
       {"restitution 0.9 is a damping ratio of 0.0342652", "The first 3 impacts are compared",
        "The deviation falls with k^-0.498", "k = 1e6", "\n    1e5  "}) {
    EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
  }
  const auto read = nlohmann::json::parse(bridge_json(bridge));
  ASSERT_EQ(read.at("rows").size(), 3U);
  EXPECT_EQ(read.at("rows").at(1).at("deviation"), bridge.rows[1].deviation);
  EXPECT_EQ(read.at("rows").at(2).at("contacts").at(1).at("shift"),
            bridge.rows[2].contacts[1].shift);
  EXPECT_EQ(read.at("slopes").at("deviation"), *bridge.deviation_slope);
  const std::string page = bridge_html(bridge, page_assets());
  for (const char* const words : {"<svg", "bridge-rows", "bridge-shifts", "bridge-data"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
}

}  // namespace
}  // namespace tautline::bench
