#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

/// Enough runs to be caught in the middle, few enough to repeat.
std::vector<std::string> suite(const fs::path& out, const std::string& steps = "1e-3") {
  return {"bench",    "breakwater/1910*", "--engines", "exact,bullet64,ode",
          "--models", "row,event",        "--steps",   steps,
          "--out",    out.string()};
}

/// The report without what may differ from run to run.
json comparable(const fs::path& out) {
  json report = json::parse(content_of(out / "report.json"), nullptr, false);
  if (report.is_object()) {
    report.erase("context");
  }
  return report;
}

std::size_t finished_runs(const fs::path& out) {
  std::size_t count = 0;
  std::error_code ignored;
  for (const auto& entry : fs::recursive_directory_iterator(out, ignored)) {
    count += entry.path().filename() == "result.json" ? 1U : 0U;
  }
  return count;
}

/// The report of the whole suite, not interrupted.
const json& whole_report() {
  static const json report = [] {
    const TemporaryFolder folder;
    EXPECT_EQ(program(suite(folder.path() / "whole")).code, 0);
    return comparable(folder.path() / "whole");
  }();
  return report;
}

/// Starts the suite, sends `signal` when a few runs are done, and waits; the exit code. On a
/// machine that stops this test for a while the suite may be over by then, and is started anew.
int interrupted_suite(const fs::path& out, int signal) {
  const std::size_t all = whole_report().at("runs").size();
  constexpr int tries = 10;
  int code = 0;
  for (int trial = 0; trial < tries && (code == 0 || finished_runs(out) == all); ++trial) {
    fs::remove_all(out);
    const int process = start_program(suite(out));
    constexpr auto patience = std::chrono::minutes(10);
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (finished_runs(out) < 5 && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ::kill(process, signal);
    code = wait_for(process);
  }
  return code;
}

class Interrupted : public testing::TestWithParam<int> {};

TEST_P(Interrupted, SuiteIsCompletedByResumeWithAnEqualReport) {
  const TemporaryFolder folder;
  const json& whole = whole_report();
  ASSERT_TRUE(whole.is_object());

  const fs::path out = folder.path() / "broken";
  EXPECT_NE(interrupted_suite(out, GetParam()), 0);
  const std::size_t before = finished_runs(out);
  EXPECT_GE(before, 5U);
  EXPECT_LT(before, whole.at("runs").size()) << "nothing was left to resume";
  for (const auto& entry : fs::recursive_directory_iterator(out)) {
    if (entry.path().filename() == "result.json") {
      const std::string text = content_of(entry.path());
      EXPECT_FALSE(json::parse(text, nullptr, false).is_discarded()) << entry.path();
    }
  }

  std::vector<std::string> again = suite(out);
  again.emplace_back("--resume");
  const Outcome outcome = program(again);
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(comparable(out), whole);
  const json report = json::parse(content_of(out / "report.json"));
  EXPECT_GE(report.at("context").at("kept_runs").get<std::size_t>(), before);
}

INSTANTIATE_TEST_SUITE_P(By, Interrupted, testing::Values(SIGKILL, SIGINT, SIGTERM),
                         [](const auto& test) {
                           return test.param == SIGKILL  ? "Kill9"
                                  : test.param == SIGINT ? "CtrlC"
                                                         : "Terminate";
                         });

TEST(Interrupted, CtrlCLeavesAReadableReportThatSaysSo) {
  const TemporaryFolder folder;
  EXPECT_EQ(interrupted_suite(folder.path() / "r", SIGINT), 1);
  const json report = comparable(folder.path() / "r");
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report.at("complete"), false);
  EXPECT_GE(report.at("runs").size(), 5U);
  EXPECT_NE(content_of(folder.path() / "r/report.md").find("INCOMPLETE"), std::string::npos);
}

TEST(Resume, DoesNotKeepARunOfOtherSettings) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "r";
  const std::vector<std::string> one = {"bench",   "bouncing-ball", "--engines", "exact",
                                        "--steps", "1e-2",          "--out",     out.string()};
  ASSERT_EQ(program(one).code, 0);
  auto shorter = one;
  shorter.insert(shorter.end(), {"--until", "1", "--resume"});
  ASSERT_EQ(program(shorter).code, 0);
  const json report = json::parse(content_of(out / "report.json"));
  EXPECT_EQ(report.at("context").at("kept_runs"), 0);
  EXPECT_EQ(report.at("runs").at(0).at("details").at("whole").at("until"), 1.0);
}

TEST(Suite, RunTwiceGivesAnIdenticalReportButForItsContext) {
  const TemporaryFolder folder;
  ASSERT_EQ(program(suite(folder.path() / "one", "1e-2")).code, 0);
  ASSERT_EQ(program(suite(folder.path() / "two", "1e-2")).code, 0);
  const auto text = [](const fs::path& out) {
    const std::string whole = content_of(out / "report.json");
    return whole.substr(0, whole.find("\n \"context\""));
  };
  const std::string first = text(folder.path() / "one");
  EXPECT_GT(first.size(), 10'000U);
  EXPECT_EQ(first, text(folder.path() / "two"));
}

}  // namespace
}  // namespace tautline::test
