#include "bench/cases/title.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// The title of the row `number` of Table 5.1.
std::string title_of_row(std::string_view number) {
  for (const auto& [row, parameters] : table_5_1()) {
    if (row == number) {
      return title_of(breakwater(parameters, "any"));
    }
  }
  return "no such row";
}

TEST(Title, NamesRestitutionBodyAndCables) {
  EXPECT_EQ(title_of_row("1910121100"), "e = 0.9, ring of radius 0.1, two cables of 1.5");
  EXPECT_EQ(title_of_row("2921121100"), "e = 0.9, box 0.4 x 0.2, two cables of 2.5");
  EXPECT_EQ(title_of_row("1110121100"), "e = 1, ring of radius 0.1, two cables of 1.5");
  EXPECT_EQ(title_of_row("1900461100"), "e = 0.9, point mass, two cables of 1.5");
  EXPECT_EQ(title_of(bouncing_ball(0.25)), "e = 0.25, body hung at its centre, one cable of 2");
}

TEST(Title, NamesAStartThatIsTurnedOrSpins) {
  EXPECT_EQ(title_of_row("19101211050"),
            "e = 0.9, ring of radius 0.1, two cables of 1.5, turned by 0.05");
  EXPECT_EQ(title_of_row("19101211002"),
            "e = 0.9, ring of radius 0.1, two cables of 1.5, spin 0.02");
}

TEST(Title, TellsAllShippedCasesApart) {
  std::map<std::string, std::string> names;
  for (const Case& the_case : shipped_cases()) {
    const auto [other, added] = names.emplace(title_of(the_case), the_case.name);
    EXPECT_TRUE(added) << the_case.name << " and " << other->second << ": " << other->first;
  }
}

TEST(Title, NamesNoShapeThatTheInertiaDoesNotHave) {
  Case the_case = breakwater(Breakwater{}, "any");
  the_case.body.inertia *= 1.001;
  EXPECT_EQ(title_of(the_case), "e = 0.9, two cables of 1.5");
  the_case = breakwater(Breakwater{.b = 0.1, .shape = Shape::box}, "any");
  the_case.body.mass *= 2.0;
  EXPECT_EQ(title_of(the_case), "e = 0.9, two cables of 1.5");
  the_case.body.inertia *= 2.0;
  EXPECT_EQ(title_of(the_case), "e = 0.9, box 0.2 x 0.2, two cables of 1.5");
}

TEST(Title, GivesTheRangeOfCablesThatDiffer) {
  Case the_case = breakwater(Breakwater{}, "any");
  the_case.cables[0].length = 1.25;
  the_case.cables[1].restitution = 0.5;
  EXPECT_EQ(title_of(the_case), "e = 0.5 to 0.9, ring of radius 0.1, two cables of 1.25 to 1.5");
  the_case.cables[0].capture_speed = 0.01;
  EXPECT_TRUE(title_of(the_case).starts_with("e by speed, ")) << title_of(the_case);
}

TEST(Title, NamesGravityThatDoesNotPointDown) {
  Case the_case = bouncing_ball();
  const std::string down = title_of(the_case);
  the_case.gravity = Vec2(std::sin(0.25), -std::cos(0.25));
  EXPECT_EQ(title_of(the_case), down + ", gravity tilted by 0.25");
  the_case.gravity = Vec2(0.0, 3.0);
  EXPECT_EQ(title_of(the_case), down + ", gravity upward");
  the_case.gravity = Vec2::Zero();
  EXPECT_EQ(title_of(the_case), down + ", no gravity");
}

}  // namespace
}  // namespace tautline::bench
