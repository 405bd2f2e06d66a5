// Where the deviation of the engines themselves comes from, on those that are built.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// The parts must be the whole within this share of it [-].
constexpr double most_remainder = 0.05;

/// The report of some engines that are built, on a case that bounces, locks and swings. The parts
/// are those of its first impacts, whatever comes after 3 s.
json report_of(const TemporaryFolder& out, const std::vector<std::string>& engines,
               const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"bench", "breakwater/1510121100",    "--until", "3",
                                        "--out", (out.path() / "r").string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  for (const std::string& engine : engines) {
    if (built_engines().contains(engine)) {
      arguments.insert(arguments.end(), {"--engines", engine});
    }
  }
  static_cast<void>(program(arguments));
  return json::parse(content_of(out.path() / "r/report.json"));
}

double weight(const json& parts) {
  return std::accumulate(parts.begin(), parts.end(), 0.0, [](double sum, const json& part) {
    return sum + std::abs(part.get<double>());
  });
}

/// The share of some causes in all that a model did at a step, over its runs [-].
double share(const json& report, const std::string& engine, const std::string& model, double step,
             const std::vector<std::string>& wanted) {
  double of_these = 0.0;
  double of_all = 0.0;
  for (const json& run : report.at("runs")) {
    const json& found = run.at("attribution");
    if (run.at("engine") != engine || run.at("model") != model || run.at("step") != step ||
        found.is_null() || found.at("parts").is_null()) {
      continue;
    }
    of_all += weight(found.at("parts"));
    for (const std::string& cause : wanted) {
      of_these += std::abs(found.at("parts").at(cause).get<double>());
    }
  }
  return of_all > 0.0 ? of_these / of_all : 0.0;
}

TEST(AttributionOfEngines, PartsAreTheWholeForEveryEngineAndModel) {
  const TemporaryFolder out;
  const json report = report_of(
      out,
      {"exact", "bullet64", "bullet32", "ode", "mujoco", "dart", "siconos", "box2d", "chipmunk"},
      {"--steps", "1e-2"});
  std::size_t with_parts = 0;
  std::size_t runs = 0;
  for (const json& run : report.at("runs")) {
    const json& found = run.at("attribution");
    if (found.is_null()) {
      EXPECT_TRUE(run.at("metrics").is_null()) << run.at("engine") << run.at("model");
      continue;
    }
    ++runs;
    const json& parts = found.at("parts");
    if (parts.is_null()) {
      EXPECT_NE(found.at("reason"), "") << run.at("engine") << run.at("model");
      continue;
    }
    ++with_parts;
    const double deviation = found.at("deviation");
    double sum = found.at("remainder");
    for (const json& part : parts) {
      sum += part.get<double>();
    }
    EXPECT_NEAR(sum, deviation, 1e-6 * deviation + 1e-15) << found;  // six digits are in the report
    EXPECT_LE(std::abs(found.at("remainder").get<double>()), most_remainder * deviation)
        << run.at("case") << run.at("engine") << run.at("model") << run.at("step") << found;
  }
  EXPECT_GT(runs, 0U);
  EXPECT_EQ(with_parts, runs);
  std::cout << with_parts << " of " << runs << " runs have parts\n";
}

TEST(AttributionOfEngines, NamesWhatIsKnownOfThem) {
  const TemporaryFolder out;
  const json report = report_of(
      out, {"bullet64", "ode", "box2d", "chipmunk"},
      {"--steps", "1e-3", "--models", "row,contact,contact-tuned,distance-joint,slide-joint"});
  // rows of fixed steps have the errors of fixed steps, and their solver none
  for (const char* engine : {"bullet64", "ode"}) {
    if (built_engines().contains(engine)) {
      EXPECT_GT(share(report, engine, "row", 1e-3, {"flight_bias", "event_lag", "late_rate"}), 0.8)
          << engine;
      EXPECT_LT(share(report, engine, "row", 1e-3, {"solver_residual"}), 0.1) << engine;
    }
  }
  // Bullet's contacts push the overstretch out on top of the bounce, and lose slow bounces
  if (built_engines().contains("bullet64")) {
    EXPECT_GT(
        share(report, "bullet64", "contact", 1e-3, {"position_correction", "threshold"}),
        share(report, "bullet64", "contact", 1e-3, {"flight_bias", "event_lag", "late_rate"}));
    EXPECT_LT(share(report, "bullet64", "contact-tuned", 1e-3, {"position_correction"}), 0.2);
  }
}

/// The mean share of a cause in the table [-].
double mean_share(const json& report, const json& finding, double step, const char* cause) {
  for (const json& row : report.at("causes")) {
    if (row.at("engine") == finding.at("engine") && row.at("model") == finding.at("model") &&
        row.at("step") == step && !row.at("shares").is_null()) {
      return row.at("shares").at(cause);
    }
  }
  ADD_FAILURE() << "no causes of " << finding;
  return 0.0;
}

