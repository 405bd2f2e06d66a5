#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

Words operator+(Words one, const Words& more) {
  one.insert(one.end(), more.begin(), more.end());
  return one;
}

/// Twelve runs of two cases.
const Words small_suite = {"bench",
                           "bouncing-ball",
                           "breakwater/1510121100",
                           "--until",
                           "3",
                           "--engines",
                           "exact,bullet64",
                           "--models",
                           "row,event",
                           "--steps",
                           "1e-2,5e-3"};
constexpr std::size_t small_suite_runs = 12;

Words shard_of(const Words& suite, const std::string& shard, const fs::path& out) {
  return suite + Words{"--shard", shard, "--out", out.string()};
}

Words merge_of(const std::vector<fs::path>& trees, const fs::path& out) {
  Words words = {"merge"};
  for (const fs::path& tree : trees) {
    words.push_back(tree.string());
  }
  return words + Words{"--out", out.string()};
}

/// The report up to `context`, which holds all that may differ: times, costs, machine, command.
std::string before_context(const fs::path& out) {
  const std::string whole = content_of(out / "report.json");
  EXPECT_NE(whole.find("\n \"context\""), std::string::npos) << out;
  return whole.substr(0, whole.find("\n \"context\""));
}

json report_in(const fs::path& out) { return json::parse(content_of(out / "report.json")); }

/// The relative path of every file below `folder` but those that hold times, with its content.
std::map<std::string, std::string> run_files(const fs::path& folder) {
  std::map<std::string, std::string> result;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "runs")) {
    if (entry.is_regular_file() && entry.path().filename() != "result.json") {
      result[fs::relative(entry.path(), folder)] = content_of(entry.path());
    }
  }
  return result;
}

/// A folder with the small suite done at once, and in two shards: made once, looked at by several.
class Merge : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder = new TemporaryFolder();
    EXPECT_EQ(program(small_suite + Words{"--out", path("whole").string()}).code, 0);
    for (const std::string number : {"1", "2"}) {
      const Outcome outcome = program(shard_of(small_suite, number + "/2", path(number)));
      EXPECT_EQ(outcome.code, 0) << outcome.errors;
    }
  }
  static void TearDownTestSuite() {
    delete folder;
    folder = nullptr;
  }

  static fs::path path(const std::string& name) { return folder->path() / name; }

  static TemporaryFolder* folder;  // NOLINT: shared by the tests
};
TemporaryFolder* Merge::folder = nullptr;  // NOLINT

TEST_F(Merge, OfTwoShardsIsTheReportOfOneMachineButForItsContext) {
  const Outcome outcome = program(merge_of({path("2"), path("1")}, path("merged")));
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  const std::string whole = before_context(path("whole"));
  EXPECT_GT(whole.size(), 10'000U);
  EXPECT_EQ(before_context(path("merged")), whole);
  EXPECT_EQ(run_files(path("merged")), run_files(path("whole")));
  const json report = report_in(path("merged"));
  EXPECT_EQ(report.at("complete"), true);
  EXPECT_EQ(report.at("runs").size(), small_suite_runs);
  const json& shards = report.at("context").at("shards");
  ASSERT_EQ(shards.size(), 2U);
  EXPECT_EQ(shards.at(0).at("number"), 1);
  EXPECT_NE(shards.at(1).at("command").get<std::string>().find("--shard 2/2"), std::string::npos);
}

/// Runs `suite` in so many shards and merges them into `merged`.
void merge_shards(const Words& suite, std::size_t of, const fs::path& folder) {
  std::vector<fs::path> paths;
  for (std::size_t number = 1; number <= of; ++number) {
    paths.push_back(folder / std::to_string(number));
    const std::string shard = std::to_string(number) + "/" + std::to_string(of);
    const Outcome outcome = program(shard_of(suite, shard, paths.back()));
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
  }
  EXPECT_EQ(program(merge_of(paths, folder / "merged")).code, 0);
}

TEST_F(Merge, OfThreeShardsIsTheSame) {
  const TemporaryFolder trees;
  merge_shards(small_suite, 3, trees.path());
  EXPECT_EQ(before_context(trees.path() / "merged"), before_context(path("whole")));
}

TEST(Shards, MayBeMoreThanThereAreRuns) {
  const TemporaryFolder trees;
  const Words two_runs = {"bench",    "bouncing-ball", "elastic-box", "--engines", "exact",
                          "--models", "event",         "--steps",     "1e-2"};
  ASSERT_EQ(program(two_runs + Words{"--out", (trees.path() / "whole").string()}).code, 0);
  merge_shards(two_runs, 4, trees.path());
  EXPECT_EQ(before_context(trees.path() / "merged"), before_context(trees.path() / "whole"));
}

TEST_F(Merge, ShardSaysThatItIsOne) {
  const json report = report_in(path("1"));
  EXPECT_EQ(report.at("complete"), false);
  EXPECT_EQ(report.at("planned_runs"), small_suite_runs);
  EXPECT_EQ(report.at("runs").size() + report_in(path("2")).at("runs").size(), small_suite_runs);
  EXPECT_NE(content_of(path("1") / "report.md").find("INCOMPLETE"), std::string::npos);
}

TEST_F(Merge, OfAMergedTreeIsThatTree) {
  ASSERT_EQ(program(merge_of({path("1"), path("2")}, path("once"))).code, 0);
  ASSERT_EQ(program(merge_of({path("once")}, path("twice"))).code, 0);
  EXPECT_EQ(before_context(path("twice")), before_context(path("whole")));
}

TEST_F(Merge, WithoutAShardReportsTheOthersAndSaysSo) {
  const Outcome outcome = program(merge_of({path("2")}, path("half")));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("shard 1 of 2 is missing"), std::string::npos) << outcome.errors;
  const json report = report_in(path("half"));
  EXPECT_EQ(report.at("complete"), false);
  EXPECT_EQ(report.at("runs").size(), report_in(path("2")).at("runs").size());
}

