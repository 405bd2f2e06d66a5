// Two reports side by side: what changed beyond noise, and what is not a report.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::ordered_json;

/// A report of a sound engine, made once.
const ordered_json& sound() {
  static const ordered_json report = [] {
    const TemporaryFolder out;
    static_cast<void>(program({"bench", "bouncing-ball", "breakwater/1910121100", "--engines",
                               "exact," + bad_engine("sound"), "--steps", "1e-2,1e-3", "--out",
                               (out.path() / "r").string()}));
    return ordered_json::parse(content_of(out.path() / "r/report.json"));
  }();
  return report;
}

/// The metrics of the sound engine's run of the breakwater at 1e-3 in `report`.
ordered_json& metrics_of(ordered_json& report) {
  for (ordered_json& run : report.at("runs")) {
    if (run.at("engine") == "sound" && run.at("case") == "breakwater/1910121100" &&
        run.at("step") == 1e-3) {
      return run.at("metrics");
    }
  }
  throw std::logic_error("the report lacks the run");
}

struct Compared {
  Outcome outcome;
  ordered_json changes;
};
Compared compared(const std::string& before, const std::string& after) {
  const TemporaryFolder folder;
  const auto one = folder.file("a.json", before);
  const auto two = folder.file("b.json", after);
  const auto file = folder.path() / "c.json";
  Compared result{program({"compare", one, two, "--json", file.string()}), nullptr};
  if (std::filesystem::exists(file)) {
    result.changes = ordered_json::parse(content_of(file));
  }
  return result;
}

TEST(Compare, AReportIsTheSameAsItself) {
  const Compared same = compared(sound().dump(), sound().dump());
  EXPECT_EQ(same.outcome.code, 0) << same.outcome.output << same.outcome.errors;
  EXPECT_NE(same.outcome.output.find("nothing changed beyond noise"), std::string::npos);
  EXPECT_EQ(same.changes.at("compared"), sound().at("runs").size());
  EXPECT_TRUE(keeps_the_schema(same.changes, "compare"));
}

TEST(Compare, SaysWhatGotWorseAndWhatGotBetterByTheirSign) {
  ordered_json after = sound();
  ordered_json& error = metrics_of(after).at("early_position_error");
  error = 3.0 * error.get<double>();
  const Compared worse = compared(sound().dump(), after.dump());
  EXPECT_EQ(worse.outcome.code, 1);
  ASSERT_EQ(worse.changes.at("got_worse").size(), 1U);
  EXPECT_EQ(worse.changes.at("got_worse").at(0).at("metric"), "early_position_error");
  EXPECT_EQ(worse.changes.at("got_worse").at(0).at("step"), 1e-3);
  EXPECT_TRUE(keeps_the_schema(worse.changes, "compare"));
  EXPECT_EQ(worse.outcome.output.find("winner"), std::string::npos);
  const Compared better = compared(after.dump(), sound().dump());
  EXPECT_EQ(better.outcome.code, 0) << better.outcome.output;
  EXPECT_EQ(better.changes.at("got_better").size(), 1U);
}

TEST(Compare, RoundingAndWhatChaosMakesOfItAreNoise) {
  ordered_json after = sound();
  ordered_json& metrics = metrics_of(after);
  const auto times = [](ordered_json& value, double factor) {
    value = factor * value.get<double>();
  };
  times(metrics.at("early_position_error"), 1.0 + 1e-9);
  times(metrics.at("overstretch"), 1.2);             // an extreme beyond the horizon
  times(metrics.at("whole_position_error"), 100.0);  // beyond it, and no extreme
  metrics.at("horizon_position_error") = metrics.at("horizon_position_error").get<double>() + 1e-5;
  const Compared noise = compared(sound().dump(), after.dump());
  EXPECT_EQ(noise.outcome.code, 0) << noise.outcome.output;
  times(metrics.at("overstretch"), 10.0);
  EXPECT_EQ(compared(sound().dump(), after.dump()).outcome.code, 1);
}

TEST(Compare, NewFailuresComeFirstAndRunsThatAreGoneAreNamed) {
  ordered_json after = sound();
  after.at("runs").at(1).at("status") = "failed";
  after.at("runs").at(1).at("reason") = "crashed: SIGSEGV";
  after.at("runs").at(1).at("metrics") = nullptr;
  after.at("runs").at(1).at("details") = nullptr;
  after.at("runs").erase(0);
  after.at("engines").at(1).at("version") = "2";
  const Compared broken = compared(sound().dump(), after.dump());
  EXPECT_EQ(broken.outcome.code, 1);
  EXPECT_EQ(broken.changes.at("new_failures").size(), 1U);
  EXPECT_EQ(broken.changes.at("only_before").size(), 1U);
  EXPECT_EQ(broken.changes.at("versions").at(0).at("after"), "2");
  EXPECT_NE(broken.outcome.output.find("crashed: SIGSEGV"), std::string::npos);
  const Compared mended = compared(after.dump(), sound().dump());
  EXPECT_EQ(mended.outcome.code, 0) << mended.outcome.output;
  EXPECT_EQ(mended.changes.at("recovered").size(), 1U);
  EXPECT_EQ(mended.changes.at("only_after").size(), 1U);
  EXPECT_TRUE(keeps_the_schema(mended.changes, "compare"));
}

