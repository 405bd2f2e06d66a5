#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include "support.hpp"
#include "tautline/solve.hpp"
#include "tautline/system.hpp"

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

/// A body on two cables to the world and a ball below it, on a cable through a ring.
System two_bodies() {
  System result;
  result.bodies = {{.name = "box", .mass = 2.0, .inertia = 0.1}, {.name = "ball", .mass = 1.0}};
  result.initial.bodies = {{Vec2(0.0, -1.0), 0.0, Vec2(0.0, 0.0), 0.0},
                           {Vec2(0.5, -2.0), 0.0, Vec2(0.0, 0.0), 0.0}};
  result.cables.resize(3);
  result.cables[0].from = {0, Vec2(-0.1, 0.0)};
  result.cables[0].to = {std::nullopt, Vec2(-1.0, 0.0)};
  result.cables[0].length = Function<1>::constant(2.0);
  result.cables[1].from = {std::nullopt, Vec2(1.0, 0.0)};
  result.cables[1].to = {0, Vec2(0.1, 0.0)};
  result.cables[1].length = {{{0.0, {Function<1>::Value(2.0)}}},
                             {{Function<1>::Value(0.5), 3.0, 0.25}}};
  result.cables[2].from = {0, Vec2(0.0, -0.1)};
  result.cables[2].through = {{std::nullopt, Vec2(0.5, -1.0)}};
  result.cables[2].to = {1, Vec2(0.0, 0.0)};
  result.cables[2].length =
      Function<1>::linear({0.5, 1.5}, {Function<1>::Value(3.0), Function<1>::Value(2.0)});
  result.duration = 4.0;
  return result;
}

/// A change that breaks `two_bodies`, and the sentences it earns.
struct BrokenSystem {
  std::string name;
  std::function<void(System&)> change;
  std::vector<std::string> sentences;
};

void PrintTo(const BrokenSystem& broken, std::ostream* out) { *out << broken.name; }

std::vector<BrokenSystem> broken_systems() {
  using One = Function<1>::Value;
  return {
      {"NoBody", [](System& s) { s = System(); }, {"bodies: 0 given; a system has 1 to 8"}},
      {"StateMissing",
       [](System& s) {
         s.cables.clear();
         s.initial.bodies.pop_back();
       },
       {"initial: 1 states given; must be 2, one for each body"}},
      {"LaterStart", [](System& s) { s.initial.time = 1.0; }, {"initial: time 1 must be 0 [s]"}},
      {"OneName",
       [](System& s) { s.bodies[1].name = "box"; },
       {"body 1: has the name of body 0; each body must have a name of its own"}},
      {"Mass",
       [](System& s) { s.bodies[1].mass = 0.0; },
       {"body 1: mass 0 must be a finite number above 0 [kg]"}},
      {"PointOffItsCentre",
       [](System& s) { s.bodies[0].inertia = 0.0; },
       {"body 0: inertia 0 is for a point mass, whose attachments are all [0, 0]; give an inertia "
        "above 0 [kg m^2]"}},
      {"Drag",
       [](System& s) { s.bodies[0].drag = -0.1; },
       {"body 0: drag -0.1 must be a finite number, 0 or above [N s/m]"}},
      {"SpinDragOfAPoint",
       [](System& s) { s.bodies[1].spin_drag = 0.2; },
       {"body 1: spin_drag 0.2 is for a body with an inertia, which a point mass has not; must be "
        "0 [N m s]"}},
      {"MomentOnAPoint",
       [](System& s) { s.bodies[1].moment = Function<1>::constant(1.0); },
       {"body 1: moment is for a body with an inertia, which a point mass has not; must be left "
        "out"}},
      {"Force",
       [](System& s) {
         s.bodies[0].force.waves = {{Vec2(0.0, infinite), 1.0, 0.0}};
       },
       {"body 0: force: waves[0]: amplitude inf is not a finite number"}},
      {"Frequency",
       [](System& s) { s.cables[1].length.waves[0].frequency = -3.0; },
       {"cable 1: length: waves[0]: frequency -3 must be a finite number, 0 or above [rad/s]"}},
      {"PiecesOutOfOrder",
       [](System& s) {
         s.gravity.pieces.push_back({-1.0, {Vec2(0.0, -1.0)}});
       },
       {"gravity: pieces[1]: from -1 must be above the one before, 0 [s]"}},
      {"EmptyPolynomial",
       [](System& s) {
         s.gravity.pieces.push_back({1.0, {}});
       },
       {"gravity: pieces[1]: polynomial is empty; must have at least one coefficient [m/s^2]"}},
      {"AnchorJumps",
       [](System& s) {
         s.cables[0].to.motion.pieces = {{0.0, {Vec2(0.0, 0.0)}}, {1.0, {Vec2(0.0, 0.5)}}};
       },
       {"cable 0: to: jumps by 0.5 m at 1 s; must go on from where the piece before it ends"}},
      {"LengthReachesZero",
       [](System& s) { s.cables[2].length.pieces[0].coefficients[1] = One(-3.5); },
       {"cable 2: length: jumps by 2.5 m at 1.5 s; must go on from where the piece before it "
        "ends",
        "cable 2: length -0.0625 at 1.375 s must be above 0 [m] as long "
        "as the cable acts"}},
      {"LengthBelowZeroBetween",
       [](System& s) {
         s.cables[1].length = {{{0.0, {One(2.0), One(-2.0), One(0.40625)}}}, {}};
       },
       {"cable 1: length -0.375 at 2 s must be above 0 [m] as long as the cable "
        "acts"}},
      {"NoBodyThere",
       [](System& s) { s.cables[2].to.body = 2; },
       {"cable 2: to: body 2 is not there; the system has 2"}},
      {"BodyMoves",
       [](System& s) { s.cables[0].from.motion = Function<2>::constant(Vec2(0.0, 0.0)); },
       {"cable 0: from: is a point of a body, which does not move in it; only an end in the world "
        "has a motion of its own"}},
      {"NothingHeld",
       [](System& s) { s.cables[0].from.body = std::nullopt; },
       {"cable 0: from, through and to are all in the world; one of them must be on a body"}},
      {"BodyOnItself",
       [](System& s) { s.cables[0].to.body = 0; },
       {"cable 0: from and to are both on body 0, which it cannot hold; must join two bodies, or a "
        "body with the world"}},
      {"CutBeforeHookUp",
       [](System& s) {
         s.cables[0].from_time = 2.0;
         s.cables[0].cut_at = 2.0;
       },
       {"cable 0: cut_at 2 must be above from_time 2 [s]"}},
      {"Overstretched",
       [](System& s) { s.cables[2].length = Function<1>::constant(1.0); },
       {"cable 2: overstretched at the start by 0.5099019513592786 m: its ends are "
        "1.5099019513592786 m apart through its rings, its length is 1 m; a length of "
        "1.5099019513592786 m would do"}},
      {"AtItsRing",
       [](System& s) { s.initial.bodies[1].position = Vec2(0.5, -1.0); },
       {"cable 2: its ring 0 and its end \"to\" start 0 m apart, which gives it no direction; must "
        "be at least 3e-06 m"}},
      {"CannotReach",
       [](System& s) { s.cables[0].length = s.cables[1].length = Function<1>::constant(0.85); },
       {"cables 0 and 1 cannot reach: their anchors are 2 m apart, lengths and body span only 1.9 "
        "m; the body cannot float"}},
  };
}

