// `tautline ensemble` from outside.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <thread>
#include <utility>

#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

const std::string quick =
    "case = \"breakwater/1510121100\"\nuntil = 5\ncount = 60\n"
    "[[vary]]\nquantities = [\"x\", \"y\", \"spin\"]\nnormal = 1e-3\n";

/// A spec in a folder of its own, beside the results.
class Ensembles {
 public:
  explicit Ensembles(const std::string& spec) : file_(folder_.file("spec.toml", spec)) {}
  [[nodiscard]] std::vector<std::string> words(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"ensemble", file_.string(), "--out", out().string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] Outcome run(const std::vector<std::string>& more = {}) const {
    return program(words(more));
  }
  [[nodiscard]] std::filesystem::path out() const { return folder_.path() / "out"; }
  [[nodiscard]] json result() const { return json::parse(content_of(out() / "ensemble.json")); }

 private:
  TemporaryFolder folder_;
  std::filesystem::path file_;
};

TEST(EnsembleProgram, WritesWhatItsSchemaSaysAndTextOfEightyColumns) {
  const Ensembles ensembles(quick + "[[exact]]\nname = \"sequential\"\nlaw = \"sequential\"\n");
  const Outcome outcome = ensembles.run();
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_TRUE(keeps_the_schema(ensembles.result(), "ensemble"));
  EXPECT_NE(outcome.output.find("sequential differs from exact in"), std::string::npos);
  EXPECT_NE(outcome.output.find("The same in all draws: captured (1)"), std::string::npos);
  const std::string page = content_of(ensembles.out() / "index.html");
  EXPECT_NE(page.find("quantiles over those of exact"), std::string::npos);
  EXPECT_EQ(page.find("http://www.w3.org/2000/svg") == std::string::npos, false);
  EXPECT_NE(content_of(ensembles.out() / "ensemble.md").find("## Distributions"),
            std::string::npos);
  const Outcome narrow = program(ensembles.words(), "COLUMNS=80");
  std::istringstream lines(narrow.output);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), line.find("ensemble: ") == 0 ? 400U : 80U) << line;
  }
}

TEST(EnsembleProgram, IsTheSameInAnyNumberOfThreads) {
  const Ensembles ensembles(quick);
  const Outcome one = ensembles.run({"--jobs", "1", "--json", "-"});
  const Outcome three = ensembles.run({"--jobs", "3", "--json", "-"});
  EXPECT_EQ(one.code, 0) << one.errors;
  EXPECT_EQ(one.output, three.output);
}

TEST(EnsembleProgram, IdenticalDrawsGiveIdenticalFolders) {
  const Ensembles one(quick);
  const Ensembles other(quick);
  EXPECT_EQ(one.run({"--jobs", "1"}).code, 0);
  EXPECT_EQ(other.run({"--jobs", "2", "--time-limit", "50"}).code, 0);
  for (const char* file : {"index.html", "ensemble.md", "ensemble.json"}) {
    EXPECT_EQ(content_of(one.out() / file), content_of(other.out() / file)) << file;
  }
  EXPECT_EQ(content_of(one.out() / "index.html").find("--jobs"), std::string::npos);
}

