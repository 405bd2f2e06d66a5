#include <gtest/gtest.h>

#include <algorithm>

#include "tautline/scenarios.hpp"
#include "tests/bench/program.hpp"

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

TEST(SolveSystems, FastSaysThatNothingIsChecked) {
  expect_says(solved({"two-bodies", "--fast"}), "These digits are not checked");
}

TEST(SolveSystems, SamplesAreATable) {
  const std::string output = solved({"two-bodies", "--csv", "-", "--at", "0"});
  expect_says(output, "time,event,");
  expect_says(output, ",energy,gap_0,gap_rate_0,tension_0,impulse_0 0,,");
}

TEST(SolveSystems, EachShippedOneComesToItsDurationOrToRest) {
  for (const ShippedSystem& one : shipped_systems()) {
    const std::string output = solved({one.system.name, "--fast"});
    EXPECT_EQ(output.find("Stopped at"), std::string::npos) << output;
  }
}

TEST(SolveSystems, WhatIsForCasesAloneIsRefused) {
  for (const char* option : {"--certify", "--digits=3", "--json=-", "--plot=-", "--taut=0",
                             "--angle-limit=1", "--ceiling=1"}) {
    const Outcome outcome = program({"solve", "two-bodies", option});
    EXPECT_EQ(outcome.code, 2) << option;
    EXPECT_NE(outcome.errors.find("is for cases alone, not for systems"), std::string::npos)
        << option << outcome.errors;
  }
  const Outcome outcome = program({"solve", "bouncing-ball", "--fast"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("--fast: is for systems alone"), std::string::npos);
}

}  // namespace
}  // namespace tautline::test
