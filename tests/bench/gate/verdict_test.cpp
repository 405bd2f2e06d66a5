// Verdicts and the gate as the program has them, on engines with planted faults. What follows from
// a report alone is tested in judging_test.cpp.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// What the bench says of some engines, with the options `more`, at one step.
struct Benched {
  Outcome outcome;
  json report;
  std::string summary;
  std::string page;
};
Benched benched(std::vector<std::string> more) {
  const TemporaryFolder out;
  std::vector<std::string> arguments = {"bench", "--no-certify", "--draws",
                                        "0",     "--out",        (out.path() / "r").string()};
  arguments.insert(arguments.begin() + 1, more.begin(), more.end());
  Benched result;
  result.outcome = program(arguments);
  const auto folder = out.path() / "r";
  if (std::filesystem::exists(folder / "report.json")) {
    result.report = json::parse(content_of(folder / "report.json"));
    result.summary = content_of(folder / "summary.md");
    result.page = content_of(folder / "index.html");
  }
  return result;
}

/// The ball at 1e-3 s, gated by a problems file.
Benched gated(const std::string& engine, const std::string& entries) {
  const TemporaryFolder out;
  const auto file = out.file("problems.toml", "schema = 2\nversion = \"1\"\n" + entries);
  return benched(
      {"bouncing-ball", "--engines", engine, "--steps", "1e-3", "--gate", file.string()});
}

std::string problem(const std::string& engine, const std::string& kind) {
  return "[[problem]]\nengine = \"" + engine + "\"\nmodel = \"*\"\nkind = \"" + kind +
         "\"\nreason = \"made to\"\n";
}

std::string word_of(const json& report, std::size_t run = 0) {
  return report.at("runs").at(run).at("verdict").at("word");
}

TEST(ListedProblems, ABadFileEndsTheBenchBeforeItStarts) {
  const Benched bad = gated("exact", "[[problem]]\n");
  EXPECT_EQ(bad.outcome.code, 2);
  EXPECT_NE(bad.outcome.errors.find("problem[0].engine: is missing"), std::string::npos)
      << bad.outcome.errors;
  EXPECT_TRUE(bad.report.is_null());
  const Outcome none = program({"bench", "bouncing-ball", "--gate", "/no/such/problems.toml"});
  EXPECT_EQ(none.code, 2);
  EXPECT_NE(none.errors.find("no such file"), std::string::npos) << none.errors;
}

TEST(Gate, ASoundEnginePassesWithoutAFileAndEachPlantedErrorBreaksIt) {
  const auto on_ball = [](const std::string& engine) {
    return benched(
        {"bouncing-ball", "--engines", bad_engine(engine), "--steps", "1e-3", "--gate", "none"});
  };
  const Benched sound = on_ball("sound");
  EXPECT_EQ(sound.outcome.code, 0) << sound.outcome.output;
  EXPECT_EQ(word_of(sound.report), "sound");
  for (const char* flaw : {"no-restitution", "twice", "threshold", "bouncy"}) {
    const Benched flawed = on_ball(flaw);
    EXPECT_EQ(flawed.outcome.code, 1) << flaw << flawed.outcome.output;
    EXPECT_EQ(word_of(flawed.report), "problem") << flaw;
    EXPECT_NE(flawed.outcome.output.find("The gate is broken by"), std::string::npos) << flaw;
  }
}

TEST(Gate, AListedProblemPassesAndOneThatIsGoneDoesNot) {
  const std::string entries = problem("bouncy", "restitution") + problem("bouncy", "position") +
                              problem("bouncy", "missed-impacts");
  const Benched listed = gated(bad_engine("bouncy"), problem("bouncy", "restitution"));
  EXPECT_EQ(word_of(listed.report), "problem") << "its position is not listed";
  const Benched all = gated(bad_engine("bouncy"), entries);
  EXPECT_EQ(word_of(all.report), "listed problem") << all.outcome.output;
  const Benched gone = gated(bad_engine("sound"), problem("sound", "restitution"));
  EXPECT_EQ(gone.outcome.code, 1) << gone.outcome.output;
  EXPECT_NE(gone.outcome.output.find("no run shows it any more"), std::string::npos);
  // an engine that is not in the report cannot have lost it
  EXPECT_EQ(gated(bad_engine("sound"), entries).outcome.code, 0);
}

