#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <regex>
#include <sstream>

#include "tautline/scenarios.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

/// What `solve` prints, in one line: where lines break is no matter here.
std::string solved(const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {"solve"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  Outcome outcome = program(words);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  std::replace(outcome.output.begin(), outcome.output.end(), '\n', ' ');
  return outcome.output;
}

void expect_says(const std::string& output, const std::string& words) {
  EXPECT_NE(output.find(words), std::string::npos) << words << "\nis not in\n" << output;
}

TEST(SolveSystems, TwoBodiesHaveTheImpulseOfTheirClosedForm) {
  const std::string output = solved({"two-bodies"});
  expect_says(output, "two-bodies: 2 bodies, 1 cable, 2 events");
  expect_says(output, "its largest impulse is 6 at t = 0.100000.");
  expect_says(output, "Kinetic energy: 49 at the start, 28 at the end.");
  expect_says(output, "impacts take 21.");
  expect_says(output, "All these digits are those of a solution in 30 digits, too.");
}

TEST(SolveSystems, AStableBouncerHasOneImpactInAPeriod) {
  expect_says(solved({"bouncer-stable"}),
              "The waves come again every 2; in a period there is 1 impact, and the motion repeats "
              "every period.");
}

TEST(SolveSystems, ABuoySnapsAsItsClosedFormSays) {
  expect_says(solved({"buoy-heave"}), "its largest impulse is 3530.39 at t = 1.143370.");
}

TEST(SolveSystems, RestIsNoHorizon) {
  const std::string output = solved({"pulley"});
  expect_says(output, "Kinetic energy: 0 at the start, 0 at the end.");
  expect_says(output, "give 4.905; impacts take 4.905.");
  expect_says(output, "All these digits are those of a solution in 30 digits, too.");
  expect_says(solved({"peg"}), "The bodies are at rest from t = 0.56921 until the end");
}

TEST(SolveSystems, FastSaysThatNothingIsChecked) {
  expect_says(solved({"two-bodies", "--fast"}), "These digits are not checked");
}

TEST(SolveSystems, FastShowsTheContactsOfElasticCables) {
  const std::string table = solved({"snap", "--fast"});
  expect_says(table, "speed in  speed out");
  EXPECT_EQ(table.find("beyond the horizon"), table.npos) << table;
}

/// Two bodies below each other, whose cables are hit by turns, ever faster, until both are taut.
const char* const cascade = R"(name = "cascade"
duration = 0.11
gravity = [0.0, -9.81]
[[bodies]]
name = "hook"
mass = 40.0
position = [0.0, -9.45]
[[bodies]]
name = "load"
mass = 400.0
position = [0.0, -11.35]
[[cables]]
from = { body = "hook", at = [0.0, 0.0] }
to = [0.0, 0.0]
length = 9.5
restitution = 0.1
[[cables]]
from = { body = "load", at = [0.0, 0.0] }
to = { body = "hook", at = [0.0, 0.0] }
length = 1.901
restitution = 0.2
)";

// how many impacts each solution sees before it calls both taut is a matter of its digits
TEST(SolveSystems, ACascadeOfImpactsIsNoHorizon) {
  const TemporaryFolder folder;
  const std::string output = solved({folder.file("cascade.toml", cascade).string()});
  expect_says(output, "All these digits are those of a solution in 30 digits, too.");
}

// in double it stands still before 300 s, in 30 digits it does not
TEST(SolveSystems, ComingToRestIsNoHorizon) {
  const TemporaryFolder folder;
  const std::string output =
      solved({folder
                  .file("drag.toml",
                        "name = \"drag\"\ngravity = [0.0, -1.0]\nduration = "
                        "300.0\n[[bodies]]\nmass = 1.0\ndrag = 0.3\n"
                        "position = [0.0, -0.9]\n[[cables]]\nfrom = { body = \"body\" }\n"
                        "to = [0.1, 0.0]\nlength = 1.0\nrestitution = 0.3\n")
                  .string()});
  expect_says(output, "at rest from");
  expect_says(output, "All these digits are those of a solution in 30 digits, too.");
}

TEST(SolveSystems, NoRepetitionIsClaimedThatTheRunCannotShow) {
  expect_says(solved({"bouncer-stable", "--until", "5", "--fast"}),
              "and no repetition is seen in the 2.5 periods of the run.");
}

