// A report as JSON: read back as it was, and within a size that a page can hold.

#include "bench/report/json/json.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/replay/motion.hpp"
#include "bench/replay/replay.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

constexpr double least_counted = 1e-2;  // [m/s]

/// A run of 20 s with `count` impacts, the later the slower.
Trajectory run_with(std::size_t count) {
  Trajectory run;
  run.step = 1e-3;
  for (std::size_t i = 0; i <= 20'000; ++i) {
    const double time = static_cast<double>(i) * 1e-3;
    run.points.push_back({time, {Vec2(std::cos(time), std::sin(time)), time, Vec2::Zero(), 0.0}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const double time = 0.0105 + static_cast<double>(i) * 19.0 / static_cast<double>(count);
    const double rate = 1.0 - 0.9 * static_cast<double>(i) / static_cast<double>(count + 1);
    const State state{Vec2(std::cos(time), std::sin(time)), time, Vec2::Zero(), 0.0};
    run.impacts.push_back({time, 0, 1.0, -rate, 0.5 * rate, 0, state, state});
  }
  return run;
}

RunReplay replay_of(const Trajectory& run) {
  static const ReferenceCase reference =
      solve_cases({shipped_cases().front()}, ImpactLaw::simultaneous).front();
  return {run_path(reference.the_case, nearness_of(reference), run),
          run_impacts(reference.the_case, run, least_counted)};
}

TEST(ReportJson, OfVeryManyImpactsTheFastestStay) {
  const ImpactColumns impacts = replay_of(run_with(5200)).impacts.value();
  ASSERT_EQ(impacts.time.size(), most_impacts);
  EXPECT_EQ(impacts.left_out, 200U);
  EXPECT_LT(impacts.rate_before.back(), -0.12);  // they slow down from 1 to 0.1
}

TEST(ReportJson, IsRoundedForAChartAlone) {
  const ImpactColumns impacts = replay_of(run_with(200)).impacts.value();
  const ImpactColumns drawn = drawable(impacts, most_drawn);
  EXPECT_NE(impacts.rate_before.at(3), drawn.rate_before.at(3));
  EXPECT_NEAR(impacts.rate_before.at(3), drawn.rate_before.at(3), 1e-6);
  EXPECT_EQ(impacts.time.size(), drawn.time.size());
}

TEST(ReportJson, HasEveryImpactThatThePageLeavesOut) {
  Report report;
  Replay replay;
  report.runs.resize(30);
  for (RunRow& run : report.runs) {
    run.key = {"a case", fmt::format("engine-{}", &run - report.runs.data()), "row", 1e-3};
  }
  replay.runs.assign(report.runs.size(), replay_of(run_with(900)));
  const auto json = nlohmann::json::parse(report_json(report, replay));
  const auto page = nlohmann::json::parse(page_json(report, replay));
  const auto columns = page.at("impact_columns").get<std::vector<std::string>>();
  const auto left_out = static_cast<std::size_t>(
      std::find(columns.begin(), columns.end(), "left_out") - columns.begin());
  for (std::size_t run = 0; run < report.runs.size(); ++run) {
    EXPECT_EQ(json.at("runs")[run].at("impacts").at("time").size(), 900U);
    EXPECT_EQ(json.at("runs")[run].at("impacts").at("left_out"), 0U);
    EXPECT_EQ(page.at("runs")[run].at("impacts")[left_out], 600U);
  }
}

TEST(ReportJson, APageOfVeryManyRunsHasFewerImpactsInEach) {
  Report report;
  Replay replay;
  const std::size_t runs = 4320;  // all cases on the engines of Debian at three steps
  report.runs.resize(runs);
  replay.runs.assign(runs, replay_of(run_with(200)));
  const ImpactColumns thinned =
      drawable(replay, 0, runs, page_impacts(runs)).runs.back().impacts.value();
  EXPECT_EQ(thinned.time.size(), 3U);
  EXPECT_EQ(thinned.left_out, 197U);
  // the motions are beside it, and what is left of 10 MB is for the page itself and the tables
  EXPECT_LT(page_json(report, replay).size(), 6'000'000U);
}

TEST(ReportJson, TheMotionsOfACaseSayHowManyImpactsThereWere) {
  Report report;
  report.runs.resize(2);
  report.runs[0].key = {"one", "box2d", "row", 1e-3};
  report.runs[1].key = {"other", "ode", "row", 1e-3};
  const nlohmann::json motions = nlohmann::json::parse(
      motions_json(report, {{}, {replay_of(run_with(500)), replay_of(run_with(1))}}, "one"));
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_EQ(motions[0].at("engine"), "box2d");
  const nlohmann::json& impacts = motions[0].at("impacts");
  EXPECT_EQ(impacts.at("left_out").get<std::size_t>() + impacts.at("time").size(), 500U);
  EXPECT_EQ(impacts.at("speed").size(), impacts.at("time").size());
  EXPECT_EQ(impacts.at("cable").size(), impacts.at("time").size());
}

TEST(ReportJson, HasALineForEveryRowAndReadsBack) {
  Report report;
  report.version = "1";
  report.runs.resize(2);
  report.runs[1].key.the_case = "another";
  const std::string text = report_json(report, {{}, {2, replay_of(run_with(3))}});
  EXPECT_NE(text.find("\n  {\"case\":\"another\",\"engine\":\"\""), std::string::npos) << text;
  const ReportReading reading = report_from(text, "it");
  ASSERT_TRUE(reading.report) << (reading.problems.empty() ? "" : reading.problems.front());
  EXPECT_EQ(report_json(*reading.report, reading.replay), text);
}

TEST(ReportJson, RefusesWhatIsNoReportInASentence) {
  Report report;
  report.version = "1";
  report.runs.resize(1);
  const std::string text = report_json(report, {{}, {replay_of(run_with(3))}});
  const auto problem_of = [](std::string changed, const std::string& from, const std::string& to) {
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const ReportReading reading = report_from(changed.replace(at, from.size(), to), "it");
    return reading.report ? "" : reading.problems.front();
  };
  const std::string schema = "\"schema\": " + std::to_string(report_schema);
  EXPECT_NE(problem_of(text, schema, "\"schema\": [[[]]]"), "");
  EXPECT_NE(problem_of(text, "\"planned_runs\": 0", "\"planned_runs\": -1"), "");
  EXPECT_NE(problem_of(text, "\"status\":\"finished\"", "\"status\":\"lost\""), "");
  EXPECT_NE(problem_of(text, "\"runs\": [", "\"runs\": 3, \"more\": ["), "");
  EXPECT_NE(problem_of(text, "\"cable\":[0,", "\"cable\":["), "") << "shorter than its neighbours";
  EXPECT_FALSE(record_from("{\"fingerprint\": 3}", "3"));
  EXPECT_FALSE(record_from("{\"fingerprint\": \"3\"}", "3"));
  EXPECT_FALSE(record_from("[", "3"));
}

TEST(ReportJson, RefusesAStepOnAGridThatDoesNotFit) {
  RunRecord record;
  record.replay = replay_of(run_with(3));
  const std::string text = record_json(record, "3");
  const std::string first = "\"steps\":[0";  // of the coordinate x
  const std::size_t step = text.find(first, text.find("\"x\":{")) + first.size() - 1;
  const auto reads = [&](const char* number) {
    return record_from(std::string(text).replace(step, 1, number), "3").has_value();
  };
  EXPECT_TRUE(reads("0"));
  EXPECT_TRUE(reads("2147483647"));
  for (const char* wrong : {"0.5", "2147483648", "-3000000000", "1e300", "null"}) {
    EXPECT_FALSE(reads(wrong)) << wrong;
  }
}

}  // namespace
}  // namespace tautline::bench