TEST(Gate, TakesTheListThatTheProgramHasWritten) {
  const TemporaryFolder out;
  const std::string file = (out.path() / "problems.toml").string();
  const std::vector<std::string> runs = {"bouncing-ball", "--engines", bad_engine("bouncy"),
                                         "--steps", "1e-3"};
  std::vector<std::string> write = runs;
  write.insert(write.end(), {"--list-problems", file});
  EXPECT_EQ(benched(write).outcome.code, 0);
  EXPECT_NE(content_of(file).find("kind = \"restitution\""), std::string::npos) << content_of(file);
  std::vector<std::string> read = runs;
  read.insert(read.end(), {"--gate", file});
  const Benched again = benched(read);
  EXPECT_EQ(again.outcome.code, 0) << again.outcome.output;
  EXPECT_EQ(word_of(again.report), "listed problem");
  // another engine is added to it
  benched({"bouncing-ball", "--engines", bad_engine("no-restitution"), "--steps", "1e-3",
           "--list-problems", file});
  EXPECT_NE(content_of(file).find("engine = \"bouncy\""), std::string::npos) << content_of(file);
  EXPECT_NE(content_of(file).find("engine = \"no-restitution\""), std::string::npos);
}

TEST(ListedProblems, AFileThatCannotBeReadIsNotWrittenOver) {
  const TemporaryFolder out;
  const std::string file = out.file("problems.toml", "schema = 2\n[[problem]]\n").string();
  const Benched bad = benched({"bouncing-ball", "--engines", "exact", "--list-problems", file});
  EXPECT_EQ(bad.outcome.code, 2);
  EXPECT_NE(bad.outcome.errors.find("problem[0].engine: is missing"), std::string::npos)
      << bad.outcome.errors;
  EXPECT_EQ(content_of(file), "schema = 2\n[[problem]]\n");
}

TEST(Gate, ARunThatDivergesBreaksItUnlessThatIsListed) {
  const Benched diverged = gated(bad_engine("nan"), "");
  EXPECT_EQ(diverged.outcome.code, 1);
  EXPECT_EQ(diverged.report.at("runs").at(0).at("verdict").at("problems").at(0).at("kind"),
            "failure");
  EXPECT_EQ(gated(bad_engine("nan"), problem("nan", "failure")).outcome.code, 0);
  EXPECT_EQ(gated(bad_engine("sound"), problem("sound", "failure")).outcome.code, 1);
}

TEST(Gate, HoldsForEveryModelThatIsBuilt) {
  const Benched all = benched({"breakwater/1710121100", "level-beam", "caught-swing", "--until",
                               "4", "--steps", "1e-2,1e-3", "--gate", "shipped"});
  EXPECT_EQ(all.outcome.code, 0) << all.outcome.output << all.outcome.errors;
  EXPECT_NE(all.outcome.output.find("The gate holds ("), std::string::npos) << all.outcome.output;
}

TEST(Verdict, TheControlHasNoProblemOnAnyCaseOfTheQuickSuite) {
  const Benched control = benched({"--suite", "quick", "--engines", "exact", "--gate", "none"});
  EXPECT_EQ(control.outcome.code, 0) << control.outcome.output << control.outcome.errors;
  EXPECT_EQ(control.report.at("runs").size(), 36U);
}

TEST(Verdict, OfAModelThatStopsIsOfWhatItDidBefore) {
  const Benched told = benched(
      {"breakwater/1510121100", "--engines", bad_engine("no-taut-motion"), "--steps", "1e-2"});
  EXPECT_EQ(told.report.at("runs").at(0).at("status"), "stopped");
  EXPECT_EQ(told.report.at("runs").at(0).at("verdict").at("problems").dump().find("failure"),
            std::string::npos);
  EXPECT_FALSE(told.report.at("runs").at(0).at("judgement").is_null());
}

constexpr std::string_view own_pendulum = R"(name = "my pendulum"
duration = 4.0
gravity = [0.0, -9.81]
[body]
mass = 1.0
inertia = 0.01
[[cables]]
anchor = [0.0, 0.0]
attachment = [0.0, 0.1]
length = 1.0
restitution = 0.5
[initial]
position = [0.6, -0.5]
angle = 0.2
velocity = [0.0, 0.0]
spin = 0.0
)";

