// Versions as an axis, without a network: an npm of ours, whose package is a restitution.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>

#include "tests/bench/run/protocol_support.hpp"
#include "tests/bench/schema.hpp"

namespace tautline::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path npm_fixtures = fs::path(TAUTLINE_FIXTURE_SOURCES) / "npm";

/// An engine of npm's, a cache and a folder for the trend.
class Versions {
 public:
  Versions() {
    fs::create_directories(folder_.path() / "engines");
    fs::copy(npm_fixtures / "rope", folder_.path() / "engines/rope");
    fs::create_directory_symlink(TAUTLINE_PYTHON_KIT, folder_.path() / "engines/python");
  }
  /// `tautline trend` of these versions with the npm of the fixtures.
  [[nodiscard]] Outcome trend(const std::string& versions,
                              const std::vector<std::string>& more = {},
                              const std::string& interrupts = "") const {
    std::vector<std::string> words = {
        "trend",   (folder_.path() / "engines/rope/engine.toml").string() + versions,
        "--cases", "bouncing-ball",
        "--steps", "0.01"};
    if (std::find(more.begin(), more.end(), "--out") == more.end()) {
      words.insert(words.end(), {"--out", out().string()});
    }
    words.insert(words.end(), more.begin(), more.end());
    return program(words, "PATH='" + npm_fixtures.string() + "':\"$PATH\" XDG_CACHE_HOME='" +
                              cache().string() + "' NPM_LOG='" + log().string() +
                              "' NPM_INTERRUPTS='" + interrupts + "'");
  }
  [[nodiscard]] fs::path out() const { return folder_.path() / "out"; }
  [[nodiscard]] fs::path cache() const { return folder_.path() / "cache"; }
  [[nodiscard]] fs::path log() const { return folder_.path() / "log.txt"; }
  /// How often npm was asked to install something.
  [[nodiscard]] int installations() const {
    const std::string log = content_of(this->log());
    int count = 0;
    for (std::size_t at = log.find("install "); at != std::string::npos;
         at = log.find("install ", at + 1)) {
      ++count;
    }
    return count;
  }
  [[nodiscard]] json result() const { return json::parse(content_of(out() / "trend.json")); }

 private:
  TemporaryFolder folder_;
};

/// A version and, if it was not run, why.
using VersionRow = std::pair<std::string, std::string>;

std::vector<VersionRow> versions_of(const json& trend) {
  std::vector<VersionRow> result;
  for (const json& version : trend.at("engines").at(0).at("versions")) {
    const json& problem = version.at("problem");
    result.emplace_back(version.at("version"), problem.is_null() ? "" : problem.get<std::string>());
  }
  return result;
}

json points_of(const json& trend, const std::string& metric) {
  for (const json& row : trend.at("engines").at(0).at("trend").at("rows")) {
    if (row.at("metric") == metric) {
      return row.at("points");
    }
  }
  return json::array();
}

TEST(VersionTrend, FindsTheVersionThatChangedTheRestitution) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Versions versions;
  const Outcome outcome = versions.trend("@1.0..1.4");
  EXPECT_EQ(outcome.code, 1) << "the newest does not answer\n" << outcome.errors;
  const json trend = versions.result();
  EXPECT_TRUE(keeps_the_schema(trend, "trend"));
  const auto found = versions_of(trend);
  ASSERT_EQ(found.size(), 5U) << trend;
  EXPECT_EQ(found[0], VersionRow("1.0.1", "")) << "the newest of 1.0";
  EXPECT_EQ(found[1], VersionRow("1.1.0", ""));
  EXPECT_EQ(found[2], VersionRow("1.2.0", ""));
  EXPECT_EQ(found[3], VersionRow("1.3.0", "npm: rope-1.3.0.tgz is corrupt"));
  EXPECT_EQ(found[4].first, "1.4.0");
  EXPECT_NE(found[4].second, "") << "it ends at once";
  const json points = points_of(trend, "restitution_error");
  ASSERT_EQ(points.size(), 3U) << trend;
  EXPECT_EQ(points[1].at("worse"), 0);
  EXPECT_EQ(points[2].at("worse"), 1) << "of 0.5 a half";
  // the row of a step is off by what gravity does in one: some hundredths
  EXPECT_NEAR(points[2].at("median").get<double>(), 0.25, 0.05);
  EXPECT_LT(points[1].at("median").get<double>(), 0.05);
  EXPECT_EQ(trend.at("engines").at(0).at("trend").at("costs").size(), 1U);
  EXPECT_NE(outcome.output.find("Worse:"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("1.2.0  row    0.01  restitution_error"), std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find("1.4.0 has no report"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("untried"), std::string::npos) << "1.0 is below those it is for";
}

TEST(VersionTrend, IsAPageWithAChart) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Versions versions;
  EXPECT_EQ(versions.trend("@1.1").code, 0);
  const std::string page = content_of(versions.out() / "trend.md");
  EXPECT_NE(page.find("trend-rope.svg"), std::string::npos) << page;
  EXPECT_NE(page.find("| 1.1.0"), std::string::npos) << page;
  const std::string chart = content_of(versions.out() / "trend-rope.svg");
  EXPECT_TRUE(chart.starts_with("<svg")) << chart;
  EXPECT_NE(chart.find(">1.1.0</text>"), std::string::npos) << chart;
  EXPECT_EQ(chart.find("nan"), std::string::npos) << chart;
  EXPECT_NE(content_of(versions.out() / "index.html").find(chart), std::string::npos);
}

