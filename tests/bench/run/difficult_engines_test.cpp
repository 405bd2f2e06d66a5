// Engines that throw, loop, end the process or print at every step, on cases that make them.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

constexpr double time_limit = 10.0;  // [s], of a run

TEST(DifficultEngines, AreCleanRows) {
  // Siconos loses its integration on the first; ODE's bodies leave every range; a run of Simbody's
  // events takes minutes; its rope prints at every step. A run may also end at its time limit
  const std::set<std::string> built = built_engines();
  std::string engines;
  for (const std::string name : {"ode", "simbody", "siconos"}) {
    if (built.contains(name)) {
      engines += (engines.empty() ? "" : ",") + name;
    }
  }
  if (engines.empty()) {
    GTEST_SKIP() << "none of them is built";
  }
  static const std::regex progress("\\d+ of \\d+ runs, about [^\n]* left\n");
  const TemporaryFolder folder;
  const Outcome outcome =
      program({"bench", TAUTLINE_TEST_DATA "/redundant/f174.toml",
               TAUTLINE_TEST_DATA "/redundant/g93.toml", "--engines", engines, "--steps", "1e-2",
               "--time-limit", std::to_string(time_limit), "--out", folder.path().string()});
  EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.errors;
  const std::string told = std::regex_replace(outcome.errors, progress, "");
  EXPECT_EQ(told, "") << "an engine reached our terminal";

  const json report = json::parse(content_of(folder.path() / "report.json"));
  EXPECT_TRUE(report["complete"]);
  EXPECT_EQ(report["runs"].size(), report["planned_runs"]);
  for (const json& run : report["runs"]) {
    const std::string row = run["engine"].get<std::string>() + " " +
                            run["model"].get<std::string>() + " on " +
                            run["case"].get<std::string>();
    const std::string status = run["status"];
    EXPECT_TRUE(std::set<std::string>({"finished", "stopped", "diverged", "failed", "unsupported"})
                    .contains(status))
        << row << ": " << status;
    EXPECT_EQ(status == "finished", run["reason"].get<std::string>().empty()) << row;
  }
}

}  // namespace
}  // namespace tautline::test