TEST_F(Merge, WithoutARunOfAShardReportsTheOthersAndSaysSo) {
  fs::copy(path("1"), path("cut"), fs::copy_options::recursive);
  std::size_t removed = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path("cut"))) {
    if (removed == 0 && entry.path().filename() == "result.json") {
      removed += fs::remove(entry.path()) ? 1U : 0U;
    }
  }
  const Outcome outcome = program(merge_of({path("cut"), path("2")}, path("torn")));
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("cut: lacks 1 of the "), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("--resume"), std::string::npos);
  EXPECT_EQ(report_in(path("torn")).at("runs").size(), small_suite_runs - 1);
}

TEST_F(Merge, JudgesByTheProblemsOfItsGateAsBenchDoes) {
  const std::string limits = folder->file("problems.toml", R"(schema = 2
version = "1"
[[problem]]
engine = "bullet64"
model = "row"
kind = "overstretch"
reason = "it has none, which breaks the gate"
)");
  const Outcome whole =
      program(small_suite + Words{"--gate", limits, "--out", path("gated").string()});
  const Outcome merged =
      program(merge_of({path("1"), path("2")}, path("gated-too")) + Words{"--gate", limits});
  EXPECT_EQ(whole.code, 1);
  EXPECT_EQ(merged.code, 1);
  EXPECT_EQ(before_context(path("gated-too")), before_context(path("gated")));
  const auto verdict = [](const std::string& text) { return text.substr(text.rfind("\n\n")); };
  EXPECT_EQ(verdict(merged.output), verdict(whole.output));
  const Outcome shard = program(shard_of(small_suite, "1/2", path("no")) + Words{"--gate", limits});
  EXPECT_EQ(shard.code, 2);
  EXPECT_NE(shard.errors.find("--gate"), std::string::npos) << shard.errors;
}

/// A merge that is refused.
struct Refused {
  std::string what;
  Words trees;
  std::string says;
};

