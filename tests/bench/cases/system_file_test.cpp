// The files of systems: what they say, and what is wrong with them.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "tautline/case_file.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

using Strings = std::vector<std::string>;
using Vec3 = BasicVector<double, 3>;

const std::string crane = R"(name = "crane"
duration = 4.0
gravity = [0.0, -9.81]

[[bodies]]
name = "load"
mass = 2.0
inertia = 0.08
drag = 0.05
spin_drag = 0.01
force = { waves = [{ amplitude = [0.3, 0.0], frequency = 1.7, phase = 0.3 }] }
moment = { value = 0.1, pieces = [{ from = 0.5, polynomial = [0.0, 0.2] }] }
position = [0.05, -1.35]
angle = 0.1
velocity = [0.1, 0.2]
spin = 0.4

[[bodies]]
name = "hook"
mass = 0.3
position = [0.1, -0.85]

[[cables]]
from = { body = "load", at = [-0.3, 0.1] }
to = { body = "hook" }
length = 0.7
restitution = 0.8

[[cables]]
from = { body = "hook" }
to = { at = [0.0, 0.0], waves = [{ amplitude = [0.15, 0.0], frequency = 1.5, phase = -0.5 }] }
length = { times = [0.5, 1.5], values = [1.0, 0.7] }
restitution = 0.8
cut_at = 3.0

[[cables]]
from = { body = "load", at = [0.3, 0.1] }
through = [{ at = [0.5, 0.0] }, [0.2, 0.1]]
to = { body = "hook" }
length = 3.5
restitution = 0.5
from_time = 0.25
)";

/// `text` with `place` replaced, which it has.
std::string replaced(std::string text, const std::string& place, const std::string& instead) {
  const std::size_t at = text.find(place);
  EXPECT_NE(at, std::string::npos) << place;
  return text.replace(at, place.size(), instead);
}

System system_in(const std::string& text) {
  SystemReading reading = read_system_text(text, "crane.toml");
  EXPECT_EQ(reading.problems, Strings());
  return reading.system.value_or(System());
}

TEST(SystemFile, SaysWhatEachNumberIs) {
  const System system = system_in(crane);
  ASSERT_EQ(system.bodies.size(), 2U);
  ASSERT_EQ(system.cables.size(), 3U);
  EXPECT_EQ(system.name, "crane");
  EXPECT_EQ(system.duration, 4.0);
  EXPECT_EQ(system.gravity.at(3.0), Vec2(0.0, -9.81));
  const BodyOfSystem& load = system.bodies[0];
  EXPECT_EQ(load.name, "load");
  EXPECT_EQ(load.mass, 2.0);
  EXPECT_EQ(load.inertia, 0.08);
  EXPECT_EQ(load.drag, 0.05);
  EXPECT_EQ(load.spin_drag, 0.01);
  EXPECT_NEAR(load.force.at(2.0).x(), 0.3 * std::cos(1.7 * 2.0 + 0.3), 1e-15);
  EXPECT_NEAR(load.moment.at(1.5)[0], 0.1 + 0.2 * (1.5 - 0.5), 1e-15);
  EXPECT_EQ(load.moment.at(0.0)[0], 0.1);
  const State& state = system.initial.bodies[0];
  EXPECT_EQ(state.position, Vec2(0.05, -1.35));
  EXPECT_EQ(state.angle, 0.1);
  EXPECT_EQ(state.velocity, Vec2(0.1, 0.2));
  EXPECT_EQ(state.spin, 0.4);
  EXPECT_EQ(system.bodies[1].inertia, 0.0);
  EXPECT_EQ(system.initial.bodies[1].velocity, Vec2(0.0, 0.0));
  EXPECT_EQ(system.cables[0].from.body, 0U);
  EXPECT_EQ(system.cables[0].from.at, Vec2(-0.3, 0.1));
  EXPECT_EQ(system.cables[0].to.body, 1U);
  EXPECT_EQ(system.cables[0].to.at, Vec2(0.0, 0.0));
  const CableOfSystem& hoist = system.cables[1];
  EXPECT_FALSE(hoist.to.body);
  EXPECT_NEAR(hoist.to.motion.at(1.0).x(), 0.15 * std::cos(1.5 - 0.5), 1e-16);
  EXPECT_EQ(hoist.length.at(0.1)[0], 1.0);
  EXPECT_NEAR(hoist.length.at(1.0)[0], 0.85, 1e-15);
  EXPECT_EQ(hoist.length.at(3.9)[0], 0.7);
  EXPECT_EQ(hoist.cut_at, 3.0);
  EXPECT_FALSE(hoist.from_time);
  const CableOfSystem& ringed = system.cables[2];
  ASSERT_EQ(ringed.through.size(), 2U);
  EXPECT_EQ(ringed.through[1].at, Vec2(0.2, 0.1));
  EXPECT_EQ(ringed.from_time, 0.25);
}

