// Samples, tensions and pictures over time: `tautline solve --every --csv`, --events, --plot.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "bench/plot/motion.hpp"
#include "bench/solution/sample_times.hpp"
#include "bench/solution/samples.hpp"
#include "bench/solution/taut_phases.hpp"
#include "tautline/case_file.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"
#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test::outputs {
namespace {

using bench::SampleTimes;

/// A box of 5 kg on two ropes, let go 0.5 m above their end.
Case hanging_box() {
  Case the_case;
  the_case.name = "hanging-box";
  the_case.body = {5.0, 0.8333333333333334};
  for (const double side : {-0.5, 0.5}) {
    the_case.cables.push_back({{side, 5.0}, {side, 0.5}, 3.0, 0.0, 0.0, {}});
  }
  the_case.gravity = {0.0, -9.81};
  the_case.initial.position = {0.0, 2.0};
  the_case.duration = 20.0;
  return the_case;
}

/// A pendulum of length 1 let go at rest, `start` [rad] from the lowest point.
Case pendulum(double start, double duration) {
  Case the_case;
  the_case.name = "pendulum";
  the_case.body = {2.0, 0.0};
  the_case.cables = {{{0.0, 0.0}, {0.0, 0.0}, 1.0, 0.0, 0.0, {}}};
  the_case.gravity = {0.0, -9.81};
  the_case.initial.position = {std::sin(start), -std::cos(start)};
  the_case.duration = duration;
  return the_case;
}

using CsvRow = std::map<std::string, std::string>;

std::vector<CsvRow> rows_of(const std::string& csv) {
  std::istringstream lines(csv);
  const auto cells_of = [](const std::string& line) {
    std::vector<std::string> cells(1);
    for (const char c : line) {
      if (c == ',') {
        cells.emplace_back();
      } else {
        cells.back() += c;
      }
    }
    return cells;
  };
  std::string line;
  std::getline(lines, line);
  const std::vector<std::string> names = cells_of(line);
  std::vector<CsvRow> rows;
  while (std::getline(lines, line)) {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    rows.emplace_back();
    for (std::size_t k = 0; k < std::min(names.size(), cells.size()); ++k) {
      rows.back()[names[k]] = cells[k];
    }
  }
  return rows;
}

std::vector<CsvRow> csv_of(const Case& the_case, double step) {
  const Solution solution = solve(the_case);
  const Uncertainty uncertainty(the_case, solution);
  return rows_of(bench::samples_csv(the_case, solution, uncertainty,
                                    bench::times_every(step, solution.end_time()).times));
}

TEST(SampleTimes, RangesHaveBothEndsAndTheDecimalsThatWereMeant) {
  const std::vector<std::string> words = {"0:0.1:5", "7"};
  const SampleTimes found = bench::times_at(words);
  ASSERT_EQ(found.problems, std::vector<std::string>{});
  ASSERT_EQ(found.times.size(), 52U);
  EXPECT_EQ(found.times[3], 0.3);
  EXPECT_EQ(found.times[50], 5.0);
  EXPECT_EQ(found.times[51], 7.0);
  EXPECT_EQ(bench::times_every(0.01, 20.0).times.size(), 2001U);
  EXPECT_EQ(bench::times_every(3.0, 2.0).times, std::vector<double>{0.0});
}

TEST(SampleTimes, RefusesWhatIsNoTimeBeforeAnythingIsComputed) {
  for (const double step : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(bench::times_every(step, 5.0).problems.size(), 1U) << step;
  }
  const SampleTimes many = bench::times_every(1e-12, 5.0);
  ASSERT_EQ(many.problems.size(), 1U);
  EXPECT_NE(many.problems.front().find("at most 1000000"), std::string::npos)
      << many.problems.front();
  EXPECT_TRUE(many.times.empty());
  for (const std::string word :
       {"", "x", "0:0:5", "0:-1:5", "5:1:0", "0:1", "0:nan:5", "1e999", "0:1:2:3", "0:1e-300:1"}) {
    EXPECT_EQ(bench::times_at({&word, 1}).problems.size(), 1U) << word;
  }
}

TEST(Samples, OfAHangingBoxHaveTwoRowsForItsImpactAndHalfTheWeightEach) {
  const std::vector<CsvRow> rows = csv_of(hanging_box(), 0.01);
  ASSERT_EQ(rows.size(), 2001U + 2U);
  std::size_t impact = 0;
  while (rows[impact].at("event") != "before impact") {
    ASSERT_LT(++impact, rows.size());
  }
  const CsvRow& before = rows[impact];
  const CsvRow& after = rows[impact + 1];
  const double time = std::sqrt(2.0 * 0.5 / 9.81);
  const double impulse = 5.0 * std::sqrt(2.0 * 9.81 * 0.5) / 2.0;
  constexpr double printed = 1e-12;  // the digits that are certain
  EXPECT_EQ(after.at("event"), "after impact");
  EXPECT_EQ(before.at("time"), after.at("time"));
  EXPECT_NEAR(std::stod(before.at("time")), time, printed);
  EXPECT_NEAR(std::stod(before.at("vy")), -9.81 * time, printed);
  EXPECT_EQ(before.at("impulse_0"), "");
  for (const char* cable : {"_0", "_1"}) {
    EXPECT_NEAR(std::stod(after.at("impulse" + std::string(cable))), impulse, printed);
    EXPECT_EQ(before.at("tension" + std::string(cable)), "0");
    EXPECT_NEAR(std::stod(rows.back().at("tension" + std::string(cable))), 24.525, printed);
    EXPECT_EQ(rows.back().at("gap" + std::string(cable)), "0");
    EXPECT_NEAR(std::stod(rows.front().at("gap" + std::string(cable))), 0.5, printed);
  }
  EXPECT_NEAR(std::stod(rows.front().at("energy")), 5.0 * 9.81 * 2.0, printed);
}

// an impact, and the completion of an accumulation by it
TEST(Samples, OneInstantHasOnePairOfRowsWithAllItsImpulses) {
  const auto shipped = shipped_cases();
  const Case& the_case = *std::find_if(shipped.begin(), shipped.end(), [](const Case& one) {
    return one.name == "plate-four-cables";
  });
  const Solution solution = solve(the_case);
  std::map<double, double> impulses;  // of cable 0, by instant
  std::size_t jumps = 0;
  for (const Event& event : solution.events()) {
    if (event.kind == EventKind::impact || !event.impulses.isZero(0.0)) {
      ++jumps;
      double& sum = impulses[event.time];
      Eigen::Index place = 0;
      for (const std::size_t cable : event.cables) {
        sum += cable == 0 ? std::max(0.0, event.impulses[place]) : 0.0;
        ++place;
      }
    }
  }
  ASSERT_GT(jumps, impulses.size()) << "the case has instants with two jumps";
  auto instant = impulses.begin();
  std::string before;
  for (const CsvRow& row : csv_of(the_case, 1.0)) {
    if (row.at("event") == "after impact") {
      ASSERT_EQ(before, "before impact") << row.at("time");
      ASSERT_NE(instant, impulses.end());
      if (!row.at("impulse_0").empty()) {
        EXPECT_NEAR(std::stod(row.at("impulse_0")), instant->second, 1e-4) << instant->first;
      }
      ++instant;
    }
    EXPECT_FALSE(before == "before impact" && row.at("event") == before) << row.at("time");
    before = row.at("event");
  }
  EXPECT_EQ(instant, impulses.end());
}

TEST(Samples, LeaveOutWhatIsNotCertain) {
  Case the_case;
  for (const Case& shipped : shipped_cases()) {
    the_case = shipped.name == "breakwater/1910121100" ? shipped : the_case;
  }
  const Solution solution = solve(the_case);
  const Uncertainty uncertainty(the_case, solution);
  ASSERT_FALSE(uncertainty.unsure().empty());
  const std::vector<CsvRow> rows = csv_of(the_case, 0.05);
  double previous = -1.0;
  std::size_t empty = 0;
  for (const CsvRow& row : rows) {
    if (row.at("time").empty()) {
      continue;
    }
    const double time = std::stod(row.at("time"));
    if (!row.at("event").empty()) {
      continue;  // its time has the digits that are certain alone
    }
    EXPECT_GE(time, previous);
    previous = time;
    const auto sure = uncertainty.at(time);
    empty += sure ? 0U : 1U;
    EXPECT_EQ(row.at("x").empty() && row.at("energy").empty(), !sure) << time;
    if (!row.at("x").empty()) {
      const double x = solution.at(time).position.x();
      EXPECT_NEAR(std::stod(row.at("x")), x, 2.0 * sure->position.x() + 0.5) << time;
    }
  }
  EXPECT_GT(empty, 0U);
}

TEST(TautPhases, OfAPendulumHaveItsLeastAndItsLargestTension) {
  constexpr double start = 1.0;
  const Case the_case = pendulum(start, 10.0);
  const Solution solution = solve(the_case);
  const auto phases = bench::taut_phases(the_case, solution, Uncertainty(the_case, solution));
  ASSERT_EQ(phases.size(), 1U);
  const bench::TautPhase& phase = phases.front();
  const double weight = 2.0 * 9.81;
  EXPECT_NEAR(phase.least.tension.value, weight * std::cos(start), 1e-12);
  EXPECT_EQ(phase.least.time.value, 0.0);
  EXPECT_NEAR(phase.largest.tension.value, weight * (3.0 - 2.0 * std::cos(start)), 1e-12);
  const double quarter = std::comp_ellint_1(std::sin(start / 2.0)) / std::sqrt(9.81);
  EXPECT_NEAR(phase.largest.time.value, quarter, phase.largest.time.error);
  EXPECT_LT(phase.largest.time.error, 1e-5);
  EXPECT_FALSE(phase.indeterminate);
}

TEST(TautPhases, OfASwingThatTurnsTooFastToBeSolvedAreNone) {
  Case the_case = pendulum(1.0, 10.0);
  Swing swing{};
  swing.period = 2.0;
  const auto tensions = [&] {
    return bench::period_tensions(the_case, the_case.initial, CableSet::of(0), swing, 0.0);
  };
  EXPECT_EQ(tensions().size(), 1U);
  the_case.initial.spin = largest_number;  // one of more energy would be beyond it
  EXPECT_TRUE(tensions().empty());
}

TEST(Plot, ThePathOfALongSwingIsAnArcOfItsCircle) {
  for (const double duration : {10.0, 250.0, 2500.0}) {
    const Case the_case = pendulum(1.2870022175866, duration);
    const Solution solution = solve(the_case);
    const bench::PlotMotion motion = bench::plot_motion(the_case, solution);
    const std::vector<Vec2>& path = motion.paths.front();
    double deepest = 0.0;
    for (std::size_t k = 1; k < path.size(); ++k) {
      deepest = std::max(deepest, 1.0 - (0.5 * (path[k - 1] + path[k])).norm());
    }
    EXPECT_LT(deepest, 1e-3) << duration << " s, " << path.size() << " points";
    EXPECT_EQ(motion.path_end, solution.end_time());
    double least = 0.0;
    double largest = 0.0;
    for (const Vec2& point : path) {
      least = std::min(least, point.x());
      largest = std::max(largest, point.x());
    }
    EXPECT_NEAR(largest, 0.96, 1e-3) << duration;
    EXPECT_NEAR(least, -0.96, 1e-3) << duration;
  }
}

TEST(Plot, TheMotionOverTimeHasFivePanelsAndEachImpact) {
  for (const Case& the_case : {hanging_box(), pendulum(1.0, 2500.0), bouncing_ball()}) {
    const std::string svg = bench::plot_motion_svg(the_case, solve(the_case));
    for (const char* part : {"x [m]", "y [m]", "angle [rad]", "gap [m]", "tension [N]", "t [s]",
                             "cable 0", "prefers-color-scheme", "</svg>"}) {
      EXPECT_NE(svg.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("class=\"impact\"") != std::string::npos, the_case.name != "pendulum");
    EXPECT_LT(svg.size(), 400'000U) << the_case.name;
  }
}

TEST(Solve, WritesSamplesAndTensionsOfManyCases) {
  const TemporaryFolder folder;
  const std::string files = (folder.path() / "{case}.csv").string();
  const Outcome outcome =
      program({"solve", "breakwater/19*", "bouncing-ball", "--every", "0.5", "--csv", files});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("bouncing-ball: 1 cable"), std::string::npos);
  EXPECT_NE(outcome.output.find("breakwater/1910121100: 2 cables"), std::string::npos);
  EXPECT_EQ(rows_of(content_of(folder.path() / "bouncing-ball.csv")).front().at("time"), "0");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "breakwater-1910121100.csv"));

