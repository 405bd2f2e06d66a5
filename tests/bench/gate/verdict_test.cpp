// The limits file, the verdicts drawn from it, and the gate, all as the program has them. What
// follows from a report alone is tested in judging_test.cpp.

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "bench/gate/limits.hpp"
#include "bench/gate/verdict.hpp"
#include "bench/measure/metric_list.hpp"
#include "bench/suite/suites.hpp"
#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

std::string limits_text(const std::string& more) { return "schema = 1\nversion = \"1\"\n" + more; }

/// A limit on every run; `limit` [-] on the restitution error.
std::string restitution_limit(const std::string& limit) {
  return "[[limits]]\nengine = \"*\"\nmodel = \"*\"\nmetric = \"restitution_error\"\nlimit = " +
         limit + "\nunit = \"1\"\nreason = \"the cable's own\"\n";
}

std::string known(const std::string& engine, const std::string& metric) {
  return "[[known]]\nengine = \"" + engine + "\"\nmodel = \"*\"\nmetric = \"" + metric +
         "\"\nreason = \"made to\"\n";
}

/// What the bench says of one engine on the bouncing ball, gated by `limits`.
struct Gated {
  Outcome outcome;
  json report;
};
Gated gated(const std::string& engine, const std::string& limits) {
  const TemporaryFolder out;
  const auto file = out.file("limits.toml", limits);
  Gated result;
  result.outcome = program({"bench", "bouncing-ball", "--engines", engine, "--steps", "1e-3",
                            "--gate", file.string(), "--out", (out.path() / "r").string()});
  const auto report = out.path() / "r/report.json";
  if (std::filesystem::exists(report)) {
    result.report = json::parse(content_of(report));
  }
  return result;
}

TEST(Limits, EveryMistakeOfAFileIsNamedWithLineKeyValueAndWhatWouldBeRight) {
  const std::string text =
      "schema = 2\n"
      "version = \"\"\n"
      "[[limits]]\n"
      "engine = 3\n"
      "model = \"*\"\n"
      "metric = \"restitution_eror\"\n"
      "limit = -1.0\n"
      "unit = \"m\"\n"
      "reason = \"r\"\n"
      "[[limits]]\n"
      "engine = \"*\"\n"
      "model = \"*\"\n"
      "metric = \"overstretch\"\n"
      "limit = nan\n"
      "unit = \"mm\"\n"
      "step = 0.0\n"
      "precision = \"double\"\n"
      "[[knwon]]\n";
  const auto reading = bench::read_limits_text(text, "l.toml");
  EXPECT_FALSE(reading.limits);
  std::string all;
  for (const std::string& sentence : reading.problems) {
    all += sentence + "\n";
  }
  for (const char* part :
       {"l.toml:1: schema = 2: must be 1", "l.toml:2: version",
        "l.toml:4: limits[0].engine = 3: is an integer",
        "l.toml:6: limits[0].metric = \"restitution_eror\": must be",
        "did you mean restitution_error", "l.toml:7: limits[0].limit = -1: must be",
        "l.toml:14: limits[1].limit = nan: must be",
        "l.toml:15: limits[1].unit = \"mm\": must be m", "l.toml:16: limits[1].step = 0: must be",
        "limits[1].reason: is missing", "l.toml:17: limits[1].precision", "l.toml:18: knwon"}) {
    EXPECT_NE(all.find(part), std::string::npos) << part << "\n" << all;
  }
}

TEST(Limits, EveryNumberHasItsRange) {
  for (const auto& [key, wrong] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"limit", {"nan", "inf", "-1", "1e300"}},
           {"per_step", {"nan", "inf", "-1", "1e300"}},
           {"over_step", {"nan", "inf", "-1", "1e300"}},
           {"step", {"nan", "inf", "-1", "0"}}}) {
    for (const std::string& value : wrong) {
      const std::string text =
          "schema = 1\nversion = \"1\"\n[[limits]]\nengine = \"*\"\nmodel = \"*\"\n"
          "metric = \"overstretch\"\nunit = \"m\"\nreason = \"r\"\n" +
          std::string(key == "limit" ? "" : "limit = 1\n") + key + " = " + value + "\n";
      const bench::LimitsReading reading = bench::read_limits_text(text, "l.toml");
      EXPECT_FALSE(reading.limits) << text;
      ASSERT_EQ(reading.problems.size(), 1U) << text;
      EXPECT_NE(reading.problems[0].find("limits[0]." + key + " = "), std::string::npos)
          << reading.problems[0];
    }
  }
}