TEST(SystemFile, HasOneFormForEveryFunctionOfTime) {
  const auto length = [](const std::string& text) {
    return system_in(replaced(crane, "{ times = [0.5, 1.5], values = [1.0, 0.7] }", text))
        .cables[1]
        .length;
  };
  EXPECT_EQ(length("1.25").at(2.0)[0], 1.25);
  EXPECT_EQ(length("{ value = 1.25 }").at(2.0)[0], 1.25);
  EXPECT_NEAR(length("{ value = 1.25, waves = [{ amplitude = 0.1, frequency = 2.0 }] }").at(2.0)[0],
              1.25 + 0.1 * std::cos(4.0), 1e-15);
  EXPECT_NEAR(length("{ value = 0.5, times = [0.0, 2.0], values = [1.0, 2.0] }").at(1.0)[0], 2.0,
              1e-15);
  const Function<1> spline =
      length("{ times = [0.0, 1.0, 3.0], values = [1.0, 2.0, 1.5], spline = true }");
  EXPECT_NEAR(spline.at(1.0)[0], 2.0, 1e-15);
  EXPECT_NEAR(spline.at(1e-5)[0], 1.0, 1e-8);  // its rate is zero there
  EXPECT_NEAR(length("{ pieces = [{ from = 0.0, polynomial = [1.0, 0.5, -0.125] }] }").at(2.0)[0],
              1.5, 1e-15);
  for (const std::string place : {"gravity = ", "force = "}) {
    const System system = system_in(
        replaced(replaced(crane, "gravity = [0.0, -9.81]",
                          "gravity = { value = [0.0, -9.81], times = [0.0, 1.0], values = "
                          "[[0.0, 0.0], [1.0, 0.0]] }"),
                 "to = { at = [0.0, 0.0], waves",
                 "to = { times = [0.0, 1.0], values = [[0.0, 0.0], [0.1, 0.2]], waves"));
    EXPECT_NEAR(system.gravity.at(0.5).x(), 0.5, 1e-15) << place;
    EXPECT_NEAR(system.gravity.at(0.5).y(), -9.81, 1e-15) << place;
    EXPECT_NEAR(system.cables[1].to.motion.at(1.0).y(), 0.2, 1e-15) << place;
  }
}

const std::string ball_text = R"(name = "ball"
duration = 2.0
gravity = [0.0, -1.0]
[body]
mass = 1.0
inertia = 0.1
[[cables]]
anchor = [0.0, 1.0]
attachment = [0.0, 0.1]
length = 1.5
restitution = 0.5
[initial]
position = [0.0, 0.0]
)";

TEST(SystemFile, IsACaseWhereOneBodyAndConstantsAreAllThereIs) {
  const SystemReading reading = read_system_text(ball_text, "ball.toml");
  ASSERT_EQ(reading.problems, Strings());
  ASSERT_TRUE(reading.the_case);
  EXPECT_EQ(reading.only_a_system, "");
  EXPECT_EQ(test::bits(*reading.the_case),
            test::bits(*read_case_text(ball_text, "ball.toml").the_case));
  const System same = as_system(*reading.the_case);
  EXPECT_EQ(write_system(*reading.system), write_system(same));
  EXPECT_EQ(same.cables[0].to.at, Vec2(0.0, 1.0));
  EXPECT_EQ(same.cables[0].from.at, Vec2(0.0, 0.1));
}

TEST(SystemFile, IsASystemByItsContentInTheShortFormToo) {
  const std::map<std::string, std::pair<std::string, std::string>> changes = {
      {"ball.toml:3: gravity", {"[0.0, -1.0]", "{ value = [0.0, -1.0] }"}},
      {"ball.toml:7: body.drag", {"inertia = 0.1", "inertia = 0.1\ndrag = 0.1"}},
      {"ball.toml:7: body.force", {"inertia = 0.1", "inertia = 0.1\nforce = [0.0, 0.1]"}},
      {"ball.toml:8: cables[0].anchor",
       {"[0.0, 1.0]", "{ waves = [{ amplitude = [0.0, 1.0], frequency = 0.0 }] }"}},
      {"ball.toml:10: cables[0].length", {"1.5", "{ times = [0.0, 1.0], values = [1.5, 1.0] }"}},
      {"ball.toml:12: cables[0].cut_at", {"restitution = 0.5", "restitution = 0.5\ncut_at = 1.0"}},
      {"ball.toml:11: cables[0].stiffness", {"restitution = 0.5", "stiffness = 1e3"}},
      {"ball.toml:8: cables[0].from",
       {"anchor = [0.0, 1.0]\nattachment = [0.0, 0.1]",
        "from = { body = \"body\", at = [0.0, 0.1] }\nto = [0.0, 1.0]"}}};
  for (const auto& [key, change] : changes) {
    const std::string text = replaced(ball_text, change.first, change.second);
    const SystemReading reading = read_system_text(text, "ball.toml");
    ASSERT_EQ(reading.problems, Strings()) << text;
    EXPECT_FALSE(reading.the_case) << text;
    EXPECT_EQ(reading.only_a_system,
              key +
                  ": makes this a system; must be a case here: one [body], cables with anchor "
                  "and attachment, and constants");
    EXPECT_EQ(read_case_text(text, "ball.toml").problems, Strings{reading.only_a_system});
    EXPECT_EQ(reading.system->cables[0].from.at, Vec2(0.0, 0.1)) << text;
    EXPECT_NEAR((reading.system->cables[0].to.at + reading.system->cables[0].to.motion.at(0.0) -
                 Vec2(0.0, 1.0))
                    .norm(),
                0.0, 1e-15)
        << text;
  }
}