class SystemProblems : public ::testing::TestWithParam<BrokenSystem> {};

TEST_P(SystemProblems, AreNamedInFullSentences) {
  System system = two_bodies();
  ASSERT_EQ(problems(system), std::vector<std::string>());
  GetParam().change(system);
  EXPECT_EQ(problems(system), GetParam().sentences);
}

INSTANTIATE_TEST_SUITE_P(Broken, SystemProblems, ::testing::ValuesIn(broken_systems()),
                         [](const auto& param) { return param.param.name; });

TEST(SystemProblems, OfACableThatActsLaterOrNoLongerAreNone) {
  System system = two_bodies();
  system.cables[2].length = Function<1>::constant(1.0);  // too short for the start
  system.cables[2].from_time = 0.5;
  EXPECT_EQ(problems(system), std::vector<std::string>());
  system = two_bodies();
  system.cables[1].length = {{{0.0, {Function<1>::Value(2.0), Function<1>::Value(-1.0)}}}, {}};
  EXPECT_EQ(problems(system).size(), 1U);  // zero at 2 s
  system.cables[1].cut_at = 1.9;
  EXPECT_EQ(problems(system), std::vector<std::string>());
}

TEST(SystemProblems, FindALengthThatReachesZeroAsADenseScanDoes) {
  std::mt19937 random(5);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    System system = two_bodies();
    system.cables.resize(1);
    system.cables[0].from_time = between(0.1, 1.0);
    Function<1>& length = system.cables[0].length;
    using One = Function<1>::Value;
    const std::vector<double> times = {0.0, between(0.5, 1.5), between(2.0, 3.0), 3.9};
    length = Function<1>::spline(
        times, {One(1.0), One(between(0.1, 1.2)), One(between(0.1, 1.2)), One(1.0)});
    length.waves = {{One(between(0.0, 0.3)), between(0.0, 30.0), between(-3.0, 3.0)},
                    {One(between(0.0, 0.3)), between(0.0, 3.0), between(-3.0, 3.0)}};
    double least = infinite;
    constexpr int scanned = 20'000;
    for (int at = 0; at <= scanned; ++at) {
      const double share = static_cast<double>(at) / scanned;
      least = std::min(least, length.at(*system.cables[0].from_time * (1.0 - share) +
                                        system.duration * share)[0]);
    }
    const std::vector<std::string> sentences = problems(system);
    ASSERT_EQ(sentences.empty(), least > 0.0) << "case " << i << ": least " << least;
    found += sentences.empty() ? 0 : 1;
  }
  EXPECT_GT(found, 30);
  EXPECT_LT(found, 270);
}

TEST(SystemProblems, OfOneBodyAreThoseOfTheCase) {
  for (const Broken& broken : broken_cases()) {
    Case the_case = table_case("1910121100");
    broken.change(the_case);
    the_case.angle_limit.reset();  // which a system has not
    the_case.ceiling.reset();
    std::vector<std::string> sentences = problems(the_case);
    for (std::string& sentence : sentences) {
      for (const std::string owner : {"body: ", "initial: "}) {
        if (sentence.starts_with(owner)) {
          sentence = "body 0: " + sentence.substr(owner.size());
        }
      }
      if (sentence.starts_with("cables: 9")) {
        sentence = "cables: 9 given; a system has 0 to 8";
      }
      for (const std::string end : {"anchor", "attachment"}) {
        if (const std::size_t at = sentence.find(": " + end + " "); at != std::string::npos) {
          sentence.replace(at + 2, end.size(), end == "anchor" ? "to: at" : "from: at");
        }
      }
    }
    std::sort(sentences.begin(), sentences.end());
    std::vector<std::string> found = problems(as_system(the_case));
    std::sort(found.begin(), found.end());
    if (!the_case.cables.empty()) {  // a system needs none
      EXPECT_EQ(found, sentences) << broken.name;
    }
  }
}

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