TEST(SolveSystems, SayWhichCableAsksForTooMuch) {
  const TemporaryFolder folder;
  const std::string held =
      "name = \"held\"\ngravity = [0.0, 0.0]\nduration = 3\n[[bodies]]\nmass = 1\nposition = [0, "
      "0]\n"
      "[[cables]]\nfrom = { body = \"body\" }\nto = [1.0, 0.0]\nlength = 1.0\nrestitution = 0.5\n"
      "[[cables]]\nfrom = { body = \"body\" }\nto = [-1.0, 0.0]\nrestitution = 0.5\n";
  const auto stops = [&](const std::string& cable) {
    std::string output = program({"solve", folder.file("a.toml", held + cable).string()}).output;
    std::replace(output.begin(), output.end(), '\n', ' ');
    return output;
  };
  expect_says(stops("length = { times = [1.0, 2.0], values = [1.0, 0.5] }\n"),
              "Stopped at t = 1.000000: cable 1 asks for more than the bodies on taut cables can "
              "follow.");
  expect_says(stops("length = 0.9\nfrom_time = 2.0\n"),
              "Stopped at t = 2.000000: cable 1 is hooked up there, and too short for where the "
              "ends are.");
}

TEST(SolveSystems, SayThatACableIsPulledIntoItsRing) {
  const TemporaryFolder folder;
  const auto file = folder.file("ring.toml",
                                "name = \"ring\"\ngravity = [0.0, 0.0]\nduration = 3\n"
                                "[[bodies]]\nname = \"a\"\nmass = 1\nposition = [-1, 1]\n"
                                "[[bodies]]\nname = \"b\"\nmass = 3\nposition = [2, 1]\n"
                                "velocity = [1, 0]\n[[cables]]\nfrom = { body = \"a\" }\n"
                                "through = [[0, 1]]\nto = { body = \"b\" }\nlength = 3\n"
                                "restitution = 0\n");
  std::string output = program({"solve", file.string()}).output;
  std::replace(output.begin(), output.end(), '\n', ' ');
  expect_says(output,
              "Stopped at t = 1.333333: an end of cable 0 is at a ring of it, and the cable has no "
              "direction there.");
  EXPECT_EQ(output.find("nan"), std::string::npos) << output;
}

TEST(SolveSystems, SayThatTheEndsOfACableWithoutACutMeet) {
  const TemporaryFolder folder;
  const auto file = folder.file("meet.toml",
                                "name = \"meet\"\ngravity = [0.0, -10.0]\nduration = 3\n"
                                "[[bodies]]\nname = \"a\"\nmass = 1\nposition = [0, 0.8]\n"
                                "[[cables]]\nfrom = { body = \"a\" }\nto = [0, 0]\nlength = 1\n"
                                "stiffness = 100\ndamping = 5\ncut = \"never\"\n");
  std::string output = program({"solve", file.string()}).output;
  std::replace(output.begin(), output.end(), '\n', ' ');
  expect_says(
      output,
      "Stopped at t = 0.589506: the ends of cable 0 have met, and the cable has no direction "
      "there.");
  EXPECT_EQ(output.find("nan"), std::string::npos) << output;
}

/// A ball on a cable through its centre, which swings out of the plane and spins.
const char* const ball_in_space = R"(name = "ball in space"
duration = 6.0
gravity = [0.0, 0.0, -1.0]
[[bodies]]
mass = 1.0
inertia = [0.1, 0.2, 0.25]
position = [0.8, 0.0, -0.6]
velocity = [0.96, 0.3, 1.28]
spin = [0.0, 0.3, 0.4]
[[cables]]
from = { body = "body" }
to = [0.0, 0.0, 0.0]
length = 1.0
restitution = 0.5
)";

// a point that leaves its cable at once; when the cable catches it, and how fast, is the root of a
// polynomial of degree four
TEST(SolveSystems, InSpaceABallIsCaughtWhenItsPolynomialSays) {
  const TemporaryFolder folder;
  const auto file = folder.file("ball.toml", ball_in_space).string();
  const std::string output = solved({file, "--at", "2", "--events"});
  expect_says(output, "ball in space: 1 body, 1 cable");
  expect_says(output, "All these digits are those of a solution in 30 digits, too.");
  expect_says(output, "qw");
  expect_says(output, "wz");
  const std::string table = solved({file, "--every", "0.5", "--csv", "-"});
  expect_says(table, "time,event,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,energy,gap_0");
  const Outcome picture = program({"solve", file, "--plot", "-"});
  EXPECT_EQ(picture.code, 0) << picture.errors;
  expect_says(picture.output, "ball in space");
  expect_says(picture.output, ">front</text>");
}

