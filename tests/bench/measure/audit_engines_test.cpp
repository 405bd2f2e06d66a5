// The restitution audit on the engines themselves, where they are built: it finds by itself what
// their documentation says.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "bench/cases/catalogue.hpp"
#include "bench/judge/models.hpp"
#include "bench/measure/audit.hpp"
#include "bench/measure/audit_parts.hpp"
#include "bench/measure/compare.hpp"
#include "bench/measure/reference.hpp"
#include "bench/run/plugin.hpp"
#include "bench/run/record.hpp"
#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// The report of some models of `engine` on cases with many impacts, which go on to `out`.
json report_of(const TemporaryFolder& out, const std::string& engine, const std::string& models,
               const std::string& steps = "1e-3") {
  static_cast<void>(
      program({"bench", "breakwater/1910121100", "breakwater/1911121100", "breakwater/1930121100",
               "breakwater/1710121100", "bouncing-ball", "--engines", engine, "--models", models,
               "--steps", steps, "--out", (out.path() / "r").string()}));
  return json::parse(content_of(out.path() / "r/report.json"));
}

/// The findings of `model` of one kind.
json found(const json& report, const std::string& model, const std::string& kind) {
  json result = json::array();
  for (const json& finding : report.at("findings")) {
    if (finding.at("model") == model && finding.at("kind") == kind) {
      result.push_back(finding);
    }
  }
  return result;
}

/// A run of the point mass, whose exact motion goes on and on, sampled at every `stride`-th step.
struct SampledRun {
  bench::ReferenceCase reference;
  bench::Trajectory run;

  [[nodiscard]] std::optional<bench::Freeze> freeze(std::size_t stride) const {
    bench::Trajectory thinned = run;
    thinned.points.clear();
    for (std::size_t i = 0; i < run.points.size(); ++i) {
      if (i % stride == 0 || i + 1 == run.points.size()) {
        thinned.points.push_back(run.points[i]);
      }
    }
    return bench::freeze_of(reference, thinned);
  }
};

SampledRun run_of_the_point_mass(const std::string& engine, const std::string& model, double step) {
  const std::string name = "breakwater/1900461100";
  const Case the_case = bench::select_cases({&name, 1}).cases.front();
  const bench::Plugin plugin =
      bench::Plugin::open(TAUTLINE_ENGINE_DIR "/tautline-engine-" + engine + ".so");
  const auto simulation = plugin.engine().start(the_case, model, step);
  return {bench::solve_cases({the_case}, ImpactLaw::simultaneous).front(),
          bench::record(the_case, *simulation, step)};
}

/// Strides from every step to a sample each half second or so of 20.
constexpr std::size_t strides[] = {1, 2, 5, 20, 40};

bool built(const std::string& engine) { return built_engines().contains(engine); }

TEST(AuditOfBullet, FindsTheContactThresholdAndThePush) {
  if (!built("bullet64")) {
    GTEST_SKIP() << "bullet64 is not built";
  }
  const TemporaryFolder out;
  const json report = report_of(out, "bullet64", "contact,contact-tuned,row");
  const json off = found(report, "contact", "off");
  ASSERT_EQ(off.size(), 1U) << report.at("findings");
  EXPECT_GT(off[0].at("value").get<double>(), 0.05);
  const std::string sentence = off[0].at("sentence");
  EXPECT_NE(sentence.find(" too high ("), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("; lost below 0."), std::string::npos) << sentence;
  for (const json& finding : report.at("findings")) {
    EXPECT_EQ(finding.at("model"), "contact") << finding;
  }
  EXPECT_NE(content_of(out.path() / "r/report.md").find(sentence), std::string::npos);
}

TEST(AuditOfBullet, FindsItsDeactivation) {
  if (!built("bullet64")) {
    GTEST_SKIP() << "bullet64 is not built";
  }
  const TemporaryFolder out;
  const json report = report_of(out, "bullet64", "row,row-sleeping", "1e-2");
  ASSERT_EQ(report.at("findings").size(), 1U) << report.at("findings");
  const json asleep = found(report, "row-sleeping", "sleeping");
  ASSERT_EQ(asleep.size(), 1U);
  // the heavy body is slower than 0.8 m/s and 1 rad/s from its start: gDeactivationTime is 2 s
  EXPECT_NEAR(asleep[0].at("value").get<double>(), 2.0, 0.1);
  // none of the runs that it froze passes, and no other is told to be frozen
  std::size_t frozen = 0;
  for (const json& run : report.at("runs")) {
    const json key = {{"case", run.at("case")}, {"step", run.at("step")}};
    const json& shown_in = asleep[0].at("evidence").at("shown_in");
    const bool is_frozen = run.at("model") == "row-sleeping" &&
                           std::find(shown_in.begin(), shown_in.end(), key) != shown_in.end();
    frozen += is_frozen ? 1U : 0U;
    EXPECT_EQ(run.at("verdict").at("problems").dump().find("\"sleeping\"") != std::string::npos,
              is_frozen);
    EXPECT_TRUE(!is_frozen || run.at("verdict").at("word") == "listed problem") << run.at("case");
  }
  EXPECT_EQ(frozen, asleep[0].at("evidence").at("runs"));
}

