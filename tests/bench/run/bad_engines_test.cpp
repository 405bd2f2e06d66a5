#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// How one plug-in goes wrong, and what the report must say of it.
struct BadEngine {
  std::string way;
  std::string status;  // of its run; "" if it does not even answer what it is
  std::string reason;  // part of the sentence
};

void PrintTo(const BadEngine& engine, std::ostream* out) { *out << engine.way; }

constexpr std::size_t exact_runs = 3;  // models of the exact engine, whose rows come first

class BadEngines : public testing::TestWithParam<BadEngine> {};

TEST_P(BadEngines, GiveOneClearRowAndHarmNothingElse) {
  const auto& [way, status, reason] = GetParam();
  const TemporaryFolder out;
  const Outcome outcome =
      program({"bench", "bouncing-ball", "--engines", "exact," + bad_engine(way), "--steps", "1e-2",
               "--until", "2", "--time-limit", way == "hang" ? "2" : "60", "--out",
               (out.path() / "results").string()});
  const auto report = json::parse(content_of(out.path() / "results/report.json"), nullptr, false);
  ASSERT_FALSE(report.is_discarded()) << outcome.errors;
  const bool harmless = status == "finished";
  const bool refused = status == "unsupported";  // no fault of the engine's
  EXPECT_EQ(outcome.code, harmless || refused ? 0 : 1) << outcome.errors;
  const json& runs = report.at("runs");
  ASSERT_FALSE(runs.empty());
  EXPECT_EQ(runs.at(0).at("engine"), "exact");
  EXPECT_EQ(runs.at(0).at("status"), "finished");
  EXPECT_EQ(runs.at(0).at("metrics").at("whole_position_error"), 0.0);
  if (status.empty()) {
    EXPECT_EQ(runs.size(), exact_runs);
    EXPECT_NE(report.at("engines").at(1).at("problem").get<std::string>().find(reason),
              std::string::npos)
        << report.at("engines").dump(2);
  } else {
    ASSERT_EQ(runs.size(), exact_runs + 1);
    EXPECT_EQ(runs.at(exact_runs).at("status"), status);
    EXPECT_TRUE(!refused || runs.at(exact_runs).at("verdict").at("problems").empty());
    EXPECT_NE(runs.at(exact_runs).at("reason").get<std::string>().find(reason), std::string::npos)
        << runs.at(exact_runs).at("reason");
  }
  const std::string markdown = content_of(out.path() / "results/report.md");
  EXPECT_EQ(markdown.find('\x1b'), std::string::npos) << "control characters reached the report";
  if (!harmless) {
    EXPECT_NE(markdown.find(reason), std::string::npos) << "report.md does not say " << reason;
  }
}

std::vector<BadEngine> every_way() {
  std::vector<BadEngine> ways = {
      {"segfault", "failed", "crashed: SIGSEGV"},
      {"abort", "failed", "crashed: SIGABRT"},
      {"hang", "failed", "timed out after 2 s"},
      {"chatter", "finished", ""},
      {"throw", "failed", "the fixture throws at step 10"},
      {"refuse", "unsupported", "the fixture has no such cable"},
      {"nan", "diverged", "left every reasonable range"},
      {"exit", "failed", "ended by itself with exit code 0 and no result"},
      {"inf", "diverged", "left every reasonable range"},
      {"gives-up", "failed", "gave up before the horizon: the fixture has had enough"},
      {"stop-first", "failed", "gave up before the horizon: the fixture does not do this case"},
      {"stop-nan", "failed", "the engine stopped at a time that is not in the run"},
      {"wrong-cable", "failed", "the engine gave an event that is not of this case"},
      {"no-impulses", "failed", "the engine gave 0 impulses for 1 cables"},
      {"own-exception", "failed", "an error of the module's own"},
      {"mute", "", "crashed: SIGSEGV"},
      {"wrong-interface", "", "tautline-engine 0, from long ago"}};
#ifndef TAUTLINE_SANITIZED  // which leaves no limit on address space in place
  ways.push_back({"memory", "failed", "ran out of memory"});
#endif
  return ways;
}

INSTANTIATE_TEST_SUITE_P(Every, BadEngines, testing::ValuesIn(every_way()), [](const auto& test) {
  std::string name = test.param.way;
  std::erase(name, '-');
  return name;
});

TEST(BadRuns, DoNotStopAResume) {
  const TemporaryFolder folder;
  const std::string engines = bad_engine("inf") + "," + bad_engine("nan") + "," +
                              bad_engine("gives-up") + "," + bad_engine("segfault");
  std::vector<std::string> command = {
      "bench",   "bouncing-ball", "--engines", engines,
      "--steps", "1e-2,1e-3",     "--out",     (folder.path() / "r").string()};
  EXPECT_EQ(program(command).code, 1);
  const auto runs = [&folder] {
    return json::parse(content_of(folder.path() / "r/report.json"), nullptr, false).at("runs");
  };
  const json first = runs();
  EXPECT_EQ(first.size(), 8U);
  command.emplace_back("--resume");
  EXPECT_EQ(program(command).code, 1);
  EXPECT_EQ(runs(), first);
}

TEST(ChatteringEngine, IsCapturedAndItsTailKept) {
  const TemporaryFolder out;
  const Outcome outcome = program({"bench", "bouncing-ball", "--engines", bad_engine("chatter"),
                                   "--steps", "1e-2", "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output.find("likes to talk"), std::string::npos);
  const std::string kept =
      content_of(out.path() / "r/runs/bouncing-ball/chatter/only/0.01/output.txt");
  EXPECT_NE(kept.find("line 199999 of an engine"), std::string::npos) << kept;
  EXPECT_LT(kept.size(), 3000U);
}

}  // namespace
}  // namespace tautline::test