TEST(VersionTrend, ASecondCallFetchesNothing) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Versions versions;
  EXPECT_EQ(versions.trend("@1.1").code, 0);
  EXPECT_EQ(versions.installations(), 1);
  EXPECT_EQ(versions.trend("@1.1", {"--resume"}).code, 0);
  EXPECT_EQ(versions.installations(), 1) << content_of(versions.log());
  const json report = json::parse(content_of(versions.out() / "rope/1.1.0/report.json"));
  EXPECT_EQ(report.at("context").at("kept_runs"), 1) << "--resume keeps what was run";
}

TEST(VersionTrend, TwoAtOnceShareOneInstallation) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Versions versions;
  std::vector<std::future<Outcome>> both;
  for (const char* out : {"one", "other"}) {
    const std::string folder = (versions.out().parent_path() / out).string();
    both.push_back(std::async(std::launch::async, [=, &versions] {
      return versions.trend("@1.1", {"--out", folder});
    }));
  }
  for (auto& one : both) {
    const Outcome outcome = one.get();
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
  }
  EXPECT_EQ(versions.installations(), 1);
}

TEST(VersionTrend, AnInterruptionKeepsWhatIsDone) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Versions versions;
  const Outcome outcome = versions.trend("@1.0..1.4", {}, "1.2.0");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("--resume does the rest"), std::string::npos) << outcome.errors;
  const auto found = versions_of(versions.result());
  ASSERT_EQ(found.size(), 5U);
  EXPECT_EQ(found[1], VersionRow("1.1.0", ""));
  for (std::size_t index = 2; index < found.size(); ++index) {
    EXPECT_EQ(found[index].second, "interrupted") << found[index].first;
  }
}

TEST(VersionTrend, SaysInOneSentenceWhatItCannotDo) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const Versions versions;
  const auto refused = [](const Outcome& outcome, const std::string& sentence) {
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.errors.find(sentence), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_EQ(outcome.output, "");
  };
  refused(versions.trend("@7.."), "npm: No match found for version >=7");
  refused(versions.trend("@"), "must be an engine and its versions");
  refused(versions.trend("@1.1", {"--steps", "-1"}), "step -1");
  refused(program({"trend", "tautline-has-no-such-engine@1"}), "no engine with an engine.toml");
  refused(program({"trend", sound_child(TemporaryFolder()) + "@1"}), "engine.toml");
}

TEST(VersionTrend, WithoutNpmItSaysSo) {
  if (!has_python()) {
    GTEST_SKIP() << no_python;
  }
  const TemporaryFolder folder;  // of commands: all but npm
  fs::create_directories(folder.path() / "bin");
  fs::create_symlink("/bin/sh", folder.path() / "bin/python3");  // is not started
  const Outcome outcome = program(
      {"trend", (npm_fixtures / "rope/engine.toml").string() + "@1.1"},
      "cd '" + folder.path().string() + "'; PATH='" + (folder.path() / "bin").string() + "'");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.errors.find("npm is not on PATH"), std::string::npos) << outcome.errors;
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
}

}  // namespace
}  // namespace tautline::test
