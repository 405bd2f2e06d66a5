#include "bench/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "bench/base/statistics.hpp"
#include "bench/report/json/json.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

std::string on_one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

/// A report with every kind of row: good, stopped, failed, diverged, an engine that does not
/// answer.
struct Mixed {
  json report;
  std::string markdown;
};
Mixed make_mixed() {
  const TemporaryFolder out;
  const std::string engines = "exact,bullet64," + bad_engine("segfault") + "," + bad_engine("nan") +
                              "," + bad_engine("mute") + "," + bad_engine("no-taut-motion");
  static_cast<void>(
      program({"bench", "bouncing-ball", "breakwater/1510121100", "--engines", engines, "--steps",
               "1e-2,1e-3", "--until", "4", "--out", (out.path() / "r").string()}));
  return {json::parse(content_of(out.path() / "r/report.json"), nullptr, false),
          content_of(out.path() / "r/report.md")};
}
const Mixed& mixed() {
  static const Mixed made = make_mixed();
  return made;
}

TEST(ReportSchema, AcceptsAReportWithEveryKindOfRow) {
  const json& report = mixed().report;
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(broken_rules(report, json::parse(bench::report_schema_json())), "");
  EXPECT_TRUE(report.at("context").at("command").get<std::string>().starts_with(
      std::string(TAUTLINE_PROGRAM_PATH) + " bench bouncing-ball"))
      << report.at("context").at("command");
  std::set<std::string> kinds;
  for (const json& run : report.at("runs")) {
    kinds.insert(run.at("status").get<std::string>());
  }
  EXPECT_EQ(kinds, (std::set<std::string>{"finished", "stopped", "failed", "diverged"}));
}

TEST(ReportSchema, RefusesWhatIsNotAReport) {
  json report = mixed().report;
  ASSERT_TRUE(report.is_object());
  json without = report;
  without.erase("cases");
  EXPECT_NE(broken_rules(without, json::parse(bench::report_schema_json())), "");
  report["runs"][0]["metrics"]["whole_position_error"] = "large";
  EXPECT_NE(broken_rules(report, json::parse(bench::report_schema_json())), "");
}

TEST(ReportSchema, MarkdownSaysEverythingTheJsonSays) {
  const json& report = mixed().report;
  const std::string& markdown = mixed().markdown;
  for (const json& engine : report.at("engines")) {
    EXPECT_NE(markdown.find(engine.at("name").get<std::string>()), std::string::npos);
  }
  for (const json& run : report.at("runs")) {
    if (run.at("status") == "failed") {
      EXPECT_NE(markdown.find(run.at("reason").get<std::string>()), std::string::npos);
    }
  }
  EXPECT_NE(markdown.find("crashed: SIGSEGV"), std::string::npos);
  EXPECT_NE(markdown.find("## How to read this report"), std::string::npos);
}

TEST(Report, ARunThatStopsAtItsFirstTautCableIsNoFailure) {
  const TemporaryFolder out;
  const Outcome outcome = program(
      {"bench", "breakwater/1510121100", "--engines", "exact," + bad_engine("no-taut-motion"),
       "--models", "event,only", "--steps", "1e-2", "--all", "--out", (out.path() / "r").string()});
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  ASSERT_EQ(report.at("runs").size(), 2U);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(report.at("schema"), bench::report_schema);
  const json& exact = report.at("runs").at(0);
  const json& stopped = report.at("runs").at(1);
  EXPECT_EQ(exact.at("status"), "finished");
  EXPECT_EQ(exact.at("details").at("whole").at("covered"), 20.0);
  EXPECT_EQ(stopped.at("status"), "stopped");
  EXPECT_TRUE(stopped.at("reason").get<std::string>().starts_with("a cable is taut"));
  // computed with 60 digits: locked at 1.532917 with this energy and amplitude
  const json& lock = report.at("cases").at(0).at("settling").at("lock");
  EXPECT_NEAR(lock.at("time").get<double>(), 1.532917, 1e-5);
  const json& swing = exact.at("details").at("swing");
  EXPECT_NEAR(swing.at("energy").at("found").get<double>(), 0.030367409, 1e-9);
  // samples 1e-2 apart miss the largest angle by up to 0.82 (1.9 * 5e-3)^2 / 2
  EXPECT_NEAR(swing.at("amplitude").at("found").get<double>(), 0.81987, 5e-5);
  EXPECT_TRUE(stopped.at("details").at("swing").is_null());
  // said once in the report and once on the terminal
  const std::string sentence =
      "1 of 2 runs stopped before the end. This is no failure, and such a run is compared up to "
      "there. Stopped: no-taut-motion only (a cable is taut";
  EXPECT_NE(content_of(out.path() / "r/report.md").find(sentence), std::string::npos);
  EXPECT_NE(on_one_line(outcome.output).find(sentence), std::string::npos) << outcome.output;
}

TEST(Slope, IsTheOrderOfAPowerLaw) {
  const std::vector<double> steps = {1e-1, 1e-2, 1e-3, 1e-4};
  for (const double order : {0.0, 1.0, 2.0, -0.5}) {
    std::vector<double> errors;
    errors.reserve(steps.size());
    for (const double step : steps) {
      errors.push_back(3.0 * std::pow(step, order));
    }
    EXPECT_NEAR(bench::slope(steps, errors), order, 1e-12);
  }
}

}  // namespace
}  // namespace tautline::test
