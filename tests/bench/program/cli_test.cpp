#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <thread>

#include "tautline/case_text.hpp"
#include "tautline/scenarios.hpp"
#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// Arguments that cannot be obeyed, and a part of the one sentence that must say why.
struct BadUsage {
  std::string name;
  std::vector<std::string> arguments;
  std::string sentence;
};

void PrintTo(const BadUsage& usage, std::ostream* out) { *out << usage.name; }

class Program : public testing::TestWithParam<BadUsage> {};

TEST_P(Program, RefusesInOneSentenceWithExitCode2) {
  const Outcome outcome = program(GetParam().arguments);
  EXPECT_EQ(outcome.code, 2) << outcome.output << outcome.errors;
  EXPECT_NE(outcome.errors.find(GetParam().sentence), std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.output, "") << "an error belongs on standard error alone";
  if (outcome.errors.starts_with("tautline: ")) {  // the option parser's own words are two lines
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  }
}

const std::vector<std::string> bench_ball = {"bench", "bouncing-ball", "--engines", "exact"};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

INSTANTIATE_TEST_SUITE_P(
    Bad, Program,
    testing::Values(
        BadUsage{
            "UnknownCase", {"solve", "breakwater/191012110"}, "did you mean breakwater/1910121100"},
        BadUsage{"UnknownEngine",
                 {"run", "bouncing-ball", "--engine", "bulet64", "--model", "row"},
                 "unknown engine bulet64; did you mean bullet64?"},
        BadUsage{"UnknownModel",
                 {"run", "bouncing-ball", "--engine", "bullet64", "--model", "erly"},
                 "unknown model erly; did you mean early?"},
        BadUsage{"ZeroStep", with(bench_ball, {"--steps", "0"}),
                 "step 0 must be a finite number above 0 [s]"},
        BadUsage{"NegativeStep", with(bench_ball, {"--steps=-1e-3"}),
                 "step -0.001 must be a finite number above 0 [s]"},
        BadUsage{"WithinNothing", with(bench_ball, {"--within", "0"}),
                 "--within 0: must be a part of the shortest cable above 0 and below 1, such as "
                 "0.01, or in percent, such as 1%"},
        BadUsage{"WithinLess", with(bench_ball, {"--within=-1 %"}), "--within -1 %: must be"},
        BadUsage{"WithinASpace", with(bench_ball, {"--within", "1 %"}), "--within 1 %: must be"},
        BadUsage{"WithinMore", with(bench_ball, {"--within", "200%"}), "--within 200%: must be"},
        BadUsage{"WithinAll", with(bench_ball, {"--within", "1"}), "--within 1: must be"},
        BadUsage{"WithinNan", with(bench_ball, {"--within", "nan"}), "--within nan: must be"},
        BadUsage{"WithinHex", with(bench_ball, {"--within", "0x1p-3"}), "--within 0x1p-3: must"},
        BadUsage{"WithinEmpty", with(bench_ball, {"--within", ""}), "--within \"\": must be"},
        BadUsage{"NanStep", with(bench_ball, {"--steps", "nan"}),
                 "step nan must be a finite number"},
        BadUsage{
            "AbsurdStep", with(bench_ball, {"--steps", "1e-30"}),
            "step 1e-30 needs 1e+31 steps for case bouncing-ball, which lasts 10 s; at most 1e+09"},
        BadUsage{"ForeignFolder", with(bench_ball, {"--out", "/etc"}),
                 "--out /etc: holds files that `tautline` did not write"},
        BadUsage{"OutIsAFile", with(bench_ball, {"--out", "/etc/passwd"}), "is not a folder"},
        BadUsage{"NegativeDuration",
                 {"solve", "bouncing-ball", "--until=-1"},
                 "duration -1 must be a finite number above 0 [s]"},
        BadUsage{"SampleAfterTheEnd",
                 {"solve", "bouncing-ball", "--at", "1,11"},
                 "sample time 11 is outside [0, 10]: the solution ends there (rest)"},
        BadUsage{"TooFewDigits",
                 {"solve", "bouncing-ball", "--certify", "--digits", "19"},
                 "--digits 19: must be 20 to 1000"},
        BadUsage{"TooManyDigits",
                 {"solve", "bouncing-ball", "--certify", "--digits", "1001"},
                 "--digits 1001: must be 20 to 1000"},
        BadUsage{"NoDigits",
                 {"solve", "bouncing-ball", "--digits", "0"},
                 "--digits 0: must be 1 to 100"},
        BadUsage{"NoEvents",
                 {"solve", "bouncing-ball", "--max-events", "0"},
                 "--max-events 0: must be at least 1"},
        BadUsage{"PatternWhereOneIsMeant",
                 {"run", "breakwater/*", "--engine", "exact", "--model", "event"},
                 "means 21 cases; this command takes one"},
        BadUsage{"NoStiffnesses",
                 {"bridge", "bouncing-ball", "--stiffness", "1e4"},
                 "--stiffness 1e4 is no range of stiffnesses above 0 N/m, such as 1e4..1e8"},
        BadUsage{"OneStiffness",
                 {"bridge", "bouncing-ball", "--stiffness", "1e4..2e4"},
                 "--stiffness 1e4..2e4: the last must be 10 to 1e12 times the first"},
        BadUsage{"TooStiff",
                 {"bridge", "bouncing-ball", "--stiffness", "1e15..1e16"},
                 "bouncing-ball: with a stiffness of 1e+15 N/m: cable 0: its frequency, "},
        BadUsage{"NoImpactToCompare",
                 {"bridge", "bifilar"},
                 "bifilar: there is no impact to compare: at t = 0 cables stay taut"},
        BadUsage{"NoRestitution",
                 {"bridge", "caught-swing"},
                 "caught-swing: cable 0 has restitution 0, to which no damping ratio belongs"},
        BadUsage{"BridgeOfNoImpacts",
                 {"bridge", "bouncing-ball", "--impacts", "0"},
                 "--impacts 0: must be 1 to 1000"},
        BadUsage{"UnknownCommand", {"slove", "x"}, "unknown command slove; did you mean solve?"},
        BadUsage{
            "StrangeCommand", {"xyzzy"}, "unknown command xyzzy; `tautline --help` lists them"},
        BadUsage{"UnknownOption",
                 {"solve", "bouncing-ball", "--untill", "3"},
                 "solve has no option --untill; did you mean --until"},
        BadUsage{"UnknownOptionWithItsValue", with(bench_ball, {"--step=1e-3"}),
                 "bench has no option --step; did you mean --steps"},
        BadUsage{"StrangeOption",
                 {"engines", "--xyzzy"},
                 "engines has no option --xyzzy; `tautline engines --help` lists them"},
        BadUsage{"UnknownOptionWithoutCommand",
                 {"--verison"},
                 "there is no option --verison; did you mean --version?"},
        BadUsage{
            "OneWordTooMany", {"engines", "bullet64"}, "engines takes no further word: bullet64"},
        BadUsage{
            "NoCase", {"solve"}, "solve: CASES is required; `tautline solve --help` says more"},
        BadUsage{"EngineTwice",
                 {"bench", "bouncing-ball", "--engines", "exact,exact"},
                 "engine exact is given twice"},
        BadUsage{"TooManyJobs", with(bench_ball, {"--jobs", "100000"}),
                 "--jobs 100000: must be 1 to 256"},
        BadUsage{"ZeroJobs", with(bench_ball, {"--jobs", "0"}), "--jobs 0: must be 1 to 256"},
        BadUsage{"NegativeJobs", with(bench_ball, {"--jobs=-1"}), "--jobs"},
        BadUsage{"StepTwice", with(bench_ball, {"--steps", "1e-2,0.01"}), "a step is given twice"},
        BadUsage{"NegativeUntil",
                 {"bench", "breakwater/*", "--until=-1"},
                 "--until -1: must be a finite number above 0 [s]"},
        BadUsage{"EmptyOut", with(bench_ball, {"--out", ""}), "--out: is empty"},
        BadUsage{"NanTimeLimitOfRun",
                 {"run", "bouncing-ball", "--engine", "exact", "--model", "event", "--time-limit",
                  "nan"},
                 "--time-limit nan: must be above 0 [s]"},
        BadUsage{"ZeroTimeLimit", with(bench_ball, {"--time-limit", "0"}),
                 "--time-limit 0: must be above 0 [s]"}),
    [](const auto& test) { return test.param.name; });