TEST(Limits, AnEntryOfEachHasWhatTheTableAroundItSaysAndItDoesNot) {
  const std::string head =
      "schema = 1\nversion = \"1\"\n[[limits]]\nmodel = \"row\"\nunit = \"m\"\n";
  const bench::LimitsReading good = bench::read_limits_text(
      head +
          "reason = \"r\"\neach = [\n"
          "  {engine = \"e\", metric = \"overstretch\", limit = 0.5},\n"
          "  {engine = \"f\", metric = \"early_position_error\", limit = 2, "
          "reason = \"own\"},\n]\n",
      "l.toml");
  ASSERT_TRUE(good.limits) << good.problems.front();
  ASSERT_EQ(good.limits->limits.size(), 2U);
  const bench::Limit& first = good.limits->limits.front();
  const bench::Limit& second = good.limits->limits.back();
  EXPECT_EQ(first.runs.engine + " " + first.runs.model + " " + first.reason, "e row r");
  EXPECT_EQ(second.runs.engine + " " + second.runs.model + " " + second.reason, "f row own");
  EXPECT_EQ(first.constant, 0.5);
  EXPECT_EQ(second.metric, "early_position_error");

  const bench::LimitsReading bad = bench::read_limits_text(
      head +
          "engin = \"*\"\neach = [\n"
          "  {engine = \"e\", metric = \"energy_gain\", limit = 0.5, reason = \"r\"},\n"
          "  {engine = \"e\", metric = \"overstretch\", limit = 0.5, raeson = \"r\"},\n]\n",
      "l.toml");
  EXPECT_EQ(
      bad.problems,
      (std::vector<std::string>{
          "l.toml:5: limits[0].unit = \"m\": must be J",
          "l.toml:6: limits[0].engin = \"*\": unknown key; did you mean engine?",
          "l.toml:9: limits[0].each[1].reason: is missing, must be a string that is not empty",
          "l.toml:9: limits[0].each[1].raeson = \"r\": unknown key; did you mean reason?"}));
}