TEST(SystemFile, RefusesAStartThatIsToBeTaut) {
  EXPECT_EQ(read_system_text(crane, "crane.toml", CableSet::of(1)).problems,
            Strings{"crane.toml: cable 1 cannot start taut: must be a cable of a case, one [body] "
                    "where all is constant"});
}

/// A file with one mistake, and the sentence that it earns.
struct Mistake {
  std::string place;
  std::string instead;
  std::string sentence;
};

const std::vector<Mistake> mistakes = {
    {"gravity = [0.0, -9.81]", "gravity = [0.0, 0.0, -9.81]",
     "crane.toml:3: gravity = [0, 0, -9.81]: is an array of length 3, must be two numbers [x, y] "
     "[m/s^2]"},
    {"gravity = [0.0, -9.81]", "gravity = -9.81",
     "crane.toml:3: gravity = -9.81: is a number, must be two numbers [x, y] [m/s^2]"},
    {"gravity = [0.0, -9.81]", "gravity = {}",
     "crane.toml:3: gravity: is empty, must have value, waves, times with values, or pieces"},
    {"gravity = [0.0, -9.81]", "gravity = { vaule = [0.0, -9.81] }",
     "crane.toml:3: gravity.vaule = [0, -9.81]: unknown key; did you mean value?"},
    {"gravity = [0.0, -9.81]", "gravity = { value = [0.0, -9.81, 0.0] }",
     "crane.toml:3: gravity.value = [0, -9.81, 0]: is an array of length 3, must be two numbers "
     "[x, y] [m/s^2]"},
    {"gravity = [0.0, -9.81]\n", "",
     "crane.toml: gravity: is missing, must be two numbers [x, y] [m/s^2]"},
    {"duration = 4.0", "duration = 0",
     "crane.toml:2: duration = 0: must be a finite number above 0 [s]"},
    {"duration = 4.0", "duration = 4.0\nangle_limit = 1.5",
     "crane.toml:3: angle_limit = 1.5: is for a case of one [body] where all is constant; leave it "
     "out"},
    {"duration = 4.0", "duration = 4.0\nceiling = 1.5",
     "crane.toml:3: ceiling = 1.5: is for a case of one [body] where all is constant; leave it "
     "out"},
    {"mass = 2.0\n", "",
     "crane.toml:5: bodies[0].mass: is missing, must be a finite number above 0 [kg]"},
    {"mass = 2.0", "mass = -2.0",
     "crane.toml:7: bodies[0].mass = -2: must be a finite number above 0 [kg]"},
    {"inertia = 0.08", "inertia = [0.08, 0.1, 0.12]",
     "crane.toml:8: bodies[0].inertia = [0.08, 0.1, 0.12]: is an array, must be a finite number, 0 "
     "or above [kg m^2]"},
    {"drag = 0.05", "drag = -0.05",
     "crane.toml:9: bodies[0].drag = -0.05: must be a finite number, 0 or above [N s/m]"},
    {"drag = 0.05", "drga = 0.05",
     "crane.toml:9: bodies[0].drga = 0.05: unknown key; did you mean drag?"},
    {"spin_drag = 0.01", "spin_drag = \"little\"",
     "crane.toml:10: bodies[0].spin_drag = \"little\": is a string, must be a finite number, 0 or "
     "above [N m s]"},
    {"amplitude = [0.3, 0.0], frequency = 1.7", "amplitude = 0.3, frequency = 1.7",
     "crane.toml:11: bodies[0].force.waves[0].amplitude = 0.3: is a number, must be two numbers "
     "[x, y] [N]"},
    {"frequency = 1.7", "frequency = -1.7",
     "crane.toml:11: bodies[0].force.waves[0].frequency = -1.7: must be a finite number, 0 or "
     "above [rad/s]"},
    {"frequency = 1.7, ", "",
     "crane.toml:11: bodies[0].force.waves[0].frequency: is missing, must be a finite number, 0 or "
     "above [rad/s]"},
    {"force = { waves = [", "force = { value = [0.0, 0.1], wave = [",
     "crane.toml:11: bodies[0].force.wave: unknown key; did you mean waves?"},
    {"force = { waves = [{ amplitude = [0.3, 0.0], frequency = 1.7, phase = 0.3 }] }",
     "force = { waves = [] }",
     "crane.toml:11: bodies[0].force.waves = []: none given, must be tables, each with amplitude "
     "and frequency"},
    {"force = { waves = [{ amplitude = [0.3, 0.0], frequency = 1.7, phase = 0.3 }] }",
     "force = 0.3",
     "crane.toml:11: bodies[0].force = 0.3: is a number, must be two numbers [x, y] [N]"},
    {"value = 0.1, pieces", "value = [0.1, 0.0], pieces",
     "crane.toml:12: bodies[0].moment.value = [0.1, 0]: is an array, must be a finite number [N "
     "m]"},
    {"{ from = 0.5, polynomial = [0.0, 0.2] }", "{ from = 0.5, polynomial = [] }",
     "crane.toml:12: bodies[0].moment.pieces[0].polynomial = []: must be an array of at least one "
     "number [N m]"},
    {"{ from = 0.5, polynomial = [0.0, 0.2] }", "{ polynomial = [0.0, 0.2] }",
     "crane.toml:12: bodies[0].moment.pieces[0].from: is missing, must be a finite number [s]"},
    {"{ from = 0.5, polynomial = [0.0, 0.2] }", "{ from = 0.5 }",
     "crane.toml:12: bodies[0].moment.pieces[0].polynomial: is missing, must be an array of at "
     "least one number [N m]"},
    {"{ from = 0.5, polynomial = [0.0, 0.2] }",
     "{ from = 0.5, polynomial = [0.2] }, { from = 0.5, polynomial = [0.3] }",
     "crane.toml:12: body 0: moment: pieces[1]: from 0.5 must be above the one before, 0.5 [s]"},
    {"position = [0.05, -1.35]\n", "",
     "crane.toml:5: bodies[0].position: is missing, must be two numbers [x, y] [m]"},
    {"position = [0.05, -1.35]", "position = [0.05, 0.0, -1.35]",
     "crane.toml:13: bodies[0].position = [0.05, 0, -1.35]: is an array of length 3, must be two "
     "numbers [x, y] [m]"},
    {"position = [0.05, -1.35]", "position = [0.05, -1.95]",
     "crane.toml:23: cable 0: overstretched at the start by 0.39102593816579345 m: its ends are "
     "1.0910259381657934 m apart, its length is 0.7 m; a length of 1.0910259381657934 m would do"},
    {"angle = 0.1", "orientation = [1.0, 0.0, 0.0, 0.0]",
     "crane.toml:14: bodies[0].orientation = [1, 0, 0, 0]: unknown key, must be name, mass, "
     "inertia, drag, spin_drag, force, moment, position, angle, velocity or spin"},
    {"spin = 0.4", "spin = [0.4, -0.3, 1.0]",
     "crane.toml:16: bodies[0].spin = [0.4, -0.3, 1]: is an array, must be a finite number "
     "[rad/s]"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }", "from = { body = \"laod\", at = [-0.3, 0.1] }",
     "crane.toml:24: cables[0].from.body = \"laod\": unknown body; did you mean load?"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }", "from = { body = 0, at = [-0.3, 0.1] }",
     "crane.toml:24: cables[0].from.body = 0: is an integer, must be a string that is not empty"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }", "from = { body = \"load\", at = -0.3 }",
     "crane.toml:24: cables[0].from.at = -0.3: is a number, must be two numbers [x, y] [m]"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }", "from = \"load\"",
     "crane.toml:24: cables[0].from = \"load\": is a string, must be a table such as { body = "
     "\"load\", at = [0.1, 0.0] }, or a point [x, y] of the world [m]"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }\n", "",
     "crane.toml:23: cables[0].from: is missing, must be a table such as { body = \"load\", at = "
     "[0.1, 0.0] }, or a point [x, y] of the world [m]"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }", "from = {}",
     "crane.toml:24: cables[0].from: is empty, must have at, waves, times with values, pieces, or "
     "body"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }",
     "from = { body = \"load\", waves = [{ amplitude = [0.1, 0.0], frequency = 1.0 }] }",
     "crane.toml:24: cables[0].from.waves: is for an end in the world; leave it out, or leave body "
     "out"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }", "from = { body = \"hook\" }",
     "crane.toml:24: cable 0: from and to are both on body 1, which it cannot hold; must join two "
     "bodies, or a body with the world"},
    {"from = { body = \"load\", at = [-0.3, 0.1] }\nto = { body = \"hook\" }",
     "anchor = [0.0, 0.0]\nattachment = [0.0, 0.0]",
     "crane.toml:25: cables[0].attachment = [0, 0]: is for the only body of a file, which has 2; "
     "must be from and to, such as from = { body = \"ball\", at = [0.1, 0.0] }"},
    {"to = { body = \"hook\" }\nlength = 0.7", "length = 0.7",
     "crane.toml:23: cables[0].to: is missing, must be a table such as { body = \"load\", at = "
     "[0.1, 0.0] }, or a point [x, y] of the world [m]"},
    {"to = { body = \"hook\" }\nlength = 0.7", "to = { body = \"hook\" }\nlength = -0.7",
     "crane.toml:26: cables[0].length = -0.7: must be a finite number above 0 [m]"},
    {"to = { body = \"hook\" }\nlength = 0.7", "to = { body = \"hook\" }\nlength = 0.2",
     "crane.toml:23: cable 0: overstretched at the start by 0.3601768181485691 m: its ends are "
     "0.5601768181485691 m apart, its length is 0.2 m; a length of 0.5601768181485691 m would do"},
    {"to = { body = \"hook\" }\nlength = 0.7", "to = { body = \"hook\" }\nlength = [0.7, 0.8]",
     "crane.toml:26: cables[0].length = [0.7, 0.8]: is an array, must be a finite number above 0 "
     "[m]"},
    {"to = { body = \"hook\" }\nlength = 0.7",
     "to = { body = \"hook\" }\nlength = 0.7\ntaut = true",
     "crane.toml:27: cables[0].taut = true: is for a case of one [body] where all is constant; "
     "leave it out and give the start its exact digits"},
    {"length = 0.7\n", "",
     "crane.toml:23: cables[0].length: is missing, must be a finite number above 0 [m]"},
    {"length = 0.7\nrestitution = 0.8", "length = 0.7\nrestitution = 1.8",
     "crane.toml:27: cables[0].restitution = 1.8: must be in [0, 1]"},
    {"times = [0.5, 1.5]", "times = [0.5, 0.5]",
     "crane.toml:32: cables[1].length.times = [0.5, 0.5]: must rise: 0.5 s is followed by 0.5 s, a "
     "jump"},
    {"times = [0.5, 1.5]", "times = [1.5, 0.5]",
     "crane.toml:32: cables[1].length.times = [1.5, 0.5]: must rise: 1.5 s is followed by 0.5 s"},
    {"times = [0.5, 1.5]", "times = [0.5, 1.5, 2.0]",
     "crane.toml:32: cables[1].length.values = [1, 0.7]: 2 given, must be 3, one for each of the "
     "times"},
    {"times = [0.5, 1.5], ", "",
     "crane.toml:32: cables[1].length.values = [1, 0.7]: is there without times, must have a time "
     "for each of them"},
    {", values = [1.0, 0.7]", "",
     "crane.toml:32: cables[1].length.values: is missing, must be an array of at least one number "
     "[m]"},
    {"values = [1.0, 0.7]", "values = [1.0, -0.7]",
     "crane.toml:32: cable 1: length -0.7 at 1.5 s must be above 0 [m] as long as the cable acts"},
    {"values = [1.0, 0.7]", "values = [0.5, 0.7]",
     "crane.toml:29: cable 1: overstretched at the start by 0.3505885750962714 m: its ends are "
     "0.8505885750962714 m apart, its length is 0.5 m; a length of 0.8505885750962714 m would do"},
    {"values = [1.0, 0.7]", "values = [1.0, 0.7], spline = 1",
     "crane.toml:32: cables[1].length.spline = 1: is an integer, must be true or false"},
    {"values = [1.0, 0.7]", "values = [1.0, 0.7], pieces = [{ from = 0.0, polynomial = [1.0] }]",
     "crane.toml:32: cables[1].length.pieces: is there with times, must be one of the two"},
    {"length = { times = [0.5, 1.5], values = [1.0, 0.7] }",
     "length = { value = 1.0, spline = true }",
     "crane.toml:32: cables[1].length.spline = true: is there without times and values, leave it "
     "out"},
    {"length = { times = [0.5, 1.5], values = [1.0, 0.7] }",
     "length = { value = 1.0, waves = [{ amplitude = 1.2, frequency = 3.0 }] }",
     "crane.toml:32: cable 1: length -0.09335631426161228 at 3 s must be above 0 [m] as long as "
     "the cable acts"},
    {"length = { times = [0.5, 1.5], values = [1.0, 0.7] }",
     "length = { pieces = [{ from = 0.0, polynomial = [1.0] }, { from = 1.0, polynomial = [1.2] }] "
     "}",
     "crane.toml:32: cable 1: length: jumps by 0.19999999999999996 m at 1 s; must go on from where "
     "the piece before it ends"},
    {"cut_at = 3.0", "cut_at = 0.0",
     "crane.toml:34: cables[1].cut_at = 0: must be a finite number above 0 [s]"},
    {"cut_at = 3.0", "cut_at = true",
     "crane.toml:34: cables[1].cut_at = true: is a boolean, must be a finite number above 0 [s]"},
    {"cut_at = 3.0", "cutat = 3.0",
     "crane.toml:34: cables[1].cutat = 3: unknown key; did you mean cut_at?"},
    {"from_time = 0.25", "from_time = 0.25\ncut_at = 0.2",
     "crane.toml:43: cable 2: cut_at 0.2 must be above from_time 0.25 [s]"},
    {"from_time = 0.25", "from_time = -1",
     "crane.toml:42: cables[2].from_time = -1: must be a finite number above 0 [s]"},
    {"through = [{ at = [0.5, 0.0] }, [0.2, 0.1]]", "through = []",
     "crane.toml:38: cables[2].through = []: none given, must be tables, each a point of a body or "
     "of the world"},
    {"through = [{ at = [0.5, 0.0] }, [0.2, 0.1]]", "through = { at = [0.5, 0.0] }",
     "crane.toml:38: cables[2].through: is a table, must be tables, each a point of a body or of "
     "the world"},
    {"through = [{ at = [0.5, 0.0] }, [0.2, 0.1]]",
     "through = [{ at = [0.5, 0.0] }, [0.2, 0.1, 0.0]]",
     "crane.toml:38: cables[2].through[1] = [0.2, 0.1, 0]: is an array of length 3, must be two "
     "numbers [x, y] [m]"},
    {"through = [{ at = [0.5, 0.0] }, [0.2, 0.1]]", "thruogh = [{ at = [0.5, 0.0] }]",
     "crane.toml:38: cables[2].thruogh: unknown key; did you mean through?"},
    {"from_time = 0.25", "angle = 3",
     "crane.toml:42: cables[2].angle = 3: unknown key, must be from, through, to, length, "
     "stiffness, EA, restitution, capture_speed, restitution_table, from_time or cut_at"},
    {"to = { at = [0.0, 0.0], waves", "to = { at = [0.0, 0.0], wave_list",
     "crane.toml:31: cables[1].to.wave_list: unknown key, must be body, at, waves, times or "
     "pieces"},
    {"[[bodies]]\nname = \"load\"",
     "[body]\nmass = 1.0\ninertia = 1.0\n[[bodies]]\nname = \"load\"",
     "crane.toml:5: body: is there with bodies, must be one of the two"},
    {"[[bodies]]\nname = \"load\"", "[initial]\nposition = [0, 0]\n[[bodies]]\nname = \"load\"",
     "crane.toml:5: initial: is there with bodies, which have the start; leave it out"},
    {"drag = 0.05", "drag = 1e21", "crane.toml:9: body 0: drag 1e+21 is larger in size than 1e+20"},
    {"inertia = 0.08\ndrag = 0.05\nspin_drag = 0.01",
     "inertia = 0.08\ndrag = 0.05\nspin_drag = -0.01",
     "crane.toml:10: bodies[0].spin_drag = -0.01: must be a finite number, 0 or above [N m s]"},
    {"phase = 0.3", "phase = \"none\"",
     "crane.toml:11: bodies[0].force.waves[0].phase = \"none\": is a string, must be a finite "
     "number [rad]"},
    {"[[cables]]\nfrom = { body = \"load\", at = [-0.3, 0.1] }",
     "[[cables]]\nname = \"sling\"\nfrom = { body = \"load\", at = [-0.3, 0.1] }",
     "crane.toml:24: cables[0].name = \"sling\": unknown key, must be from, through, to, length, "
     "stiffness, EA, restitution, capture_speed, restitution_table, from_time or cut_at"},
};