TEST(SolveSystems, SamplesAreATable) {
  const std::string output = solved({"two-bodies", "--csv", "-", "--at", "0"});
  expect_says(output, "time,event,");
  expect_says(output, ",energy,gap_0,gap_rate_0,tension_0,impulse_0 0,,");
}

TEST(SolveSystems, EachShippedOneComesToItsDurationOrToRest) {
  const auto expect_whole = [](const auto& shipped) {
    for (const auto& one : shipped) {
      const std::string output = solved({one.system.name, "--fast"});
      EXPECT_EQ(output.find("Stopped at"), std::string::npos) << output;
    }
  };
  expect_whole(shipped_systems());
  expect_whole(shipped_spatial_systems());
}

TEST(SolveSystems, WhatIsForCasesAloneIsRefused) {
  for (const char* option : {"--digits=3", "--taut=0", "--angle-limit=1", "--ceiling=1"}) {
    const Outcome outcome = program({"solve", "two-bodies", option});
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_NE(outcome.errors.find("cases alone"), std::string::npos) << option << outcome.errors;
  }
  const Outcome outcome = program({"solve", "bouncing-ball", "--fast"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("--fast: is for systems alone"), std::string::npos);
}

TEST(SolveSystems, AreComparedWithAsManyDigitsAsAreAskedFor) {
  const std::string in_fifty = solved({"winch", "--certify", "--events"});
  expect_says(in_fifty, "All these digits are those of a solution in 50 digits, too.");
  const std::string in_twenty = solved({"winch", "--certify", "--digits", "20", "--events"});
  expect_says(in_twenty, "All these digits are those of a solution in 20 digits, too.");
  const std::string in_thirty = solved({"winch", "--events"});
  const auto table = [](const std::string& output) {
    return output.substr(output.find("event at"));
  };
  EXPECT_EQ(table(in_fifty), table(in_thirty));
  EXPECT_EQ(table(in_twenty), table(in_thirty));
  const Outcome both = program({"solve", "winch", "--certify", "--fast"});
  EXPECT_EQ(both.code, 2);
  EXPECT_NE(both.errors.find("--fast: leaves out the solution in more digits that --certify asks"),
            std::string::npos)
      << both.errors;
  EXPECT_EQ(program({"solve", "winch", "--certify", "--digits", "5"}).code, 2);
}

/// The JSON of `arguments`.
nlohmann::json json_of(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "solve");
  arguments.insert(arguments.end(), {"--json", "-"});
  const Outcome outcome = program(arguments);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  return nlohmann::json::parse(outcome.output);
}

TEST(SolveSystems, JsonIsWhatItsSchemaSays) {
  const auto schema = nlohmann::json::parse(program({"solve", "--schema"}).output);
  const auto of_files = nlohmann::json::parse(program({"schema", "case"}).output);
  std::vector<std::string> all = {"bouncing-ball", "--fast", "--every", "1.7"};
  for (const ShippedSystem& one : shipped_systems()) {
    all.push_back(one.system.name);
  }
  for (const char* const in_space : {"bifilar", "conical", "dzhanibekov", "hoisted-load"}) {
    all.emplace_back(in_space);
  }
  std::vector<nlohmann::json> motions = json_of(all);
  ASSERT_EQ(motions.size(), shipped_systems().size() + 5);
  EXPECT_EQ(motions.front()["schema"], 4);
  EXPECT_EQ(motions.front()["case"]["name"], "bouncing-ball");
  const nlohmann::json checked =
      json_of({"two-bodies", "winch", "spherical-slack", "--at", "0,0.5"});
  motions.insert(motions.end(), checked.begin(), checked.end());
  for (std::size_t index = 1; index < motions.size(); ++index) {
    const auto& motion = motions[index];
    EXPECT_EQ(motion["schema"], 5);
    EXPECT_EQ(broken_rules(motion, schema), "") << motion["system"]["name"];
    EXPECT_EQ(broken_rules(motion["system"], of_files), "") << motion["system"]["name"];
    EXPECT_EQ(motion["digits"].is_null(), index + 3 < motions.size());
  }
  motions.back().erase("horizon");
  EXPECT_NE(broken_rules(motions.back(), schema), "");
}

