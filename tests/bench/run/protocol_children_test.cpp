// Children that go wrong: each makes one clear row, and none leaves a process behind.
#include <gtest/gtest.h>

#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "bench/run/plugin.hpp"
#include "tests/bench/run/protocol_support.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// How one child goes wrong, and what the report must say of it.
struct BadChild {
  std::string way;
  std::string status;  // of its run; "" if it does not even answer what it is
  std::string reason;  // part of the sentence
};

const std::vector<BadChild>& every_child() {
  static const std::vector<BadChild> ways = {
      {"noise", "failed",
       "what is no message: Loading the engine ...; what a library prints must go to standard "
       "error"},
      {"half-a-line", "failed", "exit code 0 before it answered step in the middle of a line: {"},
      {"endless-line", "failed", "wrote a line of more than 1048576 bytes"},
      {"wrong-id", "failed", "id is 1000"},
      {"nan", "failed", "JSON has no NaN, say \"NaN\""},
      {"nan-word", "diverged", "left every reasonable range after t = 0.09"},
      {"out-of-range", "failed", "a message is whole JSON, and its numbers are doubles"},
      {"nests", "failed", "the engine's answer to step: steps is an object, must be an array"},
      {"pushes", "failed", "[6] is -1.0, must be an impulse of at least 0"},
      {"raises", "failed",
       "ended by itself with exit code 1 before it answered step; it printed: ValueError: lost"},
      {"null", "failed", "steps[2][2] is null, must be a number"},
      {"too-few", "failed", "answered 7 steps where 8 were asked, and not why it stopped"},
      {"too-wide", "failed", "must be 7 numbers: x, y, angle, vx, vy, spin, then the impulse"},
      {"wrapped", "failed", "angle went from 0 to -6.28319 in 0.01 s"},
      {"forks", "finished", ""},
      {"exits", "failed", "ended by itself with exit code 0 before it answered step"},
      {"crashes", "failed", "the engine crashed: SIGSEGV before it answered step"},
      {"gives-up", "failed", "gave up before the horizon: the fixture has had enough"},
      {"throws-at-start", "failed", "the engine has no such body"},
      {"slips", "failed", "unknown key stoped; did you mean stopped?"},
      {"answers-after-the-end", "finished", ""},
      {"mute", "", "ended by itself with exit code 3 before it answered info"},
      {"lacks-a-module", "",
       "exit code 1 before it answered info; it printed: Error: Cannot find module 'rope'"},
      {"wrong-name", "", "the engine says that its name is other"},
      {"wrong-protocol", "", "protocol is 3, must be 1 or 2, the protocols of this program"}};
  return ways;
}

/// One report of all these children.
class BadChildren : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!has_python()) {
      return;
    }
    const TemporaryFolder folder;
    std::string engines;
    for (const BadChild& child : every_child()) {
      engines += (engines.empty() ? "" : ",") + bad_child(folder, child.way);
    }
    const std::string mark = folder.path().string();
    const std::string out = (folder.path() / "results").string();
    outcome() = program({"bench", "bouncing-ball", "--engines", engines, "--models", "row",
                         "--steps", "1e-2", "--until", "2", "--jobs", "2", "--out", out},
                        "TAUTLINE_MARK=" + mark);
    left() = left_of(mark);
    report() = json::parse(content_of(out + "/report.json"), nullptr, false);
  }
  void SetUp() override {
    if (!has_python()) {
      GTEST_SKIP() << no_python;
    }
    ASSERT_FALSE(report().is_discarded()) << outcome().errors;
  }

  static Outcome& outcome() {
    static Outcome outcome;
    return outcome;
  }
  static json& report() {
    static json report;
    return report;
  }
  static std::vector<int>& left() {
    static std::vector<int> left;
    return left;
  }
};

json of_engine(const json& rows, const char* key, const std::string& name) {
  json found = json::array();
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(found),
               [&](const json& row) { return row.at(key) == name; });
  return found;
}

TEST_F(BadChildren, GiveOneClearRowEach) {
  EXPECT_EQ(outcome().code, 1) << outcome().errors;
  for (const auto& [way, status, reason] : every_child()) {
    const json runs = of_engine(report().at("runs"), "engine", way);
    std::string said;
    if (status.empty()) {
      EXPECT_TRUE(runs.empty()) << way;
      for (const json& engine : report().at("engines")) {
        said += engine.at("problem").is_string() ? engine.at("problem").get<std::string>() : "";
      }
    } else {
      ASSERT_EQ(runs.size(), 1U) << way;
      EXPECT_EQ(runs[0].at("status"), status) << way << ": " << runs[0].at("reason");
      said = runs[0].at("reason").get<std::string>();
    }
    EXPECT_NE(said.find(reason), std::string::npos) << way << " says: " << said;
  }
}

