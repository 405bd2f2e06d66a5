// Elastic cables in files: what they say, and what is wrong with them.

#include <gtest/gtest.h>

#include "tautline/case_file.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

using Strings = std::vector<std::string>;

/// A file whose cable has these keys, from line 13 on.
std::string jumper(const std::string& keys, bool in_space = false) {
  const std::string z = in_space ? ", 0.0" : "";
  return "name = \"jumper\"\nduration = 4.0\ngravity = [0.0, -9.81" + z +
         "]\n\n[[bodies]]\nmass = 2.0\nposition = [0.0, -0.85" + z +
         "]\n\n[[cables]]\nfrom = { body = \"body\" }\nto = [0.0, 0.0" + z + "]\nlength = 1.0\n" +
         keys + "\n";
}

/// Its corners, in numbers.
std::vector<std::pair<double, double>> corners_of(const Elasticity& law) {
  std::vector<std::pair<double, double>> result;
  for (const Corner& corner : law.corners) {
    result.emplace_back(corner.stretch, corner.stiffness);
  }
  return result;
}

Elasticity law_of(const std::string& keys) {
  const SystemReading reading = read_system_text(jumper(keys), "jumper.toml");
  const SystemReading in_space = read_system_text(jumper(keys, true), "jumper.toml");
  EXPECT_EQ(reading.problems, Strings()) << keys;
  EXPECT_EQ(in_space.problems, Strings()) << keys;
  if (!reading.system || !in_space.in_space) {
    return {};
  }
  EXPECT_EQ(reading.system->cables[0].restitution, 1.0) << keys;
  const Elasticity law = reading.system->cables[0].elasticity.value_or(Elasticity());
  const Elasticity same = in_space.in_space->cables[0].elasticity.value_or(Elasticity());
  EXPECT_EQ(law.stiffness, same.stiffness) << keys;
  EXPECT_EQ(law.damping, same.damping) << keys;
  EXPECT_EQ(law.damping_ratio, same.damping_ratio) << keys;
  EXPECT_EQ(law.of_strain, same.of_strain) << keys;
  EXPECT_EQ(corners_of(law), corners_of(same)) << keys;
  EXPECT_EQ(law.cut, same.cut) << keys;
  return law;
}

TEST(ElasticFile, SaysHowACableStretches) {
  const Elasticity undamped = law_of("stiffness = 100");
  EXPECT_EQ(undamped.stiffness, std::vector<double>{100.0});
  EXPECT_EQ(undamped.damping, 0.0);
  EXPECT_EQ(undamped.damping_ratio, 0.0);
  EXPECT_EQ(law_of("stiffness = [100.0, 0.0, 1e5]").stiffness,
            (std::vector<double>{100.0, 0.0, 1e5}));
  EXPECT_EQ(law_of("stiffness = 100.0\ndamping = 0.5").damping, 0.5);
  EXPECT_EQ(law_of("stiffness = 100.0\ndamping_ratio = 0.05").damping_ratio, 0.05);
  // the inverse of (E6) by bisection in many digits
  EXPECT_NEAR(law_of("stiffness = 100.0\nrestitution = 0.9").damping_ratio, 0.034265204126232760984,
              1e-16);
  EXPECT_EQ(law_of("stiffness = 100.0\nrestitution = 1.0").damping_ratio, 0.0);
}

TEST(ElasticFile, SaysWhereTheForceBendsAndWhatItDependsOn) {
  const Elasticity bent = law_of("stiffness = 100.0\ncorners = [[0.02, 500], [0.05, 80.0]]");
  EXPECT_EQ(corners_of(bent),
            (std::vector<std::pair<double, double>>{{0.02, 500.0}, {0.05, 80.0}}));
  EXPECT_FALSE(bent.of_strain);
  const Elasticity strained = law_of("EA = 1.5e4\ndamping_ratio = 0.1");
  EXPECT_EQ(strained.stiffness, std::vector<double>{1.5e4});
  EXPECT_EQ(strained.damping_ratio, 0.1);
  EXPECT_TRUE(strained.of_strain);
  EXPECT_EQ(law_of("EA = [100.0, 50.0]").stiffness, (std::vector<double>{100.0, 50.0}));
  EXPECT_EQ(strained.cut, ElasticCut::force);
  EXPECT_EQ(law_of("EA = 1.0\ncut = \"force\"").cut, ElasticCut::force);
  EXPECT_EQ(law_of("EA = 1.0\ncut = \"stretch\"").cut, ElasticCut::stretch);
  EXPECT_EQ(law_of("EA = 1.0\ncut = \"never\"").cut, ElasticCut::never);
}

TEST(ElasticFile, IsWrittenWithoutImpacts) {
  for (const auto& [keys, written] : std::vector<std::pair<std::string, std::string>>{
           {"stiffness = 100", "stiffness = 100.0\n"},
           {"stiffness = [100.0]", "stiffness = 100.0\n"},
           {"stiffness = [100.0, 5.0]\ndamping = 0.5", "stiffness = [100.0, 5.0]\ndamping = 0.5\n"},
           {"stiffness = 100.0\ndamping_ratio = 0.25", "stiffness = 100.0\ndamping_ratio = 0.25\n"},
           {"stiffness = 100.0\nrestitution = 1.0", "stiffness = 100.0\n"},
           {"stiffness = 100.0\ncorners = [[0.02, 500]]\ndamping = 0.5",
            "stiffness = 100.0\ncorners = [[0.02, 500.0]]\ndamping = 0.5\n"},
           {"EA = 200\ncorners = [[0.02, 500]]", "EA = 200.0\ncorners = [[0.02, 500.0]]\n"},
           {"stiffness = 2.0\ncut = \"force\"", "stiffness = 2.0\n"},
           {"stiffness = 2.0\ncut = \"never\"", "stiffness = 2.0\ncut = \"never\"\n"}}) {
    const SystemReading reading = read_system_text(jumper(keys), "jumper.toml");
    ASSERT_TRUE(reading.system) << keys;
    const std::string text = write_system(*reading.system);
    EXPECT_TRUE(text.ends_with("length = 1.0\n" + written)) << text;
    EXPECT_EQ(write_system(*read_system_text(text, "written.toml").system), text);
  }
}