class SystemMistake : public testing::TestWithParam<Mistake> {};

TEST_P(SystemMistake, GivesOneSentenceWithFileLineKeyAndWhatWouldBeRight) {
  const auto& [place, instead, sentence] = GetParam();
  const SystemReading reading = read_system_text(replaced(crane, place, instead), "crane.toml");
  EXPECT_EQ(reading.problems, Strings{sentence});
  EXPECT_FALSE(reading.system);
  EXPECT_TRUE(sentence.starts_with("crane.toml:")) << sentence;
}

TEST_P(SystemMistake, GivesTheSameInJsonWithoutTheLine) {
  const auto& [place, instead, sentence] = GetParam();
  const std::string json = test::file_as_json(replaced(crane, place, instead)).dump();
  Strings problems = read_system_text(json, "crane.toml").problems;
  const auto after_line = [](const std::string& one) { return one.substr(one.find(": ")); };
  ASSERT_EQ(problems.size(), 1U) << json;
  if (sentence.find("is a number") == std::string::npos) {  // JSON has 0.0 as the integer 0
    EXPECT_EQ(after_line(problems.front()), after_line(sentence));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, SystemMistake, testing::ValuesIn(mistakes));

TEST(SystemMistakes, AreAtLeast60) { EXPECT_GE(mistakes.size(), 60U); }

/// A load on four slings below a hook, which a hoist draws up from a trolley.
const char* const hoist = R"(name = "hoist"
duration = 4.0
gravity = [0.0, 0.0, -9.81]

[[bodies]]
name = "load"
mass = 2.0
inertia = [0.08, 0.10, 0.12]
force = { waves = [{ amplitude = [0.3, 0.0, 0.1], frequency = 1.7 }] }
moment = { value = [0.0, 0.1, 0.0] }
position = [0.05, 0.02, -1.35]
orientation = [0.8, 0.0, 0.0, 0.6]
velocity = [0.1, -0.2, 0.1]
spin = [0.4, -0.3, 1.0]

[[bodies]]
name = "hook"
mass = 0.3
position = [0.1, 0.0, -0.85]
rotation = [0.0, 0.0, 3.0]

[[cables]]
from = { body = "load", at = [-0.1, -0.2, 0.1] }
to = { body = "hook" }
length = 0.8
restitution = 0.8

[[cables]]
from = { body = "hook" }
through = [[0.0, 0.0, 0.1]]
to = { at = [0.0, 0.5, 0.1], waves = [{ amplitude = [0.15, 0.0, 0.0], frequency = 1.5 }] }
length = { times = [0.5, 1.5], values = [1.7, 1.4] }
restitution = 0.8
)";