TEST(Compare, ACaseThatHasChangedUnderItsNameIsNotCompared) {
  const std::vector<std::pair<const char*, double>> changes = {
      {"/body/inertia", 0.02},          {"/gravity/1", -1.1},
      {"/geometry/0/length", 1.4},      {"/geometry/0/restitution", 0.8},
      {"/geometry/0/attachment/1", .1}, {"/path/x/start", 0.3}};
  for (const auto& [place, value] : changes) {
    ordered_json after = sound();
    for (ordered_json& the_case : after.at("cases")) {
      if (the_case.at("name") == "breakwater/1910121100") {
        the_case.at(ordered_json::json_pointer(place)) = value;
      }
    }
    metrics_of(after).at("overstretch") = 1.0;
    const Compared other = compared(sound().dump(), after.dump());
    EXPECT_EQ(other.outcome.code, 0) << place << other.outcome.output;
    EXPECT_EQ(other.changes.at("other_case").size(), sound().at("runs").size() / 2) << place;
  }
}

TEST(Compare, ReportsWithoutARunInCommonAreRefused) {
  ordered_json renamed = sound();
  ordered_json changed = sound();
  for (ordered_json& run : renamed.at("runs")) {
    run.at("model") = run.at("model").get<std::string>() + "-2";
  }
  for (ordered_json& the_case : changed.at("cases")) {
    the_case.at("gravity").at(0) = 0.5;
  }
  for (const ordered_json* after : {&renamed, &changed}) {
    const Compared nothing = compared(sound().dump(), after->dump());
    EXPECT_EQ(nothing.outcome.code, 2) << nothing.outcome.output;
    EXPECT_NE(nothing.outcome.errors.find("no run is in both reports"), std::string::npos)
        << nothing.outcome.errors;
  }
}

TEST(Compare, MoreThanTwoReportsAreATrendByVersion) {
  ordered_json after = sound();
  for (ordered_json& engine : after.at("engines")) {
    engine.at("version") = "of tomorrow";
  }
  ordered_json& error = metrics_of(after).at("early_position_error");
  error = 3.0 * error.get<double>();
  const TemporaryFolder folder;
  const std::string one = folder.file("a.json", sound().dump());
  const std::string two = folder.file("b.json", after.dump());
  const std::string file_of_trend = (folder.path() / "trend.json").string();
  const Outcome outcome = program({"compare", one, one, two, "--json", file_of_trend});
  EXPECT_EQ(outcome.code, 1) << "the last is worse" << outcome.errors;
  EXPECT_NE(outcome.output.find("of tomorrow"), std::string::npos) << outcome.output;
  const ordered_json trend = ordered_json::parse(content_of(file_of_trend));
  EXPECT_TRUE(keeps_the_schema(trend, "compare"));
  std::size_t moved = 0;
  for (const ordered_json& row : trend.at("rows")) {
    ASSERT_EQ(row.at("points").size(), 3U);
    if (row.at("points").at(2).at("worse") == 1) {
      ++moved;
      EXPECT_EQ(row.at("engine"), "sound");
      EXPECT_EQ(row.at("metric"), "early_position_error");
      EXPECT_EQ(row.at("points").at(2).at("version"), "of tomorrow");
    }
  }
  EXPECT_EQ(moved, 1U);
  EXPECT_EQ(program({"compare", one, two, one}).code, 0) << "the last is better";
  EXPECT_EQ(program({"compare", one}).code, 2);
}

TEST(Compare, ATrendCountsTheRunsThatAreGone) {
  ordered_json after = sound();
  after.at("runs").erase(after.at("runs").size() - 1);
  const TemporaryFolder folder;
  const std::string one = folder.file("a.json", sound().dump());
  const std::string two = folder.file("b.json", after.dump());
  const Outcome outcome = program({"compare", one, one, two});
  EXPECT_EQ(outcome.code, 1) << outcome.errors;
  EXPECT_NE(outcome.output.find("Runs that are gone (1)"), std::string::npos) << outcome.output;
  std::string flat = outcome.output;
  std::replace(flat.begin(), flat.end(), '\n', ' ');
  EXPECT_NE(flat.find("1 change for the worse (1 of them runs that are gone)"), std::string::npos)
      << outcome.output;
}