  const Outcome written =
      program({"solve", "bouncing-ball", "breakwater/1910121100", "--json", "-"});
  EXPECT_EQ(written.code, 0) << written.errors;
  EXPECT_TRUE(written.output.starts_with("[\n{")) << written.output.substr(0, 40);
  EXPECT_TRUE(written.output.ends_with("}\n]\n"));

  const Outcome events = program({"solve", "bouncing-ball", "--events"});
  EXPECT_NE(events.output.find("Tension at rest: 1 on cable 0"), std::string::npos)
      << events.output;
  EXPECT_NE(events.output.find("largest tension"), std::string::npos) << events.output;

  const Outcome picture = program({"solve", "bouncing-ball", "--plot", "motion"});
  EXPECT_EQ(picture.code, 0);
  EXPECT_TRUE(picture.output.starts_with("<svg")) << picture.output.substr(0, 40);
}

TEST(Solve, WritesWhatItsSchemaSays) {
  TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "swing.toml";
  Case swing = pendulum(0.5, 3.0);  // one that repeats, with every key that a case file may have
  swing.angle_limit = 7.0;
  swing.ceiling = 90.0;
  swing.initial.position = {0.6, -0.8};
  swing.cables.push_back({{0.0, 9.0}, {0.0, 0.0}, 30.0, 0.5, 0.25, {}});
  swing.cables.push_back({{0.0, 9.0}, {0.0, 0.0}, 40.0, 0.0, 0.0, {{0.1, 0.5}, {2.0, 0.3}}});
  ASSERT_EQ(write_case(swing, file), std::vector<std::string>());
  const Outcome shipped = program({"solve", "bouncing-ball", "breakwater/1*", "buoy-three-cables",
                                   "plate-four-cables", "--every", "2", "--json", "-"});
  const Outcome own = program({"solve", file, "--certify", "--json", "-"});
  ASSERT_EQ(shipped.code, 0) << shipped.errors;
  ASSERT_EQ(own.code, 0) << own.errors;
  std::vector<nlohmann::json> motions = nlohmann::json::parse(shipped.output);
  motions.push_back(nlohmann::json::parse(own.output));
  EXPECT_EQ(motions.back()["case"]["cables"][1]["capture_speed"], 0.25);
  EXPECT_EQ(motions.back()["settling"]["lock"]["swing"]["tensions"].size(), 1);
  const auto schema = nlohmann::json::parse(program({"solve", "--schema"}).output);
  for (const auto& motion : motions) {
    EXPECT_EQ(broken_rules(motion, schema), "") << motion["case"]["name"];
  }
  motions.back().erase("ending");
  EXPECT_NE(broken_rules(motions.back(), schema), "");
}