TEST(SystemFileInSpace, SaysWhatEachNumberIs) {
  const SystemReading reading = read_system_text(hoist, "hoist.toml");
  ASSERT_EQ(reading.problems, Strings());
  EXPECT_FALSE(reading.system);
  EXPECT_FALSE(reading.the_case);
  const SpatialSystem& system = *reading.in_space;
  EXPECT_EQ(system.gravity.at(1.0), Vec3(0.0, 0.0, -9.81));
  EXPECT_EQ(system.bodies[0].inertia, Vec3(0.08, 0.10, 0.12));
  EXPECT_EQ(system.bodies[1].inertia, Vec3(0.0, 0.0, 0.0));
  EXPECT_EQ(system.bodies[0].moment.at(2.0), Vec3(0.0, 0.1, 0.0));
  EXPECT_EQ(system.bodies[0].force.at(0.0), Vec3(0.3, 0.0, 0.1));
  const SpatialState& load = system.initial.bodies[0];
  EXPECT_EQ(load.orientation, Quaternion(0.8, 0.0, 0.0, 0.6));
  EXPECT_EQ(load.spin, Vec3(0.4, -0.3, 1.0));
  const Quaternion turned(std::cos(1.5), 0.0, 0.0, std::sin(1.5));
  EXPECT_LT((system.initial.bodies[1].orientation - turned).norm(), 1e-15);
  EXPECT_EQ(system.cables[1].through[0].at, Vec3(0.0, 0.0, 0.1));
  EXPECT_EQ(system.cables[1].to.motion.at(0.0), Vec3(0.15, 0.0, 0.0));
}

