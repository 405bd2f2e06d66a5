// Where the deviation of the engines themselves comes from, on those that are built.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>

#include "program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// The parts must be the whole within this share of it [-].
constexpr double most_remainder = 0.05;

/// The report of all models of some engines that are built, on cases that bounce, lock and swing.
json report_of(const TemporaryFolder& out, const std::vector<std::string>& engines) {
  std::vector<std::string> arguments = {"bench",
                                        "breakwater/1910121100",
                                        "breakwater/1510121100",
                                        "breakwater/2911121100",
                                        "--steps",
                                        "1e-2,1e-3",
                                        "--out",
                                        (out.path() / "r").string()};
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
  const json report = report_of(out, {"exact", "bullet64", "bullet32", "ode", "mujoco", "dart",
                                      "siconos", "box2d", "chipmunk"});
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
  EXPECT_GT(with_parts, runs * 3 / 4) << "of " << runs;
  std::cout << with_parts << " of " << runs << " runs have parts\n";
}

TEST(AttributionOfEngines, NamesWhatIsKnownOfThem) {
  const TemporaryFolder out;
  const json report = report_of(out, {"bullet64", "ode"});
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

}  // namespace
}  // namespace tautline::test