constexpr std::string_view own_spreader = R"(name = "my spreader"
duration = 4.0
gravity = [0.0, -9.81]
[body]
mass = 30.0
inertia = 8.0
[[cables]]
anchor = [-1.5, 4.0]
attachment = [-0.8, 0.1]
length = 3.1
restitution = 0.7
[[cables]]
anchor = [1.5, 4.0]
attachment = [0.8, 0.1]
length = 3.0
restitution = 0.7
[initial]
position = [0.1, 1.3]
angle = 0.1
velocity = [0.4, 0.0]
spin = 0.2
)";

/// Every planted fault, on three shipped cases and two of one's own.
class Planted : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TemporaryFolder folder;
    const auto pendulum = folder.file("pendulum.toml", std::string(own_pendulum));
    const auto spreader = folder.file("spreader.toml", std::string(own_spreader));
    told = new Benched(
        benched({pendulum.string(), spreader.string(), "bouncing-ball", "breakwater/1910121100",
                 "breakwater/1911121100", "--engines", bad_engine("planted"), "--steps",
                 "1e-2,1e-3", "--until", "8", "--gate", "none", "--all"}));
  }
  static void TearDownTestSuite() { delete told; }

  static inline const Benched* told = nullptr;  // run once for all
};

/// The row of `model` in a Markdown table.
std::string row_of(const std::string& markdown, const std::string& model) {
  const std::size_t place = markdown.find("| " + model + " ");
  return place == std::string::npos ? ""
                                    : markdown.substr(place, markdown.find('\n', place) - place);
}

TEST_F(Planted, FaultsBreakTheGateAndAreNamedEverywhere) {
  EXPECT_EQ(told->outcome.code, 1);
  std::set<std::string> with_problem;
  for (const json& run : told->report.at("runs")) {
    if (run.at("verdict").at("word") == "problem") {
      with_problem.insert(run.at("model"));
    }
  }
  EXPECT_FALSE(with_problem.contains("sound"));
  for (const json& model : told->report.at("models")) {
    const std::string name = model.at("model");
    const std::string row = row_of(told->summary, name);
    ASSERT_FALSE(row.empty()) << name << told->summary;
    const bool sound = name == "sound";
    EXPECT_EQ(with_problem.contains(name), !sound) << name;
    // terminal: the gate's table names it; summary, page and terminal never recommend it
    EXPECT_EQ(told->outcome.output.find("planted  " + name + " ") != std::string::npos, true)
        << name;
    EXPECT_EQ(row.find("problem") != std::string::npos, !sound) << row;
    for (const std::string* text : {&told->outcome.output, &told->summary, &told->page}) {
      EXPECT_EQ(text->find("Use " + name + " at") != std::string::npos, sound) << name;
    }
  }
}

TEST_F(Planted, RestitutionIsNeverCalledKeptWhereItIsNot) {
  const std::set<std::string> bounce_wrongly = {"less-bouncy", "bit-less-bouncy", "dead",
                                                "too-bouncy",  "threshold",       "loses-third"};
  for (const json& model : told->report.at("models")) {
    const bool wrong = bounce_wrongly.contains(model.at("model"));
    EXPECT_EQ(model.at("restitution").at("word") != "kept", wrong) << model;
    EXPECT_EQ(row_of(told->summary, model.at("model")).find("kept (") == std::string::npos, wrong)
        << model;
  }
}

TEST(TerminalSummary, HasASentenceForEachEngineAndNoColourInAPipe) {
  const TemporaryFolder out;
  const Outcome outcome =
      program({"bench", "bouncing-ball", "--engines", "exact," + bad_engine("planted"), "--steps",
               "1e-2,1e-3", "--no-certify", "--out", (out.path() / "r").string()});
  EXPECT_EQ(outcome.output.find('\033'), std::string::npos);
  EXPECT_LE(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 5) << outcome.output;
  EXPECT_EQ(outcome.output.rfind("planted  ", 0), 0U) << outcome.output;
}

}  // namespace
}  // namespace tautline::test