TEST(Solve, PrintsTheDocumentedJsonForScripts) {
  const Outcome outcome = program({"solve", "breakwater/1910121100", "--json", "-", "--at", "3"});
  EXPECT_EQ(outcome.code, 0);
  const json solution = json::parse(outcome.output);
  EXPECT_EQ(solution.at("schema"), 4);
  EXPECT_EQ(solution.at("ending"), "reached_duration");
  EXPECT_EQ(solution.at("end_time"), 20.0);
  // computed with 60 digits; rounding moves the lock by up to 2.2e-3
  const json& lock = solution.at("settling").at("lock");
  EXPECT_EQ(lock.at("cables"), json::array({0, 1}));
  EXPECT_EQ(lock.at("permanent"), true);
  EXPECT_NEAR(lock.at("time").get<double>(), 8.1288, 5e-3);
  EXPECT_NEAR(lock.at("swing").at("energy").get<double>(), 0.019679140, 1e-8);
  EXPECT_NEAR(lock.at("swing").at("amplitude").get<double>(), 0.65026, 1e-5);
  EXPECT_FALSE(solution.contains("certificate"));
  const json& first = solution.at("events").at(0);
  EXPECT_EQ(first.at("kind"), "impact");
  EXPECT_EQ(first.at("cables"), json::array({0}));
  EXPECT_NEAR(first.at("time").get<double>(), 0.0581974729698846, 1e-15);
  EXPECT_NEAR(solution.at("samples").at(0).at("angle").get<double>(), -0.289521642563073, 1e-12);
}