TEST(SolveSystems, JsonHasTheClosedFormOfTwoBodies) {
  const nlohmann::json motion = json_of({"two-bodies", "--at", "0.05"});
  const auto& impact = motion["events"][0];
  EXPECT_NEAR(impact["time"], 0.1, 1e-15);
  EXPECT_NEAR(impact["impulses"][0], 6.0, 1e-14);
  EXPECT_EQ(impact["before"]["bodies"][0]["name"], "thrown");
  EXPECT_NEAR(impact["before"]["bodies"][0]["velocity"][0], 7.0, 1e-14);
  for (const auto& body : impact["after"]["bodies"]) {
    EXPECT_NEAR(body["velocity"][0], 4.0, 1e-14) << body;
  }
  EXPECT_LT(impact["errors"]["after"]["bodies"][1]["velocity"][0], 1e-14);
  EXPECT_NEAR(motion["energy"]["impacts"], 21.0, 1e-13);
  EXPECT_NEAR(motion["settling"]["cables"][0]["impulse"]["value"]["value"], 6.0, 1e-14);
  EXPECT_TRUE(motion["horizon"].is_null());
  EXPECT_EQ(motion["digits"], 30);
  const auto& sample = motion["samples"][0];
  EXPECT_NEAR(sample["gaps"][0], 0.35, 1e-14);
  EXPECT_NEAR(sample["points"][0][0][0], 0.65, 1e-14);  // of the cable, from the body thrown
  EXPECT_EQ(sample["points"][0][1], nlohmann::json({0.0, 0.0}));
}

TEST(SolveSystems, JsonKnowsWhenACableActs) {
  const nlohmann::json motion = json_of({"tow", "--fast", "--at", "29,31"});
  EXPECT_TRUE(motion["samples"][0]["gaps"][0].is_number());
  EXPECT_TRUE(motion["samples"][1]["gaps"][0].is_null()) << "it is cut at 30 s";
  EXPECT_TRUE(motion["samples"][0]["errors"].is_null());
  EXPECT_TRUE(motion["events"][0]["errors"].is_null());
  EXPECT_EQ(motion["horizon"], 0.0);
}

TEST(SolveSystems, JsonHasThePrintedEvents) {
  for (const char* name : {"winch", "pulley", "chain-of-three"}) {
    const auto events = json_of({name})["events"];
    std::istringstream printed(program({"solve", name, "--events"}).output);
    std::size_t next = 0;
    for (std::string line; std::getline(printed, line);) {
      std::istringstream words(line);
      std::string time;
      std::string kind;
      words >> time >> kind;
      if (time.empty() || std::isdigit(time.front()) == 0 ||
          (kind != "impact" && kind != "taut" && kind != "slack")) {
        continue;
      }
      ASSERT_LT(next, events.size());
      const auto& event = events[next++];
      const auto digits = static_cast<double>(time.size() - time.find('.') - 1);
      EXPECT_NEAR(event["time"], std::stod(time), 0.51 * std::pow(10.0, -digits)) << line;
      EXPECT_EQ(event["kind"], kind);
    }
    EXPECT_EQ(next, events.size()) << name;
    EXPECT_GT(next, 1U) << name;
  }
}

TEST(SolveSystems, ThePictureHasTheNumbersOfTheMotion) {
  for (const char* name : {"winch", "tow", "breakwater-and-ball"}) {
    const nlohmann::json motion = json_of({name, "--fast"});
    const std::string svg = program({"solve", name, "--fast", "--plot", "-"}).output;
    const auto impacts = std::count_if(motion["events"].begin(), motion["events"].end(),
                                       [](const auto& event) { return event["kind"] == "impact"; });
    expect_says(svg, std::to_string(impacts) + (impacts == 1 ? " impact," : " impacts,"));
    std::smatch found;
    ASSERT_TRUE(std::regex_search(
        svg, found, std::regex("largest ([-0-9.e+]+) on cable ([0-9]) at t = ([-0-9.e+]+) s")));
    double largest = 0.0;
    for (const auto& cable : motion["settling"]["cables"]) {
      largest = cable["tension"].is_null()
                    ? largest
                    : std::max(largest, cable["tension"]["value"]["value"].get<double>());
    }
    const auto& peak = motion["settling"]["cables"][std::stoul(found[2])]["tension"];
    EXPECT_EQ(peak["value"]["value"], largest) << name;
    EXPECT_NEAR(std::stod(found[1]), largest, 5.1e-4 * largest) << name;
    EXPECT_NEAR(std::stod(found[3]), peak["time"]["value"], 5.1e-4 * std::stod(found[3])) << name;
  }
}

