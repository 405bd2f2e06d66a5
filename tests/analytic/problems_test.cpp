#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "support.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

/// A change that breaks the standard case, and the sentences it earns.
struct Broken {
  std::string name;
  std::function<void(Case&)> change;
  std::vector<std::string> sentences;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<Broken> broken_cases() {
  return {
      {"MassZero",
       [](Case& c) { c.body.mass = 0.0; },
       {"body: mass 0 must be a finite number above 0 [kg]"}},
      {"MassInfinite",
       [](Case& c) { c.body.mass = infinite; },
       {"body: mass inf must be a finite number above 0 [kg]"}},
      {"InertiaNegative",
       [](Case& c) { c.body.inertia = -1.0; },
       {"body: inertia -1 must be a finite number, 0 or above [kg m^2]"}},
      {"InertiaZero",
       [](Case& c) { c.body.inertia = 0.0; },
       {"body: inertia 0 is for a point mass, whose attachments are all [0, 0]; give an inertia "
        "above 0 [kg m^2]"}},
      {"NoCables", [](Case& c) { c.cables.clear(); }, {"cables: 0 given; a case has 1 to 8"}},
      {"NineCables",
       [](Case& c) { c.cables.assign(9, c.cables.front()); },
       {"cables: 9 given; a case has 1 to 8"}},
      {"AnchorNotANumber",
       [](Case& c) { c.cables[1].anchor.x() = std::nan(""); },
       {"cable 1: anchor nan is not a finite number"}},
      {"AttachmentInfinite",
       [](Case& c) { c.cables[0].attachment.y() = -infinite; },
       {"cable 0: attachment -inf is not a finite number"}},
      {"LengthNegative",
       [](Case& c) { c.cables[1].length = -1.5; },
       {"cable 1: length -1.5 must be a finite number above 0 [m]"}},
      {"RestitutionAboveOne",
       [](Case& c) { c.cables[1].restitution = 1.2; },
       {"cable 1: restitution 1.2 is outside [0, 1]"}},
      {"RestitutionNotANumber",
       [](Case& c) { c.cables[0].restitution = std::nan(""); },
       {"cable 0: restitution nan is outside [0, 1]"}},
      {"CaptureSpeedNegative",
       [](Case& c) { c.cables[1].capture_speed = -0.1; },
       {"cable 1: capture_speed -0.1 must be a finite number, 0 or above [m/s]"}},
      {"CaptureSpeedInfinite",
       [](Case& c) { c.cables[0].capture_speed = infinite; },
       {"cable 0: capture_speed inf must be a finite number, 0 or above [m/s]"}},
      {"CaptureSpeedTooLarge",
       [](Case& c) { c.cables[0].capture_speed = 1e21; },
       {"cable 0: capture_speed 1e+21 is larger in size than 1e+20"}},
      {"TableSpeedNotANumber",
       [](Case& c) {
         c.cables[1].restitution_table = {{std::nan(""), 0.5}};
       },
       {"cable 1: restitution_table[0]: speed nan must be a finite number, 0 or above [m/s]"}},
      {"TableSpeedNegative",
       [](Case& c) {
         c.cables[1].restitution_table = {{-1.0, 0.5}};
       },
       {"cable 1: restitution_table[0]: speed -1 must be a finite number, 0 or above [m/s]"}},
      {"TableSpeedsNotRising",
       [](Case& c) {
         c.cables[0].restitution_table = {{0.0, 0.9}, {2.0, 0.5}, {2.0, 0.4}};
       },
       {"cable 0: restitution_table[2]: speed 2 must be above the one before, 2 [m/s]"}},
      {"TableRestitutionAboveOne",
       [](Case& c) {
         c.cables[0].restitution_table = {{0.0, 0.9}, {2.0, 1.5}};
       },
       {"cable 0: restitution_table[1]: restitution 1.5 is outside [0, 1]"}},
      {"GravityInfinite",
       [](Case& c) { c.gravity.y() = infinite; },
       {"gravity inf is not a finite number"}},
      {"PositionNotANumber",
       [](Case& c) { c.initial.position.x() = std::nan(""); },
       {"initial: position nan is not a finite number"}},
      {"AngleInfinite",
       [](Case& c) { c.initial.angle = infinite; },
       {"initial: angle inf is not a finite number"}},
      {"VelocityInfinite",
       [](Case& c) { c.initial.velocity.y() = infinite; },
       {"initial: velocity inf is not a finite number"}},
      {"SpinInfinite",
       [](Case& c) { c.initial.spin = infinite; },
       {"initial: spin inf is not a finite number"}},
      {"DurationZero",
       [](Case& c) { c.duration = 0.0; },
       {"duration 0 must be a finite number above 0 [s]"}},
      {"AngleLimitZero",
       [](Case& c) { c.angle_limit = 0.0; },
       {"angle_limit 0 must be a finite number above 0 [rad]"}},
      {"AngleBeyondItsLimit",
       [](Case& c) {
         c.angle_limit = 1.0;
         c.initial.angle = -1.5;
       },
       {"initial: angle -1.5 is beyond angle_limit 1"}},
      {"CeilingBelowTheStart",
       [](Case& c) { c.ceiling = 0.0; },
       {"cable 0: attachment starts at height 0.1, above ceiling 0",
        "cable 1: attachment starts at height 0.1, above ceiling 0"}},
      {"Overstretched",
       [](Case& c) { c.initial.position = Vec2(0.0, -1.3); },
       {"cable 0: overstretched at the start by 1.1570660511172846 m: its ends are "
        "2.6570660511172846 m apart, its length is 1.5 m; a length of 2.6570660511172846 m would "
        "do",
        "cable 1: overstretched at the start by 1.1570660511172846 m: its ends are "
        "2.6570660511172846 m apart, its length is 1.5 m; a length of 2.6570660511172846 m would "
        "do"}},
      {"ShorterThanItsCoordinatesAreRounded",
       [](Case& c) {
         c.cables.resize(1);
         c.cables[0].anchor = c.initial.position = Vec2(-1e20, -1e20);
         c.cables[0].attachment = Vec2(0.0, 0.0);
         c.cables[0].length = 1e-60;
       },
       {"cable 0: length 1e-60 m is less than the rounding of its ends' coordinates, "
        "31401.849173675502 m: nothing says which way it pulls"}},
      {"CannotReach",
       [](Case& c) { c.cables[0].length = c.cables[1].length = 0.5; },
       {"cables 0 and 1 cannot reach: their anchors are 2 m apart, lengths and body span only 1.2 "
        "m; the body cannot float"}},
      {"VelocityTooLarge",
       [](Case& c) { c.initial.velocity.x() = 1e200; },
       {"initial: velocity 1e+200 is larger in size than 1e+20"}},
      {"GravityTooLarge",
       [](Case& c) { c.gravity.y() = -1e300; },
       {"gravity -1e+300 is larger in size than 1e+20"}},
      {"DurationTooLarge",
       [](Case& c) { c.duration = 1.5e20; },
       {"duration 1.5e+20 is larger in size than 1e+20"}},
      {"CeilingTooLarge",
       [](Case& c) { c.ceiling = 1e21; },
       {"ceiling 1e+21 is larger in size than 1e+20"}},
      {"LengthTooLarge",
       [](Case& c) { c.cables[1].length = 1e21; },
       {"cable 1: length 1e+21 is larger in size than 1e+20"}},
      {"MassTooSmall",
       [](Case& c) { c.body.mass = 1e-308; },
       {"body: mass 1e-308 is smaller than 1e-60"}},
      {"InertiaTooSmall",
       [](Case& c) { c.body.inertia = 1e-61; },
       {"body: inertia 1e-61 is smaller than 1e-60"}},
      {"SeveralAtOnce",
       [](Case& c) {
         c.body.mass = -1.0;
         c.cables[0].restitution = -0.5;
         c.duration = -2.0;
       },
       {"body: mass -1 must be a finite number above 0 [kg]",
        "cable 0: restitution -0.5 is outside [0, 1]",
        "duration -2 must be a finite number above 0 [s]"}},
  };
}

class Problems : public ::testing::TestWithParam<Broken> {};

TEST_P(Problems, AreNamedInFullSentences) {
  Case the_case = table_case("1910121100");
  GetParam().change(the_case);
  EXPECT_EQ(problems(the_case), GetParam().sentences);
}

TEST_P(Problems, StopSolveWithTheFirstOfThem) {
  Case the_case = table_case("1910121100");
  GetParam().change(the_case);
  try {
    (void)solve(the_case);
    FAIL() << "solve accepted the case";
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), GetParam().sentences.front());
  }
}

INSTANTIATE_TEST_SUITE_P(Broken, Problems, ::testing::ValuesIn(broken_cases()),
                         [](const auto& param) { return param.param.name; });

TEST(NoProblems, InAnyShippedCase) {
  for (const Case& the_case : shipped_cases()) {
    EXPECT_TRUE(problems(the_case).empty()) << the_case.name << ": " << problems(the_case).front();
  }
}

TEST(NoProblems, WhereAGapIsNegativeByRounding) {
  Case ball = bouncing_ball();
  ball.initial.position.y() = -1e-13;
  EXPECT_TRUE(problems(ball).empty());
  ball.initial.position.y() = -1e-11;
  EXPECT_EQ(problems(ball).size(), 1U);
}

TEST(Breakwater, ThatCannotFloatIsRefused) {
  Breakwater p;
  p.r = 0.9;  // exactly 1 - a: the cables would have to be level
  try {
    (void)breakwater(p, "short");
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("the body cannot float"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace tautline::test