TEST(Solve, WritesJsonToAFileAndStaysSilent) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "s.json").string();
  const Outcome outcome = program({"solve", "bouncing-ball", "--json", file});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output, "");
  const json solution = json::parse(content_of(file));
  EXPECT_EQ(solution.at("ending"), "rest");
  EXPECT_NEAR(solution.at("settling").at("lock").at("time").get<double>(), 3.0, 1e-12);
}

TEST(Solve, FailsWhereTheMotionIsGivenUpAndSaysWhy) {
  // an elastic point mass between three taut cables is thrown to and fro within the instant
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "caught.toml").string();
  std::ofstream(file) << R"(name = "caught"
duration = 1
gravity = [0, -1]
body = {mass = 1, inertia = 0}
cables = [
  {anchor = [1, 0], attachment = [0, 0], length = 1, restitution = 1},
  {anchor = [-0.6, 0.8], attachment = [0, 0], length = 1, restitution = 1},
  {anchor = [-0.6, -0.8], attachment = [0, 0], length = 1, restitution = 1},
]
initial = {position = [0, 0], velocity = [0.7, -0.4]}
)";
  const Outcome text = program({"solve", file});
  EXPECT_EQ(text.code, 1) << text.errors;
  EXPECT_NE(text.output.find("one event follows another"), std::string::npos) << text.output;
  const Outcome script = program({"solve", file, "--json", "-"});
  EXPECT_EQ(script.code, 1);
  EXPECT_EQ(json::parse(script.output).at("ending"), "no_progress");
}

TEST(Solve, BeginsItsTextWithWhatBecameOfTheMotion) {
  const Outcome outcome = program({"solve", "breakwater/1910121100"});
  EXPECT_EQ(outcome.code, 0);
  const std::size_t table = outcome.output.find("event at");
  ASSERT_NE(table, std::string::npos);
  std::string summary = outcome.output.substr(0, table);
  std::replace(summary.begin(), summary.end(), '\n', ' ');  // wherever a line is broken
  for (const char* part :
       {"The run reached its duration, t = 20. ", "Cables 0 and 1 stay taut from t = 8.1",
        "amplitude 0.65 rad",
        "Energy above equilibrium: 0.125 at the start, 0.0197 at the end (16 %)."}) {
    EXPECT_NE(summary.find(part), std::string::npos) << part << "\nis not in\n" << summary;
  }
  const std::string lock = summary.substr(summary.find("taut from t = ") + 14);
  const double within = std::stod(lock.substr(lock.find("± ") + 3));
  EXPECT_NEAR(std::stod(lock), 8.128636512167714, within) << lock;  // in 60 digits
  EXPECT_LE(within, 2e-2) << lock;
  const std::string ball = program({"solve", "bouncing-ball", "--until", "2.7"}).output;
  EXPECT_NE(ball.find("At the end no cable is taut."), std::string::npos) << ball;
}

TEST(Solve, EndsAtTheLimitsThatAreAskedForAndFails) {
  const Outcome by_events = program({"solve", "breakwater/1910121100", "--max-events", "5"});
  EXPECT_EQ(by_events.code, 1);
  EXPECT_NE(by_events.output.find("the run reached the limit of 5 events"), std::string::npos)
      << by_events.output;
  const Outcome by_steps = program({"solve", "breakwater/1910121100", "--max-steps", "5"});
  EXPECT_EQ(by_steps.code, 1);
  EXPECT_NE(by_steps.output.find("--max-steps raises it."), std::string::npos) << by_steps.output;
}