TEST(Solve, SaysWhatIsWrongWithItsFilesBeforeItSolves) {
  const auto refused = [](const std::vector<std::string>& words, const std::string& sentence) {
    std::vector<std::string> all = {"solve"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = program(all);
    EXPECT_EQ(outcome.code, 2) << sentence;
    EXPECT_EQ(outcome.output, "") << sentence;
    EXPECT_NE(outcome.errors.find(sentence), std::string::npos) << outcome.errors;
  };
  refused({"bouncing-ball", "--csv", "-"}, "say at which times with --every STEP or --at TIMES");
  refused({"bouncing-ball", "--every", "1e-12"}, "samples are too many; at most 1000000 fit");
  refused({"bouncing-ball", "--every", "0"}, "--every 0: must be a time between samples");
  refused({"bouncing-ball", "--at", "0:x:3"}, "a range is FROM:STEP:TO");
  refused({"breakwater/19*", "--every", "1", "--csv", "a.csv"}, "use {case} in its name for");
  refused({"bouncing-ball", "--every", "1", "--csv", "-", "--plot", "motion"},
          "--plot - and --csv -: standard output takes one of them");
  refused({"bouncing-ball", "no-such-case", "x.toml"}, "unknown case \"no-such-case\"");
  refused({"bouncing-ball", "--plot", "moton=x.svg"}, "there is no picture moton");
  refused({"bouncing-ball", "--taut", "-1"}, "--taut -1: cables count from 0 to 7");
  const Outcome full = program({"solve", "bouncing-ball", "--every", "1", "--csv", "/dev/full"});
  EXPECT_EQ(full.code, 1);
  EXPECT_NE(full.errors.find("No space left on device"), std::string::npos) << full.errors;
}

}  // namespace
}  // namespace tautline::test::outputs