TEST(Limits, ABadFileEndsTheBenchBeforeItStarts) {
  const Gated bad = gated("exact", "schema = 1\n");
  EXPECT_EQ(bad.outcome.code, 2);
  EXPECT_NE(bad.outcome.errors.find("limits.toml: version: is missing"), std::string::npos)
      << bad.outcome.errors;
  EXPECT_TRUE(bad.report.is_null());
  const Outcome none = program({"bench", "bouncing-ball", "--gate", "/no/such/limits.toml"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.errors.find("no such file"), std::string::npos) << none.errors;
}

TEST(Limits, WhatShipsIsSoundAndIsOnEveryModelThatIsBuilt) {
  const bench::Limits limits = bench::shipped_limits();
  EXPECT_GE(limits.limits.size(), 20U);
  const TemporaryFolder out;
  const Outcome outcome =
      program({"bench", "breakwater/1710121100", "level-beam", "--until", "2", "--steps",
               "1e-2,1e-3", "--gate", TAUTLINE_LIMITS, "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
  EXPECT_NE(outcome.output.find("The gate holds ("), std::string::npos) << outcome.output;
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  for (const json& run : report.at("runs")) {
    EXPECT_FALSE(run.at("verdict").at("checks").empty()) << run.at("engine") << run.at("model");
  }
}

/// The quick suite as the engines that are built would run it: no run breaks anything.
bench::Report sound_quick_suite() {
  const json listed = json::parse(program({"engines", "--json", "-"}).output);
  const bench::Suite& quick = *bench::find_suite("quick");
  bench::Report report;
  for (const json& engine : listed.at("engines")) {
    if (!engine.contains("models") || !engine.contains("precision")) {
      continue;  // not built
    }
    const std::string name = engine.at("name");
    bench::EngineRow row;
    row.name = name;
    row.info = EngineInfo{name, "1", engine.at("precision"), {}};
    report.engines.push_back(row);
    for (const json& model : engine.at("models")) {
      for (const std::string& the_case : bench::cases_of(quick)) {
        for (const double step : quick.steps) {
          bench::RunRow run;
          run.key = {the_case, name, model.at("name").get<std::string>(), step};
          run.metrics = bench::MetricValues(bench::metric_list().size(), 0.0);
          report.runs.push_back(run);
        }
      }
    }
  }
  return report;
}

TEST(Limits, JudgeAtLeastFourFifthsOfTheQuickSuiteOfEveryEngineThatIsBuilt) {
  bench::Report report = sound_quick_suite();
  bench::add_verdicts(report, bench::shipped_limits());
  std::map<std::string, int> runs;
  std::map<std::string, int> not_judged;
  for (const bench::RunRow& run : report.runs) {
    ++runs[run.key.engine];
    not_judged[run.key.engine] += run.verdict->word == bench::Word::not_judged ? 1 : 0;
  }
  ASSERT_TRUE(runs.contains("exact"));
  for (const auto& [engine, count] : runs) {
    EXPECT_LE(5 * not_judged[engine], count) << engine;
  }
}

TEST(Limits, TheControlPassesOnEveryCaseOfTheQuickSuite) {
  const TemporaryFolder out;
  const Outcome outcome =
      program({"bench", "--suite", "quick", "--no-certify", "--engines", "exact", "--gate",
               TAUTLINE_LIMITS, "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  EXPECT_EQ(report.at("runs").size(), 24U);
  for (const json& run : report.at("runs")) {
    EXPECT_EQ(run.at("verdict").at("word"), "pass")
        << run.at("case") << run.at("model") << run.at("step");
  }
}

TEST(Verdict, WithoutAGateTheLimitsThatShipAreShownAndTheCodeIsAsEver) {
  const TemporaryFolder out;
  const Outcome outcome = program({"bench", "breakwater/1710121100", "--until", "2", "--engines",
                                   bad_engine("no-restitution"), "--steps", "1e-3", "--out",
                                   (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  EXPECT_EQ(report.at("runs").at(0).at("verdict").at("word"), "breaks a limit");
  EXPECT_EQ(report.at("limits"), json({{"file", "limits.toml, built in"}, {"version", "3"}}));
  EXPECT_NE(outcome.output.find("breaks a limit"), std::string::npos) << outcome.output;
}

TEST(Gate, ASoundEnginePassesAndEachPlantedErrorBreaksIt) {
  const std::string limits = limits_text(restitution_limit("1e-3"));
  const Gated sound = gated(bad_engine("sound"), limits);
  EXPECT_EQ(sound.outcome.code, 0) << sound.outcome.output;
  EXPECT_EQ(sound.report.at("runs").at(0).at("verdict").at("word"), "pass");
  for (const char* flaw : {"no-restitution", "twice", "threshold", "bouncy"}) {
    const Gated flawed = gated(bad_engine(flaw), limits);
    EXPECT_EQ(flawed.outcome.code, 1) << flaw << flawed.outcome.output;
    // engine, model, case, step, metric, value, limit, reason
    const std::string& text = flawed.outcome.output;
    const std::size_t row = text.rfind(std::string(flaw) + "  ", text.rfind("restitution_error"));
    ASSERT_NE(row, std::string::npos) << text;
    const std::string line = text.substr(row, text.find('\n', row) - row);
    for (const char* part :
         {"row", "bouncing-ball", "0.001", "restitution_error", "the cable's own"}) {
      EXPECT_NE(line.find(part), std::string::npos) << part << "\n" << line;
    }
    EXPECT_NE(text.find("The gate is broken by 1 row ("), std::string::npos) << text;
  }
}

TEST(Gate, AKnownDeviationPassesAndOneThatHasStartedToHoldDoesNot) {
  const std::string limits =
      limits_text(restitution_limit("1e-3") + known("bouncy", "restitution_error"));
  const Gated flawed = gated(bad_engine("bouncy"), limits);
  EXPECT_EQ(flawed.outcome.code, 0) << flawed.outcome.output;
  const json& verdict = flawed.report.at("runs").at(0).at("verdict");
  EXPECT_EQ(verdict.at("word"), "known deviation");
  EXPECT_EQ(verdict.at("checks").at(0).at("known"), true);
  const Gated mended = gated(bad_engine("sound"), limits_text(restitution_limit("1e-3") +
                                                              known("sound", "restitution_error")));
  EXPECT_EQ(mended.outcome.code, 1) << mended.outcome.output;
  EXPECT_NE(mended.outcome.output.find("has started to hold"), std::string::npos);
  // an engine that is not in the report cannot start to hold
  EXPECT_EQ(gated(bad_engine("sound"), limits).outcome.code, 0);
}

TEST(Gate, TheLimitsThatShipTellPlantedErrorsFromASoundEngine) {
  std::string engines = bad_engine("sound");
  const std::vector<std::string> flaws = {"no-restitution", "twice",     "threshold",   "bouncy",
                                          "wrong-inertia",  "wrong-arm", "energy-gain", "drift"};
  // steps of 1e-2 turn the body by as much as a wrong inertia, and few early bounces are slow
  const std::set<std::string> too_small_at_long_steps = {"threshold", "wrong-inertia"};
  for (const std::string& flaw : flaws) {
    engines += "," + bad_engine(flaw);
  }
  const TemporaryFolder out;
  const Outcome outcome =
      program({"bench", "breakwater/1910121100", "--engines", engines, "--steps", "1e-2,1e-3",
               "--gate", TAUTLINE_LIMITS, "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 1);
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  ASSERT_EQ(report.at("runs").size(), 2 * (1 + flaws.size()));
  for (const json& run : report.at("runs")) {
    if (run.at("step") == 1e-2 && too_small_at_long_steps.contains(run.at("engine"))) {
      continue;
    }
    EXPECT_EQ(run.at("verdict").at("word"), run.at("engine") == "sound" ? "pass" : "breaks a limit")
        << run.at("engine") << run.at("step");
  }
}

TEST(Gate, ARunThatDivergesBreaksItUnlessThatIsKnown) {
  const std::string limits = limits_text(restitution_limit("1e-3"));
  const Gated diverged = gated(bad_engine("nan"), limits);
  EXPECT_EQ(diverged.outcome.code, 1);
  EXPECT_EQ(diverged.report.at("runs").at(0).at("verdict").at("checks").at(0).at("metric"),
            "failure");
  EXPECT_EQ(gated(bad_engine("nan"), limits + known("nan", "failure")).outcome.code, 0);
  EXPECT_EQ(gated(bad_engine("sound"), limits + known("sound", "failure")).outcome.code, 1);
}

TEST(Verdict, ModelsMayBeNotJudgedAndSoIsOneThatStopsOnTautCables) {
  const std::string flags =
      "[[not_judged]]\nengine = \"bouncy\"\nmodel = \"row\"\nreason = \"r\"\n";
  const Gated told = gated(bad_engine("bouncy") + "," + bad_engine("sound"),
                           limits_text(restitution_limit("1e-3") + flags));
  EXPECT_EQ(told.outcome.code, 0) << told.outcome.output;
  for (const json& run : told.report.at("runs")) {
    EXPECT_EQ(run.at("verdict").at("word"), run.at("engine") == "bouncy" ? "not judged" : "pass");
  }
  const TemporaryFolder out;
  static_cast<void>(
      program({"bench", "breakwater/1510121100", "--engines", bad_engine("no-taut-motion"),
               "--steps", "1e-2", "--out", (out.path() / "r").string()}));
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  EXPECT_EQ(report.at("runs").at(0).at("status"), "stopped");
  const std::string word = report.at("runs").at(0).at("verdict").at("word");
  EXPECT_TRUE(word == "not judged" || word == "breaks a limit") << word;
}

TEST(TerminalSummary, FitsAHundredColumnsAndHasNoColourInAPipe) {
  const TemporaryFolder out;
  const Outcome outcome = program({"bench", "bouncing-ball", "--engines", "exact", "--steps",
                                   "1e-2,1e-3", "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.output.find('\033'), std::string::npos);
  std::istringstream lines(outcome.output.substr(0, outcome.output.rfind(" runs in ")));
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100U) << line;
  }
}

}  // namespace
}  // namespace tautline::test