TEST(Solve, CertifiesInTextAndJson) {
  const std::vector<std::string> ball = {"solve", "bouncing-ball", "--certify", "--digits", "30"};
  const Outcome text = program(ball);
  EXPECT_EQ(text.code, 0);
  for (const char* part :
       {"9 digits are correct to the end", "both have the same 20 events", "  30 digits\n"}) {
    EXPECT_NE(text.output.find(part), std::string::npos) << part << "\n" << text.output;
  }
  std::vector<std::string> words = ball;
  words.insert(words.end(), {"--json", "-"});
  const json certificate = json::parse(program(words).output).at("certificate");
  EXPECT_EQ(certificate.at("digits"), 30);
  EXPECT_EQ(certificate.at("correct").at(0).at("digits"), 9);
  EXPECT_TRUE(certificate.at("correct").at(0).at("until").is_null());
  EXPECT_EQ(certificate.at("events").at("all"), true);
}

TEST(Cases, ListTheSystemsApartAndPrintOneAsAFileWithWhatItShows) {
  const std::string list = program({"cases"}).output;
  const auto expect_listed = [&](const auto& one, auto kind) {
    const auto& [system, shows] = one;
    const std::size_t at = list.find("\n" + system.name + ": ");
    ASSERT_NE(at, std::string::npos) << system.name;
    EXPECT_GT(at, list.find("level-beam")) << system.name << " is below the cases";
    const Outcome file = program({"cases", system.name});
    ASSERT_EQ(file.code, 0) << file.errors;
    EXPECT_TRUE(file.output.starts_with("# " + std::string(shows.substr(0, 20)))) << file.output;
    const SystemReading reading = read_system_text(file.output, system.name);
    ASSERT_TRUE(reading.*kind) << reading.problems.front();
    EXPECT_EQ(write_system(*(reading.*kind)), write_system(system));
  };
  for (const ShippedSystem& one : shipped_systems()) {
    expect_listed(one, &SystemReading::system);
  }
  for (const ShippedSpatialSystem& one : shipped_spatial_systems()) {
    expect_listed(one, &SystemReading::in_space);
  }
}

TEST(Output, ThatCannotBeWrittenIsAFailure) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"solve", "bouncing-ball"}, {"cases"}, {"engines"}}) {
    const Outcome outcome = program(command, "sh -c '\"$0\" \"$@\" >/dev/full'");
    EXPECT_EQ(outcome.code, 1) << command.front();
    EXPECT_NE(outcome.errors.find("cannot write to standard output"), std::string::npos);
  }
}