TEST_F(Merge, RefusesWhatDoesNotBelongTogether) {
  // the second shard as it would be if its suite.json said this instead
  const json manifest = json::parse(content_of(path("2") / "suite.json"));
  const auto altered = [&](const std::string& name, const char* place, const json& value) {
    json other = manifest;
    other[json::json_pointer(place)] = value;
    fs::create_directory(path(name));
    static_cast<void>(folder->file(name + "/suite.json", other.dump()));
  };
  const auto ball_with = [&](const std::string& old, const std::string& other) {
    std::string text = manifest.at("cases").at(1).get<std::string>();
    EXPECT_NE(text.find(old), std::string::npos) << text;
    return text.replace(text.find(old), old.size(), other);
  };
  altered("steps", "/options/steps", {0.01});
  altered("engines", "/engines", json::array({manifest.at("engines").at(0)}));
  altered("plug-in", "/engines/1/plugin", "0123456789abcdef");
  altered("engine version", "/engines/1/version", "3.26");
  altered("models", "/models", {"event"});
  altered("until", "/cases/1", ball_with("duration = 3.0", "duration = 2.0"));
  altered("cases", "/cases/1", ball_with("bouncing-ball", "bouncing-cube"));
  altered("no case", "/cases/1", "mass = 1");
  altered("law", "/options/law", "poisson");
  altered("time", "/options/time_limit", 50.0);
  altered("third", "/shard/of", 3);
  altered("version", "/program/version", "0.0.1");
  altered("build", "/program/hash", "0123456789abcdef");
  fs::create_directory(path("nothing"));
  const std::vector<Refused> all = {
      {"a shard twice", {"1", "2", "2"}, "is shard 2/2, and so is "},
      {"another plug-in", {"1", "plug-in"}, "has another plug-in for bullet64 than "},
      {"another engine", {"1", "engine version"}, "has bullet64 3.26, must have 3."},
      {"no case", {"1", "no case"}, "its suite.json makes no sense"},
      {"other steps", {"1", "steps"}, "has the steps 0.01, must have 0.01, 0.005 as "},
      {"other engines", {"1", "engines"}, "lacks the engine bullet64"},
      {"other models", {"1", "models"}, "has models event, must have row, event as "},
      {"another duration", {"1", "until"}, "has another case bouncing-ball than "},
      {"other cases", {"1", "cases"}, "has the case bouncing-cube, which "},
      {"another law", {"1", "law"}, "has the law poisson, must have simultaneous as "},
      {"another limit", {"1", "time"}, "has the time limit 50 s, must have 60 s as "},
      {"another number", {"1", "third"}, "has a number of shards of 3, must have 2"},
      {"another version", {"1", "version"}, "was written by tautline 0.0.1, must be of "},
      {"another build", {"1", "build"}, "was written by another build of tautline "},
      {"an empty folder", {"1", "nothing"}, "nothing: is not a result tree"},
      {"no folder", {"1", "no-such"}, "no-such: is not a result tree"},
  };
  for (const Refused& refused : all) {
    std::vector<fs::path> trees;
    for (const std::string& tree : refused.trees) {
      trees.push_back(path(tree));
    }
    const Outcome outcome = program(merge_of(trees, path("refused")));
    EXPECT_EQ(outcome.code, 2) << refused.what;
    EXPECT_NE(outcome.errors.find(refused.says), std::string::npos)
        << refused.what << ": " << outcome.errors;
    EXPECT_FALSE(fs::exists(path("refused"))) << refused.what;
  }
  // a tree, a folder that holds the trees, and one inside a tree: clearing it would clear them
  for (const fs::path& out : {path("1"), path("."), path("2") / "inner"}) {
    const Outcome outcome = program(merge_of({path("1"), path("2")}, out));
    EXPECT_EQ(outcome.code, 2) << out;
    EXPECT_NE(outcome.errors.find("is, holds or lies in the tree"), std::string::npos)
        << outcome.errors;
  }
  EXPECT_TRUE(fs::exists(path("1") / "suite.json"));
  EXPECT_TRUE(fs::exists(path("2") / "suite.json"));
}

