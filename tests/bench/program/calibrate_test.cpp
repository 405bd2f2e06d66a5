// `tautline calibrate` from outside, on an engine whose restitution is a known function of its
// parameter, and on the engines that are built.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "bench/check/strike.hpp"
#include "tests/bench/run/protocol_support.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// The engine.toml of the child tunable.py.
std::string tunable_engine(const TemporaryFolder& folder) {
  const std::filesystem::path path = folder.path() / "engine.toml";
  std::ofstream(path) << engine_toml(
      "tunable", {"env", "TAUTLINE_PYTHON_KIT=" TAUTLINE_PYTHON_KIT,
                  "TAUTLINE_STARTS=" + (folder.path() / "starts").string(), "python3",
                  children_folder / "tunable.py"});
  return path;
}

Outcome calibrate(const std::string& engine, const std::string& model, const std::string& wanted,
                  const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"calibrate",     engine, "--model", model,
                                        "--restitution", wanted, "--json",  "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return program(arguments);
}

/// Enough for one parameter; each costs a run of python3.
const std::vector<std::string> few_settings = {"--settings", "12"};

/// What the sentences say, one after another.
std::string sentences(const json& found) {
  std::string result;
  for (const json& sentence : found.at("not_reached")) {
    result += sentence.get<std::string>() + "\n";
  }
  return result;
}

TEST(CalibrateStrike, ClosesTheCableAtItsSpeedWhateverTheSpin) {
  constexpr double step = 0.01;   // [s]
  constexpr double phase = 0.25;  // [-]
  constexpr double flight = (5.0 + phase) * step;
  for (const double part : {0.0, 0.5, -0.5}) {
    const bench::Strike strike{0.8, 0.1, 0.01, part};
    const Case the_case = bench::struck_case(strike, 0.7, step, phase);
    State state = the_case.initial;
    EXPECT_GT(gap(the_case.cables[0], state), 0.0) << part;
    state.position += flight * state.velocity;
    state.angle += flight * state.spin;
    EXPECT_NEAR(gap(the_case.cables[0], state), 0.0, 1e-14) << part;
    EXPECT_NEAR(gap_rate(the_case.cables[0], state), -strike.speed, 1e-14) << part;
    EXPECT_NEAR(-state.spin * strike.arm, part * strike.speed, 1e-14) << part;
  }
}

class CalibrateTunable : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_python()) {
      GTEST_SKIP() << no_python;
    }
  }
  TemporaryFolder folder_;
};