TEST(Report, MakesHostileNamesHarmless) {
  const TemporaryFolder folder;
  std::string text = program({"cases", "bouncing-ball"}).output;
  const std::string name =
      "<script>alert(1)</script> ![x](http://a) `../../` " + std::string(3000, 'y');
  text.replace(text.find("bouncing-ball"), 13, name);
  const std::string file = folder.file("hostile.toml", text).string();
  const Outcome outcome = program({"bench", file, "--engines", "exact", "--steps", "1e-2", "--out",
                                   (folder.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const std::string markdown = content_of(folder.path() / "r/report.md");
  for (const std::string raw : {"<script", "![x"}) {
    for (std::size_t at = markdown.find(raw); at != std::string::npos;
         at = markdown.find(raw, at + 1)) {
      EXPECT_TRUE(at > 0 && markdown[at - 1] == '\\') << raw;
    }
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path().parent_path() / "runs"));
}

TEST(Solve, SaysThatADiskIsFull) {
  const Outcome outcome = program({"solve", "bouncing-ball", "--json", "/dev/full"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("No space left on device"), std::string::npos) << outcome.errors;
}

TEST(Bench, SaysThatTheDiskIsFullAndLeavesNoHalfFile) {
  const TemporaryFolder folder;
  const std::string disk = folder.path().string();
  // a disk that has room for what the tree is of, but not for a trajectory; listed before it is
  // gone. In a container, which may not mount one, no file may be longer than 8 kB instead.
  const std::string listed =
      "{ \"$@\"; code=$?; find \"$0\" -type f | sort; exit $code; }' " + disk;
  const bool mounts = std::system("unshare -rm true 2>/dev/null") == 0;  // NOLINT(cert-env33-c)
  const std::string on_small_disk =
      mounts ? "unshare -rm sh -c 'mount -t tmpfs -o size=16k tmpfs \"$0\" && " + listed
             : "sh -c 'trap \"\" XFSZ; ulimit -f 16 && " + listed;
  const Outcome outcome = program(
      {"bench", "bouncing-ball", "--engines", "exact", "--steps", "1e-2", "--out", disk + "/r"},
      on_small_disk);
  EXPECT_EQ(outcome.code, 1);
  const std::string reason = mounts ? "No space left on device" : "File too large";
  EXPECT_NE(outcome.errors.find("trajectory.csv: " + reason), std::string::npos) << outcome.errors;
  EXPECT_EQ(outcome.output, disk + "/r/suite.json\n" + disk + "/r/tautline-results.txt\n")
      << "a half file was left";
}

TEST(Bench, UntilEndsCasesEarlierAndNeverLater) {
  const TemporaryFolder folder;
  const auto durations = [&](const std::string& until) {
    const std::string out = (folder.path() / until).string();
    const Outcome outcome =
        program({"bench", "caught-swing", "spinning-rod", "--engines", "exact", "--models", "event",
                 "--steps", "0.1", "--until", until, "--out", out});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors.find("--until 8: changes nothing") != std::string::npos, until == "8")
        << outcome.errors;
    std::ifstream file(out + "/report.json");
    const json report = json::parse(file);
    std::vector<double> found;
    for (const json& one : report.at("cases")) {
      found.push_back(one.at("duration"));
    }
    return found;
  };
  EXPECT_EQ(durations("8"), (std::vector<double>{4.0, 2.0}));
  EXPECT_EQ(durations("3"), (std::vector<double>{3.0, 2.0}));
}

TEST(Bench, WritesTheDocumentedResultTree) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "r").string();
  ASSERT_EQ(
      program({"bench", "bouncing-ball", "--engines", "exact", "--steps", "1e-2", "--out", out})
          .code,
      0);
  const auto run = folder.path() / "r/runs/bouncing-ball/exact/event/0.01";
  for (const char* file : {"trajectory.csv", "events.csv", "settings.json", "result.json"}) {
    EXPECT_TRUE(std::filesystem::exists(run / file)) << file;
  }
  // an impact is two rows at one time
  std::ifstream csv(run / "trajectory.csv");
  std::string line;
  std::string before;
  while (std::getline(csv, line) && line.find(",before") == std::string::npos) {
  }
  before = line;
  std::getline(csv, line);
  EXPECT_NE(line.find(",after"), std::string::npos);
  EXPECT_EQ(before.substr(0, before.find(',')), line.substr(0, line.find(',')));
}

TEST(Run, LeavesTheRunsOfOthersInTheTree) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "r").string();
  for (const std::string step : {"1e-2", "1e-3"}) {
    ASSERT_EQ(program({"run", "bouncing-ball", "--engine", "exact", "--model", "event", "--step",
                       step, "--out", out})
                  .code,
              0);
  }
  const auto runs = folder.path() / "r/runs/bouncing-ball/exact/event";
  EXPECT_TRUE(std::filesystem::exists(runs / "0.01/result.json"));
  EXPECT_TRUE(std::filesystem::exists(runs / "0.001/result.json"));
}

TEST(Bench, DoesNotWriteToATreeThatAnotherOneIsWriting) {
  const TemporaryFolder folder;
  const std::vector<std::string> slow = {"bench",        "bouncing-ball",
                                         "--engines",    bad_engine("hang"),
                                         "--steps",      "1e-2",
                                         "--time-limit", "600",
                                         "--out",        (folder.path() / "r").string()};
  const int first = start_program(slow);
  const auto taken = folder.path() / "r/tautline-results.txt";
  for (int look = 0; look < 120'000 && !std::filesystem::exists(taken); ++look) {  // ten minutes
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const Outcome second = program(slow);
  ::kill(first, SIGTERM);
  EXPECT_EQ(wait_for(first), 1);
  EXPECT_EQ(second.code, 1);
  EXPECT_NE(second.errors.find("another `tautline` is writing to"), std::string::npos)
      << second.errors;
}

TEST(Bench, WorksWithNoEngineAtAll) {
  const TemporaryFolder folder;
  const TemporaryFolder nothing;
  const Outcome outcome =
      program({"bench", "bouncing-ball", "--out", (folder.path() / "r").string()},
              "TAUTLINE_ENGINE_PATH=" + nothing.path().string());
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const json report = json::parse(content_of(folder.path() / "r/report.json"));
  EXPECT_TRUE(report.at("runs").empty());
  EXPECT_EQ(report.at("engines").at(0).at("missing"), true);
}

TEST(Bench, RefusesAFileThatIsNoPlugin) {
  const TemporaryFolder folder;
  const std::string file = folder.file("text.so", "no library").string();
  const Outcome outcome = program(
      {"bench", "bouncing-ball", "--engine", file, "--out", (folder.path() / "r").string()});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find(file + ": not a shared library"), std::string::npos)
      << outcome.errors;
}