TEST_F(BadChildren, LeaveNoProcessBehind) { EXPECT_EQ(left(), std::vector<int>()); }

/// A run of the child that goes wrong in this way; what is left of it is looked at.
Outcome run_alone(const std::string& way, const std::string& limit) {
  const TemporaryFolder folder;
  const std::string mark = folder.path().string();
  Outcome outcome = program({"run", "bouncing-ball", "--engine", bad_child(folder, way), "--model",
                             "row", "--step", "1e-2", "--time-limit", limit},
                            "TAUTLINE_MARK=" + mark);
  EXPECT_EQ(left_of(mark), std::vector<int>()) << way;
  return outcome;
}

/// How many processes of this child three runs took, one after another.
std::size_t processes_of_three_runs(const std::string& way) {
  const TemporaryFolder folder;
  const std::string mark = folder.path().string();
  const Outcome outcome = program(
      {"bench", "bouncing-ball", "--engines", bad_child(folder, way), "--models", "row", "--steps",
       "1e-2,8e-3,5e-3", "--jobs", "1", "--out", (folder.path() / "results").string()},
      "TAUTLINE_MARK=" + mark);
  EXPECT_EQ(left_of(mark), std::vector<int>()) << way << ": " << outcome.errors;
  return content_of(mark + "/" + way + ".starts").size();
}

TEST(Children, ServeOneRunAfterAnotherUntilOneFails) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  constexpr std::size_t to_be_asked_who_it_is = 1;
  EXPECT_EQ(processes_of_three_runs("sound"), to_be_asked_who_it_is + 1);
  EXPECT_EQ(processes_of_three_runs("exits"), to_be_asked_who_it_is + 3);
}

TEST(BadChild, ThatSleepsIsEndedWithAllItStarted) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Outcome outcome = run_alone("forks-and-sleeps", "2");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("timed out after 2 s"), std::string::npos) << outcome.output;
}

TEST(BadChild, ThatEatsMemoryIsEnded) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  constexpr std::size_t memory = std::size_t{256} << 20U;
  for (const char* const way : {"eats-memory", "forks-eat-memory"}) {
    const TemporaryFolder folder;
    const std::string mark = folder.path().string();
    ::setenv("TAUTLINE_MARK", mark.c_str(), 1);
    const bench::Plugin plugin = bench::Plugin::open(bad_child(folder, way), memory);
    ::unsetenv("TAUTLINE_MARK");
    Case the_case;
    the_case.cables.resize(1);
    the_case.initial.position = Vec2(0.0, -0.5);
    const auto simulation = plugin.engine().start(the_case, "row", 0.01);
    std::string said;
    for (int step = 0; step < 10 && said.empty(); ++step) {
      try {
        simulation->step(0.01);
      } catch (const std::exception& error) {
        said = error.what();
      }
    }
    EXPECT_TRUE(said.starts_with("ran out of memory: the engine held")) << way << ": " << said;
    EXPECT_EQ(left_of(mark), std::vector<int>()) << way;
  }
}

TEST(BadChild, DiesWithAProgramThatIsKilled) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const TemporaryFolder folder;
  const std::string mark = folder.path().string();
  ::setenv("TAUTLINE_MARK", mark.c_str(), 1);
  const int process =
      start_program({"run", "bouncing-ball", "--engine", bad_child(folder, "forks-and-sleeps"),
                     "--model", "row", "--step", "1e-2"});
  ::unsetenv("TAUTLINE_MARK");
  // the program, its worker, the keeper, the child, and three that have made themselves sessions
  constexpr std::size_t all = 7;
  constexpr auto pause = std::chrono::milliseconds(10);
  for (int look = 0; look < 12'000 && !std::filesystem::exists(folder.path() / "ready"); ++look) {
    std::this_thread::sleep_for(pause);
  }
  EXPECT_EQ(marked_processes(mark).size(), all);
  ::kill(process, SIGKILL);
  static_cast<void>(wait_for(process));
  EXPECT_EQ(left_of(mark), std::vector<int>());
}

}  // namespace
}  // namespace tautline::test