TEST(SystemFileInSpace, TypedDigitsOfAQuaternionAreMadeAUnit) {
  const std::string text =
      replaced(hoist, "[0.8, 0.0, 0.0, 0.6]", "[0.1830127, 0.6830127, 0.1830127, 0.6830127]");
  const SystemReading reading = read_system_text(text, "hoist.toml");
  ASSERT_EQ(reading.problems, Strings());
  EXPECT_NEAR(reading.in_space->initial.bodies[0].orientation.norm(), 1.0, 2e-16);
}

TEST(SystemFileInSpace, AMistakeGivesOneSentence) {
  const std::vector<Mistake> in_space = {
      {"orientation = [0.8, 0.0, 0.0, 0.6]", "orientation = [0.8, 0.0, 0.6]",
       "hoist.toml:12: bodies[0].orientation = [0.8, 0, 0.6]: is an array of length 3, must be "
       "four numbers [w, x, y, z]"},
      {"orientation = [0.8, 0.0, 0.0, 0.6]", "orientation = [0.8, 0.0, 0.0, 0.7]",
       "hoist.toml:12: bodies[0].orientation = [0.8, 0, 0, 0.7]: has the length "
       "1.063014581273465, must be 1: a unit quaternion w, x, y, z"},
      {"orientation = [0.8, 0.0, 0.0, 0.6]",
       "orientation = [0.8, 0.0, 0.0, 0.6]\nrotation = [0.0, 0.0, 1.0]",
       "hoist.toml:13: bodies[0].rotation = [0, 0, 1]: is there with orientation, must be one of "
       "the two"},
      {"orientation = [0.8, 0.0, 0.0, 0.6]", "angle = 0.3",
       "hoist.toml:12: bodies[0].angle = 0.3: unknown key, must be name, mass, inertia, drag, "
       "spin_drag, force, moment, position, orientation, rotation, velocity or spin"},
      {"orientation = [0.8, 0.0, 0.0, 0.6]", "orientation = [0.0, 0.0, 0.0, 0.0]",
       "hoist.toml:12: body 0: orientation: w x y z has the length 0; must be 1"},
      {"inertia = [0.08, 0.10, 0.12]", "inertia = 0.1",
       "hoist.toml:8: bodies[0].inertia = 0.1: is a number, must be three numbers [x, y, z] [kg "
       "m^2]"},
      {"inertia = [0.08, 0.10, 0.12]", "inertia = [0.08, 0.10, 0.22]",
       "hoist.toml:8: body 0: inertia: the largest principal moment, 0.22, must not be above the "
       "sum of the other two, 0.18 [kg m^2]"},
      {"inertia = [0.08, 0.10, 0.12]", "inertia = [0.08, -0.10, 0.12]",
       "hoist.toml:8: bodies[0].inertia[1] = -0.1: must be a finite number, 0 or above [kg m^2]"},
      {"spin = [0.4, -0.3, 1.0]", "spin = 1.0",
       "hoist.toml:14: bodies[0].spin = 1: is a number, must be three numbers [x, y, z] [rad/s]"},
      {"position = [0.1, 0.0, -0.85]", "position = [0.1, -0.85]",
       "hoist.toml:19: bodies[1].position = [0.1, -0.85]: is an array of length 2, must be three "
       "numbers [x, y, z] [m]"},
      {"gravity = [0.0, 0.0, -9.81]", "gravity = [0.0, 0.0, nan]",
       "hoist.toml:3: gravity[2] = nan: must be a finite number [m/s^2]"},
      {"moment = { value = [0.0, 0.1, 0.0] }", "moment = 0.1",
       "hoist.toml:10: bodies[0].moment = 0.1: is a number, must be three numbers [x, y, z] [N m]"},
      {"through = [[0.0, 0.0, 0.1]]", "through = [[0.0, 0.1]]",
       "hoist.toml:30: cables[1].through[0] = [0, 0.1]: is an array of length 2, must be three "
       "numbers [x, y, z] [m]"},
      {"to = { body = \"hook\" }", "to = \"hook\"",
       "hoist.toml:24: cables[0].to = \"hook\": is a string, must be a table such as { body = "
       "\"load\", at = [0.1, 0.0, 0.0] }, or a point [x, y, z] of the world [m]"},
      {"values = [1.7, 1.4]", "values = [0.2, 1.4]",
       "hoist.toml:28: cable 1: overstretched at the start by 1.2772639841726676 m: its ends are "
       "1.4772639841726676 m apart through its rings, its length is 0.2 m; a length of "
       "1.4772639841726676 m would do"},
  };
  for (const auto& [place, instead, sentence] : in_space) {
    const SystemReading reading = read_system_text(replaced(hoist, place, instead), "hoist.toml");
    EXPECT_EQ(reading.problems, Strings{sentence});
    EXPECT_FALSE(reading.in_space);
  }
}

TEST(SystemFile, IsWrittenWholeOrNotAtAll) {
  const test::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "new" / "crane.toml";
  const System system = system_in(crane);
  EXPECT_EQ(write_system(system, path), Strings());
  const SystemReading again = read_system(path);
  ASSERT_EQ(again.problems, Strings());
  EXPECT_EQ(write_system(*again.system), write_system(system));
  System wrong = system;
  wrong.bodies[0].mass = 0.0;
  EXPECT_EQ(write_system(wrong, folder.path() / "wrong.toml"), problems(wrong));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "wrong.toml"));
  const std::string none = (folder.path() / "none.toml").native();
  EXPECT_EQ(read_system(none).problems, Strings{none + ": no such file"});
}

}  // namespace
}  // namespace tautline::bench