TEST(Bench, TakesACaseAfterAnEngine) {
  const TemporaryFolder folder;
  const Outcome outcome =
      program({"bench", "--engine", "exact", "--steps", "0.1", "--models", "event", "bouncing-ball",
               "--out", (folder.path() / "r").string()});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("1 run in "), std::string::npos) << outcome.output;
}

TEST(Cases, AreWrittenAsFilesThatSolveToTheSame) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "case.toml").string();
  const Outcome text = program({"cases", "plate-four-cables"});
  ASSERT_EQ(text.code, 0);
  std::ofstream(file) << text.output;
  EXPECT_EQ(program({"solve", file, "--json", "-"}).output,
            program({"solve", "plate-four-cables", "--json", "-"}).output);
}

TEST(Engines, AreListedWithVersionsAndModels) {
  const Outcome outcome = program({"engines", "--json", "-"});
  EXPECT_EQ(outcome.code, 0);
  const json engines = json::parse(outcome.output).at("engines");
  EXPECT_EQ(engines.at(0).at("name"), "exact");
  for (const json& engine : engines) {
    if (engine.at("missing").get<std::string>().empty()) {
      EXPECT_FALSE(engine.at("version").get<std::string>().empty());
      EXPECT_FALSE(engine.at("models").empty());
    }
  }
}

// bench --within

Outcome within(const std::string& the_case, const std::string& engines, const std::string& part,
               const std::vector<std::string>& more = {}, const std::string& shell = "") {
  return program(with({"bench", the_case, "--engines", engines, "--within", part}, more), shell);
}

TEST(Within, SaysWhichStepEachModelNeedsAndWhatWasTriedInVain) {
  const Outcome outcome = within("bouncing-ball", "exact," + bad_engine("no-restitution"), "1%");
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  for (const char* part :
       {"bouncing-ball: 1 % of the shortest cable is 0.02 m, over the first 3 s. A step-by-step "
        "model needs steps of 0.01 s; 0.02 s often do.\n",
        "locates its impacts: 0 % off at 0.01 s", "none of 0.02 to 0.005 s: ",
        " % off at the shortest\n", "\nNo step above 0.02 s was tried.\n"}) {
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << outcome.output;
  }
  const Outcome any = within("bouncing-ball", "exact", "50%");
  EXPECT_NE(any.output.find("For a step-by-step model any step up to 0.02 s does.\n"),
            std::string::npos)
      << any.output;
}

TEST(Within, ForetellsNoStepUnderALawThatThePlainSchemeDoesNotFollow) {
  const Outcome outcome = within("level-beam", "exact", "1%", {"--law", "sequential"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("Which step a step-by-step model needs is not known: the plain "
                                "scheme follows the law simultaneous, and the law sequential "
                                "resolves the impact at "),
            std::string::npos)
      << outcome.output;
}

TEST(Within, FailsIfNoModelCouldBeMeasured) {
  const Outcome outcome = within("bouncing-ball", bad_engine("segfault"), "1%");
  EXPECT_EQ(outcome.code, 1) << outcome.output;
  EXPECT_NE(outcome.output.find("crashed: SIGSEGV"), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.errors,
            "tautline: bouncing-ball: no run of any model came to the end: the table says why\n");
}

TEST(Within, AnInterruptedSearchPrintsWhatItFound) {
  const Outcome outcome = within("bouncing-ball", "exact," + bad_engine("hang"), "1%",
                                 {"--jobs", "1"}, "timeout --signal=INT 30");
  EXPECT_NE(outcome.code, 0);
  EXPECT_NE(outcome.output.find("exact   event "), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.errors,
            "tautline: interrupted: of bouncing-ball, 3 of 4 models are searched\n");
}

}  // namespace
}  // namespace tautline::test