TEST(ElasticFile, AMistakeGivesOneSentence) {
  const std::string either =
      "a finite number above 0, or an array of numbers k1, k2, ... for k1 s + k2 s^2 + ... [N/m, "
      "N/m^2, ...]";
  const std::string one = ", must be one of damping, damping_ratio and restitution";
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"stiffness = -5.0", "13: cables[0].stiffness = -5: must be " + either},
      {"stiffness = \"stiff\"",
       "13: cables[0].stiffness = \"stiff\": is a string, must be " + either},
      {"stiffness = []",
       "13: cables[0].stiffness = []: must be an array of at least one number [N/m, N/m^2, ...]"},
      {"stiffness = [5.0, true]",
       "13: cables[0].stiffness[1] = true: is a boolean, must be a finite number [N/m, N/m^2, "
       "...]"},
      {"stiffness = [-5.0, 1.0]",
       "13: cable 0: stiffness -5 must be a finite number above 0 [N/m]"},
      {"stiffness = [5.0, -50.0]",
       "9: cable 0: its force falls at a stretch of 0.067108864 m, which the start and a fall "
       "through two lengths may reach; stiffness must give a force that rises"},
      {"stiffness = 1e15",
       "9: cable 0: its frequency, 22360679.774997897 rad/s, must be at most 625000 rad/s for a "
       "duration of 4 s: make it inextensible with restitution 1, which its contacts have, or "
       "lower its stiffness to 7.8125e+11 N/m"},
      {"stiffness = 5.0\ndamping = -1.0",
       "14: cables[0].damping = -1: must be a finite number, 0 or above [N s/m]"},
      {"stiffness = 5.0\ndamping_ratio = -1.0",
       "14: cables[0].damping_ratio = -1: must be a finite number, 0 or above"},
      {"stiffness = 5.0\ndamping = 0.1\ndamping_ratio = 0.1",
       "15: cables[0].damping_ratio = 0.1: is there with damping" + one},
      {"stiffness = 5.0\nrestitution = 0.9\ndamping = 0.1",
       "14: cables[0].restitution = 0.9: is there with damping" + one},
      {"stiffness = 5.0\nrestitution = 0.0",
       "14: cables[0].restitution = 0: must be in [1e-40, 1], for no damping takes all speed"},
      {"stiffness = 5.0\nrestitution = 1.5",
       "14: cables[0].restitution = 1.5: must be in [1e-40, 1], for no damping takes all speed"},
      {"stiffness = 5.0\ncapture_speed = 0.1",
       "14: cables[0].capture_speed = 0.1: is there with stiffness, must be left out: "
       "an elastic cable has no impacts"},
      {"stiffness = 5.0\ndampng = 0.1",
       "14: cables[0].dampng = 0.1: unknown key; did you mean damping?"},
      {"restitution = 0.8\ndamping = 0.1",
       "14: cables[0].damping = 0.1: is for an elastic cable, must be there with stiffness or EA"},
      {"restitution = 0.8\ncorners = [[0.1, 2.0]]",
       "14: cables[0].corners: is for an elastic cable, must be there with stiffness or EA"},
      {"stiffness = 5.0\ncut = \"maybe\"",
       "14: cables[0].cut = \"maybe\": must be force, stretch or never"},
      {"stiffness = 5.0\nEA = 5.0",
       "14: cables[0].EA = 5: is there with stiffness, must be one of the two"},
      {"EA = 0",
       "13: cables[0].EA = 0: must be a finite number above 0, or an array of numbers k1, "
       "k2, ... for k1 x + k2 x^2 + ... of the strain x [N]"},
      {"EA = 1e15",
       "9: cable 0: its frequency, 22360679.774997897 rad/s, must be at most 625000 rad/s for a "
       "duration of 4 s: make it inextensible with restitution 1, which its contacts have, or "
       "lower its EA to 7.8125e+11 N"},
      {"EA = 5.0\ncut = \"never\"\nrestitution = 0.5",
       "15: cables[0].restitution = 0.5: is of contacts that end where the tension is 0, must be "
       "left out with this cut"},
      {"EA = 5.0\ncapture_speed = 0.1",
       "14: cables[0].capture_speed = 0.1: is there with EA, must be left out: an elastic cable "
       "has no impacts"},
      {"stiffness = 5.0\ncorners = [[0.1, 0.0]]",
       "14: cable 0: corners[0]: stiffness 0 must be a finite number above 0 [N/m]"},
      {"stiffness = 5.0\ncorners = [[0.1, 7.0], 7.0]",
       "14: cables[0].corners[1] = 7: is a number, must be two numbers [stretch, stiffness] [m, "
       "N/m]"},
      {"stiffness = [5.0, 1.0]\ncorners = [[0.1, 7.0]]",
       "14: cable 0: corners go on from one stiffness, and 2 coefficients are given; must be one"},
      {"stifness = 5.0\nrestitution = 0.8",
       "13: cables[0].stifness = 5: unknown key; did you mean stiffness?"},
  };
  for (const auto& [keys, sentence] : mistakes) {
    const SystemReading reading = read_system_text(jumper(keys), "jumper.toml");
    EXPECT_EQ(reading.problems, Strings{"jumper.toml:" + sentence});
    EXPECT_FALSE(reading.system);
  }
}

}  // namespace
}  // namespace tautline::bench