TEST(AttributionOfEngines, AgreesWithWhatTheAuditFinds) {
  const TemporaryFolder out;
  std::vector<std::string> arguments = {"bench",
                                        "breakwater/1710121100",
                                        "breakwater/1510121100",
                                        "--until",
                                        "2.5",
                                        "--steps",
                                        "1e-3",
                                        "--out",
                                        (out.path() / "r").string()};
  std::string models = "row";
  for (const auto& [engine, model] :
       {std::pair("bullet64", "contact"), std::pair("ode", "contact"),
        std::pair("box2d", "distance-joint"), std::pair("chipmunk", "slide-joint")}) {
    if (built_engines().contains(engine)) {
      arguments.insert(arguments.end(), {"--engines", engine});
      models += std::string(",") + model;
    }
  }
  for (const char* flaw : {"no-restitution", "threshold"}) {
    arguments.insert(arguments.end(), {"--engines", bad_engine(flaw)});
  }
  arguments.insert(arguments.end(), {"--models", models});
  static_cast<void>(program(arguments));
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  std::size_t ignored = 0;
  std::size_t thresholds = 0;
  for (const json& finding : report.at("findings")) {
    const auto share = [&](const char* cause) { return mean_share(report, finding, 1e-3, cause); };
    if (finding.at("kind") == "none") {
      ++ignored;
      EXPECT_GT(share("restitution_ignored"), 0.5) << finding;
      EXPECT_EQ(share("threshold"), 0.0) << finding;
      EXPECT_LT(share("solver_residual"), 0.2) << finding;
    } else if (finding.at("kind") == "lost-below") {
      ++thresholds;
      EXPECT_GT(share("threshold"), 0.0) << finding;
      EXPECT_EQ(share("restitution_ignored"), 0.0) << finding;
    }
  }
  EXPECT_GE(ignored, 1U);
  EXPECT_GE(thresholds, 1U);
  for (const json& row : report.at("causes")) {
    if (row.at("shares").is_null()) {
      continue;
    }
    double sum = 0.0;
    for (const json& one : row.at("shares")) {
      sum += one.get<double>();
    }
    EXPECT_NEAR(sum, 1.0, 1e-9) << row;
    EXPECT_GT(row.at("covered"), 0.0) << row;
    EXPECT_LE(row.at("covered"), 1.0) << row;
  }
}

/// The attributions of a flawed engine of steps of 1 ms by case, up to `until` [s].
std::map<std::string, json> attributions(const std::string& flaw, const std::string& until) {
  const TemporaryFolder out;
  static_cast<void>(program({"bench", "breakwater/1910121100", "breakwater/2911121100",
                             "breakwater/1510121100", "--engine", bad_engine(flaw), "--steps",
                             "1e-3", "--until", until, "--out", (out.path() / "r").string()}));
  std::map<std::string, json> result;
  const json report = json::parse(content_of(out.path() / "r/report.json"));
  for (const json& run : report.at("runs")) {
    const json& found = run.at("attribution");
    if (run.at("engine") == flaw && !found.is_null() && !found.at("parts").is_null()) {
      result[run.at("case")] = found;
    }
  }
  return result;
}

struct FlawedRun {
  const char* flaw;
  const char* cause;
  const char* until;  // [s]
  double least;       // [-], of what the flaw adds
};

void PrintTo(const FlawedRun& run, std::ostream* out) { *out << run.flaw; }

class FixedStepFlaw : public testing::TestWithParam<FlawedRun> {};

// What a flaw adds to the parts of the same engine without it, whose fixed steps have errors of
// their own, goes to the cause that it is.
TEST_P(FixedStepFlaw, AddsToItsCause) {
  const auto& [flaw, cause, until, least] = GetParam();
  const auto sound = attributions("sound", until);
  double added = 0.0;
  double of_cause = 0.0;
  std::size_t compared = 0;
  for (const auto& [name, found] : attributions(flaw, until)) {
    if (!sound.contains(name) || sound.at(name).at("until") != found.at("until")) {
      continue;  // at different instants there is nothing to compare
    }
    ++compared;
    for (const auto& [key, part] : found.at("parts").items()) {
      const double without = sound.at(name).at("parts").at(key);
      const double more = std::max(0.0, std::abs(part.get<double>()) - std::abs(without));
      added += more;
      of_cause += key == cause ? more : 0.0;
    }
  }
  ASSERT_GE(compared, 1U);
  ASSERT_GT(added, 0.0);
  EXPECT_GE(of_cause / added, least) << of_cause << " of " << added << " m";
}

INSTANTIATE_TEST_SUITE_P(
    Planted, FixedStepFlaw,
    testing::Values(FlawedRun{"bouncy", "solver_residual", "0.5", 0.75},
                    FlawedRun{"bouncy", "solver_residual", "0.9", 0.85},
                    FlawedRun{"twice", "solver_residual", "0.9", 0.9},
                    FlawedRun{"wrong-inertia", "solver_residual", "0.9", 0.85},
                    FlawedRun{"no-restitution", "restitution_ignored", "0.9", 0.75},
                    FlawedRun{"threshold", "threshold", "0.5", 0.65},
                    FlawedRun{"energy-gain", "position_correction", "0.9", 0.9},
                    FlawedRun{"drift", "flight_bias", "0.9", 0.5}));

// A defect a million times the noise grows beyond first order: the motion's share is told apart.
TEST(AttributionOfEngines, LargeDefectsGrowBeyondFirstOrder) {
  const auto found = attributions("energy-gain", "0.5").at("breakwater/1910121100");
  const json& parts = found.at("parts");
  const double grown = std::abs(parts.at("amplification").get<double>()) / weight(parts);
  EXPECT_GT(grown, 0.05) << found;
  EXPECT_LT(grown, 0.2) << found;
}

}  // namespace
}  // namespace tautline::test