TEST(Compare, AToleranceIsGivenAsAShare) {
  ordered_json after = sound();
  ordered_json& error = metrics_of(after).at("early_position_error");
  error = 1.5 * error.get<double>();
  const TemporaryFolder folder;
  const std::string one = folder.file("a.json", sound().dump());
  const std::string two = folder.file("b.json", after.dump());
  EXPECT_EQ(program({"compare", one, two}).code, 1);
  EXPECT_EQ(program({"compare", one, two, "--tolerance", "0.5"}).code, 0);
  for (const std::string wrong : {"-0.1", "1", "nan"}) {
    const Outcome refused = program({"compare", one, two, "--tolerance=" + wrong});
    EXPECT_EQ(refused.code, 2) << wrong;
    EXPECT_NE(refused.errors.find("must be at least 0 and below 1"), std::string::npos)
        << refused.errors;
  }
}

TEST(Compare, CostsAreOnlySaidWhenFarApartAndJudgeNothing) {
  ordered_json after = sound();
  for (ordered_json& row : after.at("context").at("timing")) {
    row.at("cost_ratio") = 1.5 * row.at("cost_ratio").get<double>();
  }
  EXPECT_TRUE(compared(sound().dump(), after.dump()).changes.at("costs").empty());
  for (ordered_json& row : after.at("context").at("timing")) {
    row.at("cost_ratio") = 2.0 * row.at("cost_ratio").get<double>();
  }
  const Compared slower = compared(sound().dump(), after.dump());
  EXPECT_EQ(slower.outcome.code, 0);
  EXPECT_FALSE(slower.changes.at("costs").empty());
  EXPECT_NE(slower.outcome.output.find("noisy"), std::string::npos);
}

TEST(Compare, WhatIsNoReportIsRefusedInASentence) {
  const std::string good = sound().dump();
  ordered_json old = sound();
  old.at("schema") = 2;
  ordered_json twice = sound();
  twice.at("runs").push_back(twice.at("runs").at(0));
  ordered_json bare = sound();
  bare.at("runs").at(0).erase("metrics");
  ordered_json law = sound();
  law.at("options").at("law") = "poisson";
  ordered_json stranger = sound();
  stranger.at("engines").clear();
  ordered_json stepless = sound();
  stepless.at("runs").at(0).at("step") = nullptr;
  ordered_json endless = sound();
  endless.at("cases").at(0).at("horizon") = nullptr;
  struct Bad {
    std::string text;
    const char* sentence;
  };
  const std::vector<Bad> all = {
      {"", "it ends too early"},
      {good.substr(0, good.size() / 2), "ends too early"},
      {"{\"schema\": NaN}", "is not JSON"},
      {"{\"schema\": 1e999}", "is not a report"},
      {"[]", "is not a report of `tautline bench`"},
      {"{\"schema\": 6}", "is not a report of `tautline bench`"},
      {"{\"schema\": 6, \"runs\": 1, \"options\": 2, \"context\": 3}", "is not a"},
      {old.dump(), "has schema 2, must be 6"},
      {twice.dump(), "has two rows of"},
      {bare.dump(), "is not a report of `tautline bench`"},
      {law.dump(), "measure different things: law"},
      {stepless.dump(), "whose step is no number above 0"},
      {endless.dump(), "lacks a number"},
      {stranger.dump(), "does not list"}};
  for (const Bad& bad : all) {
    const Compared outcome = compared(bad.text, good);
    EXPECT_EQ(outcome.outcome.code, 2) << bad.sentence << outcome.outcome.output;
    EXPECT_NE(outcome.outcome.errors.find(bad.sentence), std::string::npos)
        << bad.sentence << "\n"
        << outcome.outcome.errors;
    EXPECT_EQ(outcome.outcome.output, "");
  }
  EXPECT_EQ(program({"compare", "/no/such", "/tmp"}).code, 2);
}

/// A sound report with as many runs as make so many bytes.
std::string report_of(std::size_t bytes) {
  ordered_json large = sound();
  const ordered_json runs = large.at("runs");
  const std::size_t copies = bytes / runs.dump(2).size() + 1;
  for (std::size_t copy = 1; copy <= copies; ++copy) {
    for (ordered_json run : runs) {
      run.at("model") = run.at("model").get<std::string>() + std::to_string(copy);
      large.at("runs").push_back(std::move(run));
    }
  }
  return large.dump(2);
}

/// Processor time that the programs started so far have taken [s].
double time_of_programs() {
  rusage used{};
  EXPECT_EQ(::getrusage(RUSAGE_CHILDREN, &used), 0);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// Processor time of the comparison of a report with itself [s].
double time_to_compare(const std::string& report) {
  const double before = time_of_programs();
  EXPECT_EQ(compared(report, report).outcome.code, 0);
  return time_of_programs() - before;
}

TEST(Compare, TwentyMegabytesTakeTenTimesAsLongAsTwo) {
  const double small = time_to_compare(report_of(2'000'000));
  const double large = time_to_compare(report_of(20'000'000));
  std::printf("%.2f s and %.2f s\n", small, large);
  EXPECT_LT(large, 30.0 * small) << "a search through all for each would take a hundred times";
}

}  // namespace
}  // namespace tautline::test
