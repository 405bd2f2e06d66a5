// How engines do over several reports, made by hand.

#include "bench/gate/trend.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "bench/gate/changes_output.hpp"
#include "bench/tools/trend/version_trend.hpp"
#include "tests/bench/gate/made_report.hpp"

namespace tautline::bench::test {
namespace {

/// One engine of this version in cases whose metrics are these.
Report version(const std::string& version, const std::vector<double>& values) {
  Report report = made_report();
  add_engine(report, "e");
  report.engines.front().info->version = version;
  const CaseRow ball = report.cases.front();
  for (std::size_t index = 0; index < values.size(); ++index) {
    report.cases.push_back(ball);
    report.cases.back().name = "case-" + std::to_string(index);
    add_run(report, "e", values[index]).key.the_case = report.cases.back().name;
  }
  return report;
}

const std::vector<std::string> files = {"a.json", "b.json", "c.json"};

const TrendRow& row_of(const Trend& trend, std::string_view metric) {
  for (const TrendRow& row : trend.rows) {
    if (metric_list()[row.metric].name == metric) {
      return row;
    }
  }
  throw std::logic_error("no row of the metric");
}

TEST(Trend, IsMedianAndQuartilesOverTheCasesByVersion) {
  const Trend found = trend(
      {version("1", {1, 2, 3, 4, 5}), version("2", {1, 2, 3, 4, 5}), version("3", {2, 4, 6, 8, 5})},
      files);
  const TrendRow& row = row_of(found, "early_position_error");
  ASSERT_EQ(row.points.size(), 3U);
  EXPECT_EQ(row.cases, 5U);
  EXPECT_EQ(row.points[0]->version, "1");
  EXPECT_DOUBLE_EQ(row.points[0]->median, 3.0);
  EXPECT_DOUBLE_EQ(row.points[0]->low, 2.0);
  EXPECT_DOUBLE_EQ(row.points[0]->high, 4.0);
  EXPECT_DOUBLE_EQ(row.points[2]->median, 5.0);
  EXPECT_EQ(row.points[1]->worse + row.points[1]->better, 0U);
  EXPECT_EQ(row.points[2]->worse, 4U);
  EXPECT_TRUE(row.moves());
  EXPECT_TRUE(found.latest.worse());
}

TEST(Trend, TakesTheCasesThatAllReportsCouldMeasure) {
  Report second = version("2", {1, 2, 3, 4, 5});
  second.runs[4].metrics->at(place("early_position_error")) = std::nullopt;
  second.cases[2].plane->gravity.x() = 3.0;  // case-1 is another
  const Trend found = trend({version("1", {1, 2, 3, 4, 5, 60}), second}, {"a", "b"});
  const TrendRow& row = row_of(found, "early_position_error");
  EXPECT_EQ(row.cases, 3U) << "case-0, case-2 and case-3";
  EXPECT_DOUBLE_EQ(row.points[0]->median, 3.0);
  EXPECT_DOUBLE_EQ(row.points[1]->median, 3.0);
}

TEST(Trend, AReportWithoutTheEngineHasNoPoint) {
  Report second = version("2", {1, 2});
  second.runs.clear();
  const Trend found = trend({version("1", {1, 2}), second, version("3", {1, 2})}, files);
  const TrendRow& row = row_of(found, "early_position_error");
  EXPECT_TRUE(row.points[0]);
  EXPECT_FALSE(row.points[1]);
  EXPECT_TRUE(row.points[2]);
  const std::string text = trend_text(found, true, {80, false});
  EXPECT_NE(text.find("no runs"), std::string::npos) << text;
}

TEST(Trend, ShowsWhatMovesAndCountsTheRest) {
  const Report still = version("1", {1, 2, 3});
  Report moved = version("2", {1, 2, 3});
  moved.runs[0].metrics->at(place("overstretch")) = 9.0;
  const std::string text = trend_text(trend({still, still, moved}, files), false, {80, false});
  EXPECT_NE(text.find("e row, step 0.001 s"), std::string::npos) << text;
  EXPECT_NE(text.find("stretch [m]"), std::string::npos) << text;
  EXPECT_EQ(text.find("early [m]"), std::string::npos) << "it does not move\n" << text;
  EXPECT_NE(text.find("1 of 5 metrics"), std::string::npos) << text;
  const std::string all = trend_text(trend({still, still, moved}, files), true, {80, false});
  EXPECT_NE(all.find("early [m]"), std::string::npos) << all;
}

/// Three versions with reports: the second is twice as wrong in case-0 and better in case-1, the
/// third worse in case-1. What is between them does not start.
VersionTrend four_versions() {
  VersionTrend trend{"e", "package", ">=1", {}, std::nullopt};
  const auto add = [&](const std::string& name, const std::vector<double>& values) {
    trend.versions.push_back({name, false, "", "", version(name, values)});
  };
  add("1", {1, 5});
  add("2", {2, 1});
  trend.versions.push_back({"2.5", false, "", "it does not start", std::nullopt});
  add("3", {2.2, 5});
  find_trend(trend);
  return trend;
}

TEST(VersionMoves, TheNewestRegressionComesFirstAndNamesItsCase) {
  const Trend trend = four_versions().trend.value();
  const std::vector<VersionMove> worse = version_moves(trend, &Changes::got_worse);
  ASSERT_FALSE(worse.empty());
  EXPECT_EQ(worse.front().version, "3");
  EXPECT_EQ(worse.front().runs, 2U);
  EXPECT_EQ(worse.front().most.key.the_case, "case-1") << "by a factor of 5, and case-0 by 1.1";
  EXPECT_DOUBLE_EQ(worse.front().most.before.value(), 1.0);
  EXPECT_DOUBLE_EQ(worse.front().most.after.value(), 5.0);
  EXPECT_EQ(worse.back().version, "2");
  EXPECT_EQ(worse.back().most.key.the_case, "case-0");
  for (const VersionMove& move : version_moves(trend, &Changes::got_better)) {
    EXPECT_EQ(move.version, "2");
    EXPECT_EQ(move.most.key.the_case, "case-1");
  }
  const std::vector<TitledTable> tables = change_tables(trend);
  ASSERT_EQ(tables.size(), 2U);
  EXPECT_EQ(tables[0].title, "Worse");
  EXPECT_EQ(tables[1].title, "Better");
}

TEST(VersionMoves, AVersionWithoutAReportStaysInSight) {
  VersionTrend trend = four_versions();
  EXPECT_NE(version_svg(trend).find(">(2.5)</text>"), std::string::npos) << version_svg(trend);
  EXPECT_NE(version_html({trend}, {}).find("it does not start"), std::string::npos);
  EXPECT_TRUE(newest_sentence(trend).starts_with("From 2 to 3: ")) << newest_sentence(trend);
  trend.versions.push_back(trend.versions[2]);
  EXPECT_TRUE(newest_is_worse(trend));
  EXPECT_TRUE(newest_sentence(trend).starts_with("2.5 has no report: it does not start. From 2"))
      << newest_sentence(trend);
}

}  // namespace
}  // namespace tautline::bench::test