TEST(Bench, WithoutCasesRunsTheQuickSuiteAndNamesItsTime) {
  const TemporaryFolder folder;
  const Outcome outcome = program({"bench", "--engines", "exact", "--models", "event",
                                   "--no-certify", "--out", (folder.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("\nquick suite: 12 runs in "), std::string::npos) << outcome.output;
  const json report = report_in(folder.path() / "r");
  EXPECT_EQ(report.at("options").at("steps"), json({1e-2, 1e-3}));
  EXPECT_EQ(report.at("cases").size(), 6U);
  EXPECT_TRUE(report.at("cases").at(0).at("certified").is_null());
}

// as `tautline solve --certify` says, in the report, on the page and in the text
TEST(Bench, CertifiesTheDigitsOfItsCases) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "r";
  const Outcome outcome =
      program({"bench", "breakwater/1910121100", "level-beam", "--certify", "--engines", "exact",
               "--models", "event", "--steps", "0.01", "--out", out.string()});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json certified = report_in(out).at("cases").at(0).at("certified");
  const Outcome solved = program({"solve", "breakwater/1910121100", "--certify", "--json", "-"});
  const json correct = json::parse(solved.output).at("certificate").at("correct");
  for (std::size_t place = 0; place < 3; ++place) {
    EXPECT_EQ(certified.at("correct").at(place).at("digits"), correct.at(place).at("digits"));
    EXPECT_EQ(certified.at("correct").at(place).at("until"), correct.at(place).at("until"));
  }
  EXPECT_EQ(correct.at(0).at("digits"), 9);
  EXPECT_GT(correct.at(0).at("until"), 7.0);
  EXPECT_NE(content_of(out / "index.html").find("id=\"certified-table\""), std::string::npos);
  EXPECT_NE(content_of(out / "report.md").find("Compared with the same motions in many digits"),
            std::string::npos);
}

TEST(Bench, SuiteIsOneOfThoseThereAreAndNotBesideCases) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "r").string();
  const Outcome chapter = program({"bench", "--suite", "chapter", "--engines", "exact", "--models",
                                   "event", "--steps", "0.1", "--until", "1", "--out", out});
  EXPECT_EQ(chapter.code, 0) << chapter.errors;
  EXPECT_EQ(report_in(out).at("cases").size(), 21U);
  for (const json& the_case : report_in(out).at("cases")) {
    EXPECT_TRUE(the_case.at("certified").is_object()) << the_case.at("name");
  }
  const Outcome unknown = program({"bench", "--suite", "swift", "--out", out + "2"});
  EXPECT_EQ(unknown.code, 2);
  EXPECT_NE(
      unknown.errors.find("--suite swift: must be quick, chapter, all, space, systems or elastic"),
      std::string::npos)
      << unknown.errors;
  const Outcome both = program({"bench", "bouncing-ball", "--suite", "all", "--out", out + "2"});
  EXPECT_EQ(both.code, 2);
  EXPECT_NE(both.errors.find("--suite: cases are named too"), std::string::npos) << both.errors;
}

TEST(Shards, WrongOnesAreRefusedWithASentence) {
  for (const char* wrong : {"0/3", "4/3", "a/b", "1/0", "", "2"}) {
    const TemporaryFolder folder;
    const Outcome outcome = program(shard_of(small_suite, wrong, folder.path() / "r"));
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_NE(outcome.errors.find("--shard"), std::string::npos) << wrong << outcome.errors;
    EXPECT_FALSE(fs::exists(folder.path() / "r")) << wrong;
  }
}

TEST(Shards, KilledAndResumedMergesLikewise) {
  const TemporaryFolder folder;
  const Words suite = {"bench",     "breakwater/1[57]10121100",
                       "--engines", "exact,bullet64",
                       "--models",  "row,event",
                       "--steps",   "1e-3,5e-4,2.5e-4",
                       "--until",   "5",
                       "--jobs",    "1"};
  ASSERT_EQ(program(suite + Words{"--out", (folder.path() / "whole").string()}).code, 0);
  ASSERT_EQ(program(shard_of(suite, "2/2", folder.path() / "2")).code, 0);
  const Words first = shard_of(suite, "1/2", folder.path() / "1");
  const auto finished = [&] {
    std::size_t count = 0;
    std::error_code ignored;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "1", ignored)) {
      count += entry.path().filename() == "result.json" ? 1U : 0U;
    }
    return count;
  };
  // on a machine that stops this test for a while the shard may be over by then
  constexpr int tries = 10;
  int code = 0;
  for (int trial = 0; trial < tries && (code == 0 || finished() == 9); ++trial) {
    fs::remove_all(folder.path() / "1");
    const int process = start_program(first);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(10);
    while (finished() < 2 && std::chrono::steady_clock::now() < deadline) {
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ::kill(process, SIGKILL);
    code = wait_for(process);
  }
  EXPECT_NE(code, 0);
  ASSERT_LT(finished(), 9U) << "nothing was left to resume";
  const auto merge = merge_of({folder.path() / "1", folder.path() / "2"}, folder.path() / "merged");
  EXPECT_EQ(program(merge).code, 1) << "not yet whole";
  EXPECT_EQ(report_in(folder.path() / "merged").at("complete"), false);
  ASSERT_EQ(program(first + Words{"--resume"}).code, 0);
  EXPECT_GE(report_in(folder.path() / "1").at("context").at("kept_runs").get<std::size_t>(), 2U);
  EXPECT_EQ(program(merge).code, 0);
  EXPECT_EQ(before_context(folder.path() / "merged"), before_context(folder.path() / "whole"));
}

}  // namespace
}  // namespace tautline::test