TEST(EnsembleProgram, ComparesAnEngineOnTheSameDraws) {
  const Ensembles ensembles(quick +
                            "[engines]\nnames = [\"exact\"]\nmodels = [\"event\"]\nsteps = [0.01]");
  const Outcome outcome = ensembles.run({"--count", "20"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  // without a difference, 20 draws say nothing
  const std::string page = content_of(ensembles.out() / "index.html");
  EXPECT_NE(page.find("This n is too small: differences below D = 0."), std::string::npos);
  EXPECT_NE(page.find("verdict too-few-to-tell\"><span>n too small: differences below D = 0."),
            std::string::npos)
      << page.substr(page.find("comparison-table"), 2000);
  EXPECT_EQ(page.find("not told apart</span>"), std::string::npos);
  // the same motions: all that steps of 0.01 s can change is the extremes of the swing
  for (const json& one : ensembles.result()["comparisons"]) {
    if (one["statistic"] == "impacts" || one["statistic"] == "settled_fast") {
      EXPECT_LE(one["kolmogorov"]["effect"], 0.05) << one["statistic"];
    }
  }
  EXPECT_FALSE(ensembles.result()["setups"][1]["statistics"].contains("lock"));
}

TEST(EnsembleProgram, AnEngineHasTheLargestTensionIfItTellsItsTensions) {
  const TemporaryFolder folder;
  const std::string pendulum =
      folder
          .file("pendulum.toml",
                "name = \"pendulum\"\nduration = 4.0\ngravity = [0.0, -9.81]\n"
                "[body]\nmass = 1.0\ninertia = 0.0\n"
                "[[cables]]\nanchor = [0.0, 0.0]\nattachment = [0.0, 0.0]\nlength = 2.0\n"
                "restitution = 0.5\n[initial]\nposition = [1.2, -1.6]\n")
          .string();
  const Ensembles ensembles("case = \"" + pendulum +
                            "\"\n[[vary]]\nquantities = [\"mass\"]\nuniform = [1, 2]\n" +
                            "[engines]\nnames = [\"exact\", \"" + bad_engine("sound") +
                            "\"]\nmodels = [\"sampled\", \"event\", \"row\"]\nsteps = [1e-3]\n");
  const Outcome outcome = ensembles.run({"--count", "20"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  const json result = ensembles.result();
  EXPECT_TRUE(keeps_the_schema(result, "ensemble"));
  std::set<std::string> told;
  for (const json& setup : result["setups"]) {
    const json& statistics = setup["statistics"];
    ASSERT_TRUE(statistics.contains("largest_impulse")) << setup["name"];
    if (statistics.contains("largest_tension")) {
      told.insert(setup["name"]);
      const double mean = statistics["largest_tension"]["mean"];
      const double exact = result["setups"][0]["statistics"]["largest_tension"]["mean"];
      EXPECT_NEAR(mean, exact, 1e-5 * exact) << setup["name"];
    }
  }
  EXPECT_EQ(told, std::set<std::string>({"exact", "exact event 0.001", "exact sampled 0.001"}));
  for (const json& one : result["comparisons"]) {
    EXPECT_NE(one["statistic"], "largest_tension") << "a mean over steps is no largest tension";
  }
}

TEST(EnsembleProgram, AnEngineThatFailsIsNamed) {
  const Ensembles ensembles(quick + "[engines]\nnames = [\"" + bad_engine("segfault") +
                            "\"]\nsteps = [0.01]");
  const Outcome outcome = ensembles.run({"--count", "3"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.output.find("3 of 3 draws have no values"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("SIGSEGV"), std::string::npos);
}

// of 20 draws in one process 3, 6, ... crash: each costs itself and its process, in any number of
// threads, and the next 20 begin in a new one
TEST(EnsembleProgram, ACrashAmongTheDrawsOfAChunkCostsThatDrawAlone) {
  const Ensembles ensembles(quick + "[engines]\nnames = [\"" + bad_engine("third-run") +
                            "\"]\nsteps = [0.01]");
  const Outcome one = ensembles.run({"--count", "50", "--jobs", "1"});
  EXPECT_EQ(one.code, 1);
  EXPECT_NE(one.output.find("15 of 50 draws have no values"), std::string::npos) << one.output;
  EXPECT_NE(one.output.find("SIGSEGV"), std::string::npos);
  const json first = ensembles.result();
  EXPECT_EQ(ensembles.run({"--count", "50", "--jobs", "3"}).code, 1);
  EXPECT_EQ(ensembles.result(), first);
}

TEST(EnsembleProgram, MakesAnAtlasOfAGridWithAPictureForEachCell) {
  const Ensembles ensembles(
      "case = \"breakwater/1510121100\"\nuntil = 5\ncount = 1\n"
      "[[vary]]\nquantities = [\"restitution\"]\ngrid = [0.3, 0.6]\npoints = 3\n"
      "[[vary]]\nquantities = [\"spin\"]\ngrid = [-1, 1]\npoints = 2\n");
  EXPECT_EQ(ensembles.run().code, 0);
  const json atlas = ensembles.result()["atlas"];
  EXPECT_EQ(atlas["axes"][0]["quantity"], "restitution");
  EXPECT_EQ(atlas["maps"]["impacts"].size(), 6U);
  EXPECT_GT(atlas["maps"]["impacts"][2], atlas["maps"]["impacts"][0])
      << "the more, the more elastic";
  EXPECT_EQ(atlas["maps"]["captured"], json::array({1.0, 1.0, 1.0, 1.0, 1.0, 1.0}));
  const std::string page = content_of(ensembles.out() / "index.html");
  const std::size_t captured = page.find(">captured</text>");
  ASSERT_NE(captured, std::string::npos);
  const std::string map = page.substr(captured, page.find("</svg>", captured) - captured);
  const std::regex fill("fill=\"(rgb[^\"]*)\"");
  std::set<std::string> colours;
  for (std::sregex_iterator next(map.begin(), map.end(), fill), end; next != end; ++next) {
    colours.insert((*next)[1]);
  }
  EXPECT_EQ(colours.size(), 1U) << "of all cells and of the word beside them";
  EXPECT_NE(map.find(">captured</text>", 10), std::string::npos) << "beside its colour";
  EXPECT_EQ(map.find(">released</text>"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(ensembles.out() / "cells/0005.svg"));
  EXPECT_NE(page.find("href=\"cells/0005.svg\""), std::string::npos);
}

TEST(EnsembleProgram, AnInterruptionKeepsWhatIsDoneAndResumeDoesTheRest) {
  const Ensembles ensembles(quick);
  const std::vector<std::string> many = {"--count", "20000", "--jobs", "2"};
  const int process = start_program(ensembles.words(many));
  const auto first = ensembles.out() / "draws/exact/00000000.csv";
  // Sanitized, beside other tests, the first 200 draws take some ten seconds.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(5);
  while (!std::filesystem::exists(first) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ::kill(process, SIGINT);
  EXPECT_EQ(wait_for(process), 1);
  const json part = ensembles.result();
  EXPECT_EQ(part["interrupted"], true);
  EXPECT_LT(part["setups"][0]["draws"], 20'000);
  ASSERT_GT(part["setups"][0]["draws"], 0) << "nothing was done to be kept";
  const std::string kept = content_of(first);
  EXPECT_EQ(ensembles.run({"--count", "400", "--resume"}).code, 0);
  const json resumed = ensembles.result();
  EXPECT_EQ(content_of(first), kept);
  EXPECT_EQ(ensembles.run({"--count", "400"}).code, 0);
  EXPECT_EQ(ensembles.result(), resumed) << "as without an interruption";
}

TEST(EnsembleProgram, ADrawIsACaseOfItsOwn) {
  const Ensembles ensembles(quick);
  const Outcome drawn = ensembles.run({"--draw", "17"});
  ASSERT_EQ(drawn.code, 0) << drawn.errors;
  EXPECT_FALSE(std::filesystem::exists(ensembles.out())) << "nothing is solved";
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.file("draw.toml", drawn.output);
  const Outcome solved = program({"solve", file.string(), "--json", "-"});
  ASSERT_EQ(solved.code, 0) << solved.errors;
  EXPECT_NE(solved.output.find("breakwater/1510121100, draw 17"), std::string::npos);
  // what the ensemble has of it is what one of that case alone has of its only draw
  const auto values_of = [](const Ensembles& one, const std::string& draw) {
    EXPECT_EQ(one.run().code, 0);
    const std::string rows = content_of(one.out() / "draws/exact/00000000.csv");
    const std::size_t start = rows.find("\n" + draw + ",,") + draw.size() + 3;
    return rows.substr(start, rows.find('\n', start) - start);
  };
  const Ensembles alone("case = \"" + file.string() + "\"\ncount = 1\n" +
                        "[[vary]]\nquantities = [\"gravity_x\"]\nlist = [0.0]\n");
  const std::string values = values_of(ensembles, "17");
  EXPECT_GT(values.size(), 50U);
  EXPECT_EQ(values_of(alone, "0"), values);
  for (const auto& [draw, sentence] :
       {std::pair{"-1", "--draw -1: must be from 0 to 59, as --count says"},
        std::pair{"60", "--draw 60: must be from 0 to 59, as --count says"}}) {
    const Outcome wrong = ensembles.run({"--draw", draw});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.errors.find(sentence), std::string::npos) << wrong.errors;
  }
}

TEST(EnsembleProgram, ADrawSaysItsLawAndIsNoneWhereItIsNoCase) {
  const Ensembles sequential("law = \"sequential\"\n" + quick);
  const Outcome drawn = sequential.run({"--draw", "3", "--count", "4"});
  EXPECT_EQ(drawn.code, 0);
  EXPECT_TRUE(drawn.output.starts_with("# draw 3 of ")) << drawn.output;
  EXPECT_NE(drawn.output.find("spec.toml, which is solved with --law sequential\n"),
            std::string::npos)
      << drawn.output;
  const Ensembles absurd(
      "case = \"breakwater/1510121100\"\ncount = 3\n"
      "[[vary]]\nquantities = [\"restitution\"]\nuniform = [1.5, 2.0]\n");
  const Outcome none = absurd.run({"--draw", "1"});
  EXPECT_EQ(none.code, 1);
  EXPECT_NE(none.errors.find("--draw 1: no such case: cable 0: restitution"), std::string::npos)
      << none.errors;
  const Outcome all = absurd.run();
  EXPECT_EQ(all.code, 1) << "no draw is a case";
  EXPECT_NE(all.output.find("3 of 3 draws have no values"), std::string::npos) << all.output;
}

TEST(EnsembleProgram, WhatCannotBeWrittenNamesWhatIsKept) {
  const Ensembles ensembles(quick);
  ASSERT_EQ(ensembles.run().code, 0);
  std::filesystem::remove(ensembles.out() / "index.html");
  std::filesystem::create_directory(ensembles.out() / "index.html");
  const Outcome outcome = ensembles.run({"--resume"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("index.html"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("what is done is kept: the same command with --resume does the"),
            std::string::npos)
      << outcome.errors;
}

// after ten seconds
TEST(EnsembleProgram, HasTheResultsSoFarInItsFolder) {
  const Ensembles ensembles(quick);
  const int process = start_program(ensembles.words({"--count", "10000000", "--jobs", "1"}));
  const auto page = ensembles.out() / "index.html";
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(4);
  while (!std::filesystem::exists(page) && std::chrono::steady_clock::now() < deadline) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_TRUE(std::filesystem::exists(page));
  EXPECT_NE(content_of(page).find("Not all draws: these are the ones done"), std::string::npos);
  const json so_far = ensembles.result();
  EXPECT_EQ(so_far["interrupted"], true);
  EXPECT_GT(so_far["setups"][0]["draws"], 0);
  ::kill(process, SIGINT);
  EXPECT_EQ(wait_for(process), 1);
  EXPECT_NE(content_of(page).find("Interrupted: these are the draws that are finished."),
            std::string::npos);
  EXPECT_GE(ensembles.result()["setups"][0]["draws"], so_far["setups"][0]["draws"]);
}

TEST(EnsembleProgram, NamesWhatIsWrongBeforeItStarts) {
  const Ensembles ensembles(quick + "[engines]\nnames = [\"bulet64\"]\n");
  const Outcome outcome = ensembles.run({"--jobs", "0"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("--jobs 0"), std::string::npos) << outcome.errors;
  for (const auto& [option, value, sentence] :
       {std::array{"--count", "-3", "--count -3: must be from 1 to"},
        std::array{"--case", "nothing", "--case: unknown case \"nothing\""}}) {
    const Outcome wrong = ensembles.run({option, value});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_NE(wrong.errors.find(sentence), std::string::npos) << wrong.errors;
  }
  const Outcome engine = ensembles.run();
  EXPECT_EQ(engine.code, 2);
  EXPECT_NE(engine.errors.find("bulet64"), std::string::npos) << engine.errors;
  EXPECT_FALSE(std::filesystem::exists(ensembles.out()));
}

}  // namespace
}  // namespace tautline::test