TEST(SolveSystems, JsonAndPicturesKnowTheHorizon) {
  const nlohmann::json motion = json_of({"breakwater-in-waves", "--until", "30"});
  const double horizon = motion["horizon"];
  EXPECT_GT(horizon, 15.0);
  std::size_t beyond = 0;
  for (const auto& event : motion["events"]) {
    EXPECT_EQ(event["errors"].is_null(), event["time"] > horizon) << event;
    beyond += event["errors"].is_null() ? 1U : 0U;
  }
  EXPECT_GT(beyond, 0U);
  EXPECT_TRUE(motion["energy"]["errors"].is_null());
  std::ostringstream words;
  words << "one of many motions from t = " << horizon << " s on";
  for (const char* picture : {"-", "motion"}) {
    expect_says(
        program({"solve", "breakwater-in-waves", "--until", "30", "--plot", picture}).output,
        words.str());
  }
}

TEST(SolveSystems, FilesTakeWhatTheOutputDoes) {
  const TemporaryFolder folder;
  const std::string base = (folder.path() / "{case}").string();
  const Outcome to_files = program({"solve", "two-bodies", "pulley", "--plot", base + ".svg",
                                    "--plot", "motion=" + base + "-m.svg", "--json", base + ".json",
                                    "--every", "0.25", "--csv", base + ".csv"});
  EXPECT_EQ(to_files.code, 0) << to_files.errors;
  for (const char* name : {"two-bodies", "pulley"}) {
    const std::string stem = (folder.path() / name).string();
    EXPECT_EQ(program({"solve", name, "--plot", "-"}).output, content_of(stem + ".svg"));
    EXPECT_EQ(program({"solve", name, "--plot", "motion"}).output, content_of(stem + "-m.svg"));
    EXPECT_EQ(program({"solve", name, "--every", "0.25", "--json", "-"}).output,
              content_of(stem + ".json"));
    EXPECT_EQ(program({"solve", name, "--every", "0.25", "--csv", "-"}).output,
              content_of(stem + ".csv"));
  }
}

TEST(SolveSystems, SaysThatAFileCannotBeWritten) {
  for (const char* option : {"--json=/dev/full", "--plot=/dev/full", "--csv=/dev/full"}) {
    const Outcome full = program({"solve", "two-bodies", "--fast", "--at", "0", option});
    EXPECT_EQ(full.code, 1) << option;
    EXPECT_NE(full.errors.find("No space left on device"), std::string::npos) << full.errors;
  }
  for (const auto& [option, file] : {std::pair("--plot", "/proc/p.svg"), {"--json", "/proc/p"}}) {
    const Outcome nowhere = program({"solve", "two-bodies", "--fast", option, file});
    EXPECT_EQ(nowhere.code, 1);
    EXPECT_NE(nowhere.errors.find(std::string("cannot write ") + file), std::string::npos)
        << nowhere.errors;
  }
  EXPECT_EQ(program({"solve", "two-bodies", "--plot", "-", "--json", "-"}).code, 2);
  EXPECT_EQ(program({"solve", "two-bodies", "--plot", ""}).code, 2);
  EXPECT_EQ(program({"solve", "two-bodies", "pulley", "--plot", "p.svg"}).code, 2);
  EXPECT_FALSE(std::filesystem::exists("p.svg"));
}

TEST(BridgeOfSystems, JsonIsWhatItsSchemaSays) {
  const Outcome outcome = program({"bridge", "breakwater-and-ball", "--json", "-"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const auto bridge = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(broken_rules_of(bridge, "bridge"), "");
  EXPECT_EQ(bridge.at("case"), "breakwater-and-ball");
  EXPECT_EQ(bridge.at("cables").size(), 3U);
}

}  // namespace
}  // namespace tautline::test