TEST(AuditOfBullet, FindsItsDeactivationInAPathOfAnySampling) {
  if (!built("bullet64")) {
    GTEST_SKIP() << "bullet64 is not built";
  }
  const SampledRun slept = run_of_the_point_mass("bullet64", "row-sleeping", 1e-2);
  const auto finest = slept.freeze(1);
  ASSERT_TRUE(finest);
  for (const std::size_t stride : strides) {
    const auto freeze = slept.freeze(stride);
    ASSERT_TRUE(freeze) << stride;
    EXPECT_LE(freeze->moving, finest->moving) << stride;
    EXPECT_GE(freeze->time, finest->time) << stride;
  }
}

TEST(AuditOfMujoco, FindsThatSoftLimitsTakeSeveralSteps) {
  if (!built("mujoco")) {
    GTEST_SKIP() << "mujoco is not built";
  }
  const TemporaryFolder out;
  const json report = report_of(out, "mujoco", "tendon-limit,event");
  EXPECT_EQ(found(report, "tendon-limit", "several-steps").size(), 1U) << report.at("findings");
  for (const json& finding : report.at("findings")) {
    EXPECT_EQ(finding.at("model"), "tendon-limit") << finding;
  }
}

TEST(AuditOfBox2d, FindsThatTheJointIgnoresRestitution) {
  if (!built("box2d")) {
    GTEST_SKIP() << "box2d is not built";
  }
  const TemporaryFolder out;
  const json report = report_of(out, "box2d", "distance-joint,event");
  const json ignored = found(report, "distance-joint", "none");
  ASSERT_EQ(ignored.size(), 1U) << report.at("findings");
  EXPECT_EQ(report.at("findings").size(), 1U) << report.at("findings");
}

TEST(AuditOfBox2d, ABodyThatHangsAtRestIsNotAsleepInAPathOfAnySampling) {
  if (!built("box2d")) {
    GTEST_SKIP() << "box2d is not built";
  }
  for (const double step : {1e-2, 1e-3}) {
    const SampledRun hanging = run_of_the_point_mass("box2d", "distance-joint", step);
    for (const std::size_t stride : strides) {
      const auto freeze = hanging.freeze(stride);
      EXPECT_FALSE(freeze) << step << ' ' << stride << " at " << freeze->time;
    }
  }
}

TEST(Audit, FindsNothingInTheControlAtAnyStep) {
  const TemporaryFolder out;
  const json report = report_of(out, "exact", "event,sampled", "1e-2,1e-3,1e-4");
  EXPECT_EQ(report.at("findings"), json::array());
}

TEST(Audit, FindsNothingInTheControlWhateverTheCase) {
  const std::string every = "*";
  const std::vector<bench::ReferenceCase> references =
      bench::solve_cases(bench::select_cases({&every, 1}).cases, ImpactLaw::simultaneous);
  const bench::Plugin plugin = bench::Plugin::open(TAUTLINE_ENGINE_DIR "/tautline-engine-exact.so");
  for (const double step : {1e-2, 1e-3}) {
    for (const bench::ReferenceCase& reference : references) {
      const auto simulation = plugin.engine().start(reference.the_case, "sampled", step);
      const bench::Trajectory run = bench::record(reference.the_case, *simulation, step);
      const bench::RunAudit audit =
          bench::audit(reference, run, bench::CompareOptions().count_speed);
      const bench::Rebounds rebounds = bench::rebounds_of(audit.impacts);
      EXPECT_FALSE(rebounds.wrong()) << reference.the_case.name << ' ' << words_of(rebounds);
      EXPECT_TRUE(
          bench::findings({{reference.the_case.name, "exact", "sampled", step, &audit}}).empty());
    }
  }
}

/// The rows of a CSV file, without its headings.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) {
      rows.back().push_back(std::stod(cell));
    }
  }
  return rows;
}

TEST(Audit, TheImpactColumnsAreThoseOfTheEventsFile) {
  const TemporaryFolder out;
  const json report = report_of(out, "exact", "sampled");
  for (const json& run : report.at("runs")) {
    std::vector<std::vector<double>> events =
        rows_of(content_of(out.path() / "r/runs" / run.at("case").get<std::string>() /
                           "exact/sampled/0.001/events.csv"));
    const double count_speed = report.at("options").at("count_speed");
    std::erase_if(events, [=](const auto& event) { return -event[3] <= count_speed; });
    const json& impacts = run.at("impacts");
    ASSERT_EQ(impacts.at("time").size(), events.size());
    ASSERT_EQ(impacts.at("left_out"), 0);
    for (std::size_t i = 0; i < events.size(); ++i) {
      const auto agrees = [&](const char* column, double exact) {
        const double value = impacts.at(column).at(i);
        EXPECT_NEAR(value, exact, 5.1e-6 * std::abs(exact)) << column << ' ' << i;
      };
      agrees("time", events[i][0]);
      agrees("cable", events[i][1]);
      agrees("rate_before", events[i][3]);
      agrees("rate_after", events[i][4]);
      agrees("steps", events[i][6]);
    }
  }
}

}  // namespace
}  // namespace tautline::test