TEST_F(CalibrateTunable, FindsTheParameterThatGivesTheRestitution) {
  const Outcome outcome =
      calibrate(tunable_engine(folder_), "tunable", "0.37", {"--tolerance", "0.01"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json found = json::parse(outcome.output);
  const double knob = found.at("parameters").at("knob");
  EXPECT_NEAR(0.9 - knob / 10.0, 0.37, 1e-3);
  EXPECT_LE(found.at("worst").get<double>(), 1e-3);
  EXPECT_TRUE(found.at("reached").get<bool>());
  EXPECT_EQ(broken_rules_of(found, "calibrate"), "");
  EXPECT_NEAR(std::stod(found.at("code").get<std::string>().substr(std::strlen("cable.knob = "))),
              knob, 1e-12);
}

TEST_F(CalibrateTunable, GivesTheSameAnswerTwice) {
  const std::string engine = tunable_engine(folder_);
  const std::vector<std::string> few = {"--settings", "3"};
  EXPECT_EQ(calibrate(engine, "tunable", "0.37", few).output,
            calibrate(engine, "tunable", "0.37", few).output);
}

TEST_F(CalibrateTunable, TellsTheReachWhereTheWishIsBeyondIt) {
  const std::string engine = tunable_engine(folder_);
  const Outcome above = calibrate(engine, "tunable", "0.95", few_settings);
  EXPECT_EQ(above.code, 1) << above.errors;
  EXPECT_EQ(sentences(json::parse(above.output)), "e above 0.8 is not reached at this step\n");
  const Outcome below = calibrate(engine, "tunable", "0", few_settings);
  EXPECT_EQ(below.code, 1) << below.errors;
  EXPECT_EQ(sentences(json::parse(below.output)), "e below 0.1 is not reached at this step\n");
}

TEST_F(CalibrateTunable, TellsTheSpeedsAtWhichItCannotBeHad) {
  const Outcome outcome = calibrate(tunable_engine(folder_), "deaf", "0.5", few_settings);
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  EXPECT_EQ(sentences(json::parse(outcome.output)),
            "e above 0 is not reached at this step at closing speeds of 0.05 to 0.17 m/s\n");
}

TEST_F(CalibrateTunable, SeesAnEngineThatForgetsTheSpin) {
  const Outcome outcome = calibrate(tunable_engine(folder_), "spinless", "0.3", few_settings);
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  const json found = json::parse(outcome.output);
  EXPECT_GT(found.at("worst").get<double>(), 0.1);
  EXPECT_EQ(sentences(found),
            "no one setting suits all closing speeds, arms, inertias and spins\n");
  EXPECT_EQ(broken_rules_of(found, "calibrate"), "");
}

TEST_F(CalibrateTunable, JudgesASettingWithoutASearch) {
  const Outcome outcome = calibrate(tunable_engine(folder_), "tunable", "0.5", {"--fix", "knob=5"});
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  const json found = json::parse(outcome.output);
  EXPECT_EQ(found.at("evaluations").get<int>(), 1);
  EXPECT_NEAR(found.at("worst").get<double>(), 0.1, 1e-9);
  EXPECT_EQ(broken_rules_of(found, "calibrate"), "");
}

TEST_F(CalibrateTunable, GivesTheBestSoFarWhereItIsInterrupted) {
  const Outcome outcome = calibrate(tunable_engine(folder_), "interrupting", "0");
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  const json found = json::parse(outcome.output);
  EXPECT_TRUE(found.at("interrupted").get<bool>());
  EXPECT_LT(found.at("evaluations").get<int>(), 40);
  EXPECT_EQ(sentences(found), "") << "half a search knows no reach";
  EXPECT_EQ(broken_rules_of(found, "calibrate"), "");
}

TEST_F(CalibrateTunable, RefusesWhatItCannotDo) {
  const std::string engine = tunable_engine(folder_);
  const Outcome fixed = calibrate(engine, "fixed", "0.5");
  EXPECT_EQ(fixed.code, 2);
  EXPECT_NE(
      fixed.errors.find("model fixed has no parameter to calibrate; there are some in tunable, "
                        "deaf, spinless and interrupting"),
      std::string::npos)
      << fixed.errors;
  const Outcome knobs = calibrate(engine, "tunable", "0.5", {"--fix", "nob=3,knob"});
  EXPECT_EQ(knobs.code, 2);
  EXPECT_NE(knobs.errors.find("--fix nob: model tunable has no such parameter, but knob"),
            std::string::npos)
      << knobs.errors;
  EXPECT_NE(knobs.errors.find("--fix knob is not NAME=VALUE"), std::string::npos) << knobs.errors;
  const Outcome backwards = calibrate(engine, "tunable", "1.5", {"--speeds", "2..1"});
  EXPECT_EQ(backwards.code, 2);
  EXPECT_NE(backwards.errors.find("--restitution 1.5 is outside [0, 1]"), std::string::npos);
  EXPECT_NE(backwards.errors.find("--speeds 2..1 is no range"), std::string::npos);
}

/// A block of docs/reference/program.md that shows what a command prints.
struct Shown {
  std::vector<std::string> arguments;
  std::string output;
};

std::vector<Shown> documented() {
  std::ifstream file(TAUTLINE_PROGRAM_DOCUMENTATION);
  std::vector<Shown> found;
  const std::string mark = "<!-- output of: tautline ";
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with(mark)) {
      continue;
    }
    Shown shown;
    std::istringstream words(line.substr(mark.size(), line.find(" -->") - mark.size()));
    for (std::string word; words >> word;) {
      shown.arguments.push_back(word);
    }
    std::getline(file, line);  // the fence
    while (std::getline(file, line) && line != "```") {
      shown.output += line + "\n";
    }
    found.push_back(std::move(shown));
  }
  return found;
}

/// The block of an engine, and that the program prints it.
void expect_documented(const std::string& engine, int code) {
  if (!built_engines().contains(engine)) {
    GTEST_SKIP() << engine << " is not built";
  }
  int blocks = 0;
  for (const Shown& shown : documented()) {
    if (shown.arguments[0] == "calibrate" && shown.arguments[1] == engine) {
      const Outcome outcome = program(shown.arguments);
      EXPECT_EQ(outcome.code, code) << outcome.errors;
      EXPECT_EQ(outcome.output, shown.output) << "scripts/update-readme writes it anew";
      ++blocks;
    }
  }
  EXPECT_EQ(blocks, 1) << "of " << engine << " in docs/reference/program.md";
}

