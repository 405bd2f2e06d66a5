// The draws of `tautline bench`, from outside: what the report says of distributions.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/bench/program.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// A bench of the standard case with draws.
class Draws {
 public:
  [[nodiscard]] Outcome run(const std::vector<std::string>& more) const {
    std::vector<std::string> words = {"bench",     "breakwater/1910121100",
                                      "--engines", "bullet64",
                                      "--models",  "contact,event",
                                      "--steps",   "1e-2,1e-3",
                                      "--until",   "10",
                                      "--out",     out().string()};
    words.insert(words.end(), more.begin(), more.end());
    return program(words);
  }
  [[nodiscard]] std::filesystem::path out() const { return folder_.path() / "out"; }
  [[nodiscard]] json report() const { return json::parse(content_of(out() / "report.json")); }

 private:
  TemporaryFolder folder_;
};

json statistic_of(const json& setup, const std::string& name) {
  for (const json& one : setup.at("statistics")) {
    if (one.at("name") == name) {
      return one;
    }
  }
  return {};
}

/// As a table shows it: in brackets where it is no difference.
std::string shown_distance(const json& statistic) {
  const std::string number = fmt::format("{:.2f}", statistic.at("distance").get<double>());
  return statistic.at("differs").get<bool>() ? number : "(" + number + ")";
}

TEST(DrawsOfABench, TellTheModelsApartThatDiffer) {
  const Draws draws;
  const Outcome outcome = draws.run({"--draws", "40"});
  EXPECT_EQ(outcome.code, 0) << outcome.errors;
  const json report = draws.report();
  EXPECT_TRUE(keeps_the_schema(report, "bench"));
  const json& said = report.at("distributions");
  EXPECT_EQ(said.at("draws"), 40);
  ASSERT_EQ(said.at("setups").size(), 2U);
  const json& contact = said["setups"][0];
  const json& event = said["setups"][1];
  EXPECT_EQ(contact["model"], "contact");
  EXPECT_EQ(contact["step"], 1e-3) << "the finest that is not below a millisecond";
  EXPECT_TRUE(statistic_of(contact, "settled_fast")["differs"]);
  EXPECT_GT(statistic_of(contact, "settled_fast")["distance"], 0.5);
  for (const json& one : event["statistics"]) {
    EXPECT_FALSE(one["differs"]) << one["name"];
  }
  // what it says is what the page of its own says
  const json own = json::parse(content_of(draws.out() / "ensemble" / "ensemble.json"));
  std::size_t shared = 0;
  for (const json& one : own.at("comparisons")) {
    const json& setup = one["setup"] == "bullet64 contact 0.001" ? contact : event;
    EXPECT_EQ(statistic_of(setup, one["statistic"])["distance"], one["kolmogorov"]["effect"]);
    ++shared;
  }
  EXPECT_EQ(shared, contact["statistics"].size() + event["statistics"].size());
}

TEST(DrawsOfABench, AreInEveryFormOfTheReport) {
  const Draws draws;
  const Outcome outcome = draws.run({"--draws", "12", "--all"});
  ASSERT_EQ(outcome.code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("12 draws of breakwater/1910121100"), std::string::npos);
  const std::string markdown = content_of(draws.out() / "report.md");
  const std::string page = content_of(draws.out() / "index.html");
  for (const json& setup : draws.report()["distributions"]["setups"]) {
    const std::string distance = shown_distance(statistic_of(setup, "settled_fast"));
    for (const std::string* text : {&outcome.output, &markdown, &page}) {
      EXPECT_NE(text->find(distance), std::string::npos) << setup["model"] << distance;
    }
  }
  EXPECT_NE(markdown.find("[All distributions over each other](ensemble/index.html)"),
            std::string::npos);
  EXPECT_NE(page.find("href=\"ensemble/index.html\""), std::string::npos);
  EXPECT_NE(page.find("href=\"#distributions\""), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(draws.out() / "ensemble" / "index.html"));
}

TEST(DrawsOfABench, AreKeptByResumeAndClearedWithoutThem) {
  const Draws draws;
  ASSERT_EQ(draws.run({"--draws", "12"}).code, 0);
  const json first = draws.report()["distributions"];
  const auto chunks = draws.out() / "ensemble" / "draws";
  std::filesystem::path file;
  for (const auto& one : std::filesystem::recursive_directory_iterator(chunks)) {
    file = one.is_regular_file() ? one.path() : file;
  }
  const auto written = std::filesystem::last_write_time(file);
  ASSERT_EQ(draws.run({"--draws", "12", "--resume"}).code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(file), written) << file;
  EXPECT_EQ(draws.report()["distributions"], first);
  ASSERT_EQ(draws.run({}).code, 0);
  EXPECT_FALSE(draws.report().contains("distributions"));
  EXPECT_FALSE(std::filesystem::exists(draws.out() / "ensemble"));
  EXPECT_EQ(content_of(draws.out() / "index.html").find("href=\"#distributions\""),
            std::string::npos);
}

TEST(DrawsOfABench, AreRefusedWhereTheySayNothing) {
  const TemporaryFolder folder;
  const auto said = [&](std::vector<std::string> words) {
    words.insert(words.end(), {"--out", (folder.path() / "out").string()});
    const Outcome outcome = program(words);
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    return outcome.errors;
  };
  EXPECT_NE(said({"bench", "--suite", "quick", "--draws", "5"})
                .find("--draws 5: must be 0, or from 10 to 10000"),
            std::string::npos);
  EXPECT_NE(said({"bench", "--suite", "quick", "--draws", "-1"}).find("--draws -1: must be 0"),
            std::string::npos);
  EXPECT_NE(said({"bench", "--suite", "quick", "--draws", "50", "--shard", "1/2"})
                .find("--draws 50: a shard has none"),
            std::string::npos);
  EXPECT_NE(said({"bench", "bouncing-ball", "--draws", "50"})
                .find("breakwater/1910121100, which is not among the cases"),
            std::string::npos);
}

}  // namespace
}  // namespace tautline::test
