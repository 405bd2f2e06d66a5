// What changed from one report to another, on reports made by hand.

#include "bench/gate/noise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "bench/gate/changes.hpp"
#include "bench/gate/changes_output.hpp"
#include "tests/bench/gate/made_report.hpp"

namespace tautline::bench::test {
namespace {

/// A report of one run of one engine, "e", whose metrics are all `value`.
Report measured_report(double value, const std::string& precision = "float64",
                       std::size_t exact_impacts = 10) {
  Report report = made_report();
  add_engine(report, "e", precision);
  add_run(report, "e", value, 1e-3, exact_impacts);
  return report;
}

/// Noise alone, without the tolerance beside it.
Noise noise_alone() {
  Noise noise;
  noise.tolerance = 0.0;
  return noise;
}

/// What changes if one metric of that run goes from `one` to `two`.
Changes changed(std::string_view metric, double one, double two,
                const std::string& precision = "float64", std::size_t exact_impacts = 10,
                const Noise& noise = noise_alone()) {
  Report before = measured_report(0.0, precision, exact_impacts);
  Report after = before;
  before.runs.front().metrics->at(place(metric)) = one;
  after.runs.front().metrics->at(place(metric)) = two;
  return changes(before, after, noise);
}

TEST(Noise, EveryMetricButThoseBeyondTheHorizonIsCompared) {
  for (const Metric& metric : metric_list()) {
    const Changes found = changed(metric.name, 0.0, 1e6);
    EXPECT_EQ(found.got_worse.size(), metric.noise == NoiseKind::any ? 0U : 1U) << metric.name;
    EXPECT_TRUE(found.got_better.empty());
  }
  for (const char* name :
       {"early_position_error", "early_angle_error", "first_impact_error", "horizon_position_error",
        "missed_impacts", "restitution_error", "overstretch", "energy_gain"}) {
    EXPECT_TRUE(changed(name, 0.0, 1e6).worse()) << name;
  }
  EXPECT_FALSE(changed("whole_position_error", 0.0, 1e6).worse());
}

TEST(Noise, EarlyRoundingIsThePrecisionOverTheStep) {
  const double floor = 2.0 * std::numeric_limits<double>::epsilon() / 1e-3;
  EXPECT_FALSE(changed("early_position_error", 0.0, 0.9 * floor).worse());
  EXPECT_TRUE(changed("early_position_error", 0.0, 1.1 * floor).worse());
  EXPECT_FALSE(changed("early_position_error", 0.0, 1e-4, "float32").worse());
  EXPECT_TRUE(changed("early_position_error", 0.0, 1e-3, "float32").worse());
  EXPECT_FALSE(changed("early_position_error", 1.0, 1.0 + 0.9e-6).worse());
  EXPECT_TRUE(changed("early_position_error", 1.0, 1.0 + 1.1e-6).worse());
}

TEST(Noise, TheHorizonAmplifiesRoundingByItsDefinition) {
  const double floor = 1e9 * 2.0 * std::numeric_limits<double>::epsilon() / 1e-3;
  EXPECT_FALSE(changed("horizon_position_error", 0.0, 0.9 * floor).worse());
  EXPECT_TRUE(changed("horizon_position_error", 0.0, 1.1 * floor).worse());
}

TEST(Noise, AnExtremeIsADrawOnlyWhereTheRunGoesBeyondTheHorizon) {
  EXPECT_FALSE(changed("overstretch", 1.0, 1.9).worse());
  EXPECT_TRUE(changed("overstretch", 1.0, 2.1).worse());
  Report before = measured_report(0.0);
  before.cases.front().horizon = before.cases.front().duration;
  before.runs.front().metrics->at(place("overstretch")) = 1.0;
  Report after = before;
  after.runs.front().metrics->at(place("overstretch")) = 1.1;
  EXPECT_TRUE(changes(before, after).worse());
}

TEST(Noise, OneImpactMayChangeSidesAndOfManyTheirShare) {
  for (const std::size_t exact : {1U, 3U, 7U, 49U, 50U}) {
    const auto share = [&](std::size_t missed) {
      return static_cast<double>(missed) / static_cast<double>(exact);
    };
    const auto worse = [&](std::size_t one, std::size_t two) {
      return changed("missed_impacts", share(one), share(two), "float64", exact).worse();
    };
    for (std::size_t missed = 0; missed < exact; ++missed) {
      EXPECT_FALSE(worse(missed, missed + 1)) << missed << " of " << exact;
      EXPECT_TRUE(worse(missed, missed + 2)) << missed << " of " << exact;
    }
  }
  EXPECT_FALSE(changed("missed_impacts", 0.0, 20.0 / 1000.0, "float64", 1000).worse());
  EXPECT_TRUE(changed("missed_impacts", 0.0, 21.0 / 1000.0, "float64", 1000).worse());
}

TEST(Noise, AChangeThatTwoDigitsDoNotTellIsWithinTheTolerance) {
  const auto worse = [](double one, double two, double tolerance) {
    Noise noise;
    noise.tolerance = tolerance;
    return changed("early_position_error", one, two, "float64", 10, noise).worse();
  };
  const double usual = Noise().tolerance;
  EXPECT_FALSE(worse(0.0546, 0.0548, usual)) << "shown as a change by a factor of 1";
  EXPECT_TRUE(worse(0.0546, 0.0548, 0.0)) << "it is beyond noise";
  EXPECT_FALSE(worse(1.0, 1.04, usual));
  EXPECT_TRUE(worse(1.0, 1.06, usual));
  EXPECT_FALSE(worse(1.0, 1.9, 0.5));
  // what is noise stays noise, however small the tolerance
  EXPECT_FALSE(worse(0.0, std::numeric_limits<double>::epsilon(), 0.0));
}

/// A report of runs of one engine, model "row", over `cases` x `steps`.
Report wide_report(std::size_t cases, const std::vector<double>& steps) {
  Report report = made_report();
  add_engine(report, "e");
  for (std::size_t index = 0; index < cases; ++index) {
    for (const double step : steps) {
      add_run(report, "e", 0.1, step).key.the_case = "case-" + std::to_string(index);
    }
  }
  const CaseRow ball = report.cases.front();
  for (std::size_t index = 0; index < cases; ++index) {
    report.cases.push_back(ball);
    report.cases.back().name = "case-" + std::to_string(index);
  }
  return report;
}

TEST(Changes, RunsThatAreGoneAreCountedNotListed) {
  const Report before = wide_report(30, {1e-2, 1e-3, 1e-4});
  Report after = before;
  after.runs.resize(1);  // case-0 at 1e-2
  const std::string text = changes_text(changes(before, after));
  EXPECT_NE(text.find("Runs that are gone (89):"), std::string::npos) << text;
  EXPECT_NE(text.find("e       row    0.0001, 0.001, 0.01  30       89"), std::string::npos)
      << text;
  EXPECT_EQ(text.find("case-7"), std::string::npos) << "one of 89 by its name";
  EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 10) << text;
  after = before;
  after.runs.pop_back();
  const std::string one = changes_text(changes(before, after));
  EXPECT_NE(one.find("case-29"), std::string::npos) << "that one alone is gone\n" << one;
}

TEST(Changes, AMetricThatIsMeasuredInOneReportAloneIsOne) {
  const Report with = measured_report(0.5);
  Report without = with;
  without.runs.front().metrics->at(place("first_impact_error")) = std::nullopt;
  const Changes lost = changes(with, without);
  ASSERT_EQ(lost.got_worse.size(), 1U);
  EXPECT_EQ(lost.got_worse.front().metric, place("first_impact_error"));
  EXPECT_FALSE(lost.got_worse.front().after);
  EXPECT_NE(changes_text(lost).find("not measured"), std::string::npos);
  EXPECT_EQ(changes(without, with).got_better.size(), 1U);
}

TEST(Changes, EveryWayToEndOtherwiseIsAFailureOrARecovery) {
  constexpr std::array all = {Status::finished, Status::stopped, Status::diverged, Status::failed};
  const auto rank = [](Status status) {
    return status == Status::finished ? 0 : status == Status::stopped ? 1 : 2;
  };
  for (const Status one : all) {
    for (const Status two : all) {
      Report before = measured_report(0.0);
      Report after = before;
      before.runs.front().status = one;
      after.runs.front().status = two;
      const Changes found = changes(before, after);
      const bool better = rank(two) < rank(one);
      EXPECT_EQ(found.recovered.size(), better ? 1U : 0U) << to_string(one) << to_string(two);
      EXPECT_EQ(found.new_failures.size(), one != two && !better ? 1U : 0U)
          << to_string(one) << to_string(two);
    }
  }
}

TEST(Changes, VersionsAreThoseThatDifferAndNoneIsNotThere) {
  const Report before = measured_report(0.0);
  Report after = before;
  EXPECT_TRUE(changes(before, after).versions.empty());
  after.engines.front().info->version = "2";
  add_engine(after, "another");
  after.context.compiler = "of tomorrow";
  const std::vector<VersionChange> versions = changes(before, after).versions;
  ASSERT_EQ(versions.size(), 3U);
  EXPECT_EQ(versions[0].what, "compiler");
  EXPECT_EQ(versions[1].what, "another");
  EXPECT_FALSE(versions[1].before);
  EXPECT_EQ(versions[2].after, "2");
}

TEST(Changes, CostsAreMediansOverTheCases) {
  Report before = measured_report(0.0);
  Report after = before;
  for (const double factor : {1.0, 2.0, 4.0, 100.0}) {
    TimingRow row;
    row.key = {"case " + std::to_string(factor), "e", "row", 1e-3};
    row.cost_ratio = 10.0;
    before.context.timing.push_back(row);
    row.cost_ratio = 10.0 * factor;
    after.context.timing.push_back(row);
  }
  const Changes found = changes(before, after);
  ASSERT_EQ(found.costs.size(), 1U);
  EXPECT_DOUBLE_EQ(found.costs.front().factor, 3.0);
  EXPECT_EQ(found.costs.front().cases, 4U);
  EXPECT_FALSE(found.worse());
}

TEST(Changes, OtherOptionsCannotBeCompared) {
  Report before = measured_report(0.0);
  before.options.law = "simultaneous";
  before.options.count_speed = 0.01;
  Report after = before;
  EXPECT_TRUE(incomparable(before, after).empty());
  after.options.law = "poisson";
  after.options.count_speed = 0.1;
  const std::vector<std::string> problems = incomparable(before, after);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[1],
            "the reports measure different things: count_speed is 0.01 in the first and 0.1 in the "
            "second");
}

TEST(Changes, NamesInTextAreMadeHarmlessAndMetricsHaveTheirUnits) {
  Report before = measured_report(0.0);
  before.runs.front().key.model = "ro\033w";
  Report after = before;
  after.runs.front().metrics->at(place("energy_gain")) = 3.0;
  const Changes found = changes(before, after);
  const std::string text = changes_text(found);
  EXPECT_EQ(text.find('\033'), std::string::npos);
  EXPECT_NE(text.find("ro\\x1bw"), std::string::npos) << text;
  EXPECT_NE(text.find("1 run compared: 1 change for the worse, 0 for the better."),
            std::string::npos)
      << text;
  const auto row = nlohmann::json::parse(changes_json(found)).at("got_worse").at(0);
  EXPECT_EQ(row.at("metric"), "energy_gain");
  EXPECT_EQ(row.at("unit"), "J");
  EXPECT_EQ(row.at("before"), 0.0);
  EXPECT_EQ(row.at("after"), 3.0);
}

}  // namespace
}  // namespace tautline::bench::test