// exit code 0: within the tolerance of the command
TEST(CalibrateEngines, TheTendonLimitOfMujocoIsWithinFiveThousandthsAsDocumented) {
  expect_documented("mujoco", 0);
}

/// What an engine says of its cable, with parameters that are all fixed.
json law_of(const std::string& engine, const std::string& model, const std::string& fixed) {
  const Outcome outcome =
      calibrate(engine, model, "0.5", {"--fix", fixed, "--speeds", "1..2", "--step", "1e-4"});
  const json found = json::parse(outcome.output);
  EXPECT_EQ(broken_rules_of(found, "calibrate"), "");
  return found.value("law", json());
}

TEST(CalibrateEngines, TellASpringAndADamperWithTheirRestitution) {
  if (!built_engines().contains("mujoco")) {
    GTEST_SKIP() << "mujoco is not built";
  }
  const json law = law_of("mujoco", "tendon-limit", "stiffness=1e4,damping=60");
  EXPECT_EQ(law.at("stiffness").get<double>(), 1e4);
  EXPECT_EQ(law.at("damping").get<double>(), 60.0);
  EXPECT_EQ(law.at("load").get<double>(), 0.9999);
  EXPECT_NEAR(law.at("damping_ratio").get<double>(), 0.3, 1e-15);
  // exp(-2 ratio acos(ratio) / sqrt(1 - ratio^2)), as in docs/snap.md
  EXPECT_NEAR(law.at("restitution").get<double>(), 0.4509754529, 1e-10);
}

TEST(CalibrateEngines, TellNoLawOfACableThatIsNoSpring) {
  if (!built_engines().contains("ode")) {
    GTEST_SKIP() << "ode is not built";
  }
  EXPECT_TRUE(law_of("ode", "contact", "bounce=0.5,bounce-vel=0.01").is_null());
}

TEST(CalibrateEngines, TheContactOfBulletCannotBeHadBelowItsThresholdAsDocumented) {
  expect_documented("bullet64", 1);
}

TEST(CalibrateEngines, TheSurfaceOfOdeNeedsNoSpeedToBounce) {
  if (!built_engines().contains("ode")) {
    GTEST_SKIP() << "ode is not built";
  }
  const Outcome outcome = calibrate("ode", "contact", "0.4", {"--tolerance", "0.01"});
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
  const json found = json::parse(outcome.output);
  EXPECT_NEAR(found.at("parameters").at("bounce").get<double>(), 0.4, 1e-3);
  EXPECT_LT(found.at("parameters").at("bounce-vel").get<double>(), 0.05) << "the slowest strike";
}

#ifdef TAUTLINE_NPM_ENGINES
TEST(CalibrateEngines, TheLimitOfJoltTellsItsSpring) {
  const std::filesystem::path jolt = std::filesystem::path(TAUTLINE_NPM_ENGINES) / "jolt";
  const json law = law_of(jolt / "engine.toml", "distance", "damping=0.3,frequency=10");
  EXPECT_NEAR(law.at("stiffness").get<double>(), std::pow(20.0 * std::numbers::pi, 2), 1e-9);
  EXPECT_NEAR(law.at("damping_ratio").get<double>(), 0.3, 1e-15);
  EXPECT_EQ(law.at("load").get<double>(), 0.0);
}

/// The mean error of a model of an engine on npm with parameters that are all fixed.
double mean_error(const std::filesystem::path& engine, const std::string& fixed) {
  const Outcome outcome = calibrate(engine, "distance", "1", {"--fix", fixed});
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  return json::parse(outcome.output).at("mean").get<double>();
}

TEST(CalibrateEngines, TheParametersOfTheEnginesOnNpmReachThem) {
  const std::array<std::string, 3> settings[] = {
      {"p2", "relaxation=2,stiffness=10000", "relaxation=20,stiffness=10000"},
      {"jolt", "damping=0,frequency=10", "damping=1,frequency=10"}};
  for (const auto& [engine, one, other] : settings) {
    const std::filesystem::path folder = std::filesystem::path(TAUTLINE_NPM_ENGINES) / engine;
    const double difference =
        mean_error(folder / "engine.toml", one) - mean_error(folder / "engine.toml", other);
    EXPECT_GT(std::abs(difference), 0.05) << engine;
  }
}
#endif

}  // namespace
}  // namespace tautline::test
