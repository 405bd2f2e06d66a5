// The motions in a report: thinned, but without losing an impact that is kept, and within a size
// that a page can hold.

#include "bench/report/replay_data.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "bench/report/compact_json.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

using nlohmann::ordered_json;

constexpr double count_speed = 1e-2;  // [m/s]

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
    const double rate = 1.0 - 0.9 * static_cast<double>(i) / static_cast<double>(count);
    const State state{Vec2(std::cos(time), std::sin(time)), time, Vec2::Zero(), 0.0};
    run.impacts.push_back({time, 0, 1.0, -rate, 0.5 * rate, 0, state, state});
  }
  return run;
}

std::set<double> numbers(const ordered_json& column) { return column.get<std::set<double>>(); }

TEST(ReplayData, ThinningKeepsTheStartTheEndAndEveryImpact) {
  const Case the_case = shipped_cases().front();
  const Trajectory run = run_with(200);
  const ordered_json path = run_path_json(the_case, run, 60, count_speed);
  const ordered_json impacts = run_impacts_json(the_case, run, count_speed);
  EXPECT_EQ(path.at("time").front(), 0.0);
  EXPECT_EQ(path.at("time").back(), 20.0);
  EXPECT_EQ(path.at("time").size(), 260U);
  EXPECT_TRUE(std::is_sorted(path.at("time").begin(), path.at("time").end()));
  EXPECT_EQ(impacts.at("time").size(), 200U);
  EXPECT_EQ(impacts.at("left_out"), 0);
  const std::set<double> times = numbers(path.at("time"));
  for (const ordered_json& time : impacts.at("time")) {
    EXPECT_TRUE(times.contains(time.get<double>())) << time;
  }
}

TEST(ReplayData, OfVeryManyImpactsTheFastestStay) {
  const Case the_case = shipped_cases().front();
  const ordered_json impacts = run_impacts_json(the_case, run_with(500), count_speed);
  ASSERT_EQ(impacts.at("time").size(), most_impacts);
  EXPECT_EQ(impacts.at("left_out"), 200);
  EXPECT_LT(impacts.at("rate_before").back().get<double>(), -0.4);  // they slow down from 1 to 0.1
}

TEST(ReplayData, AReportOfVeryManyRunsHasFewerImpactsInEach) {
  const Case the_case = shipped_cases().front();
  const Trajectory run = run_with(200);
  ordered_json row = {{"path", run_path_json(the_case, run, 60, count_speed)},
                      {"impacts", run_impacts_json(the_case, run, count_speed)}};
  ordered_json report = {{"runs", ordered_json::array()}};
  const std::size_t runs = 2646;  // 21 cases, 42 models, 3 steps
  for (std::size_t i = 0; i < runs; ++i) {
    report["runs"].push_back(row);
  }
  thin_impacts(report);
  const ordered_json& thinned = report.at("runs").back();
  EXPECT_EQ(thinned.at("impacts").at("time").size(), 24U);
  EXPECT_EQ(thinned.at("impacts").at("left_out"), 176);
  const std::set<double> times = numbers(thinned.at("path").at("time"));
  EXPECT_EQ(times.size(), 60U + 24U);
  for (const ordered_json& time : thinned.at("impacts").at("time")) {
    EXPECT_TRUE(times.contains(time.get<double>())) << time;
  }
  // what is left of 25 MB for the page itself and the tables
  EXPECT_LT(compact_json(report).size(), 16'000'000U);
}

TEST(ReplayData, ThePathOfTheExactMotionHasEveryEvent) {
  const Case the_case = shipped_cases().front();
  const Solution solution = solve(the_case);
  ordered_json row;
  add_exact_motion(the_case, solution, row);
  EXPECT_EQ(row.at("events").at("time").size(), std::min(solution.events().size(), most_impacts));
  const std::set<double> times = numbers(row.at("path").at("time"));
  for (const ordered_json& time : row.at("events").at("time")) {
    EXPECT_TRUE(times.contains(time.get<double>())) << time;
  }
  EXPECT_EQ(row.at("geometry").size(), the_case.cables.size());
}

TEST(CompactJson, HasALineForEveryRowAndReadsBack) {
  const ordered_json report = {{"rows", {{{"a", {1, 2, 3}}, {"b", nullptr}}, {{"a", {4}}}}},
                               {"context", {{"timing", {{{"t", 1.5}}, {{"t", 2.5}}}}}},
                               {"none", ordered_json::array()}};
  const std::string text = compact_json(report);
  EXPECT_EQ(ordered_json::parse(text), report);
  EXPECT_NE(text.find("\n  {\"a\":[1,2,3],\"b\":null},\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n   {\"t\":1.5},\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace tautline::bench
