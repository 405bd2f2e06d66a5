// What the program writes, as it stands in tests/data/golden: a file for each rendering. These hold
// the wording and the bytes; other tests ask for numbers and types. TAUTLINE_GOLDEN=write writes
// the files anew: read what changed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "bench/gate/changes_output.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/output.hpp"
#include "bench/report/summary.hpp"
#include "tests/bench/gate/made_report.hpp"
#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

namespace bt = bench::test;

constexpr bench::TerminalStyle narrow = {80, false, 80};

void expect_golden(const std::string& name, const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(TAUTLINE_GOLDEN_FOLDER) / name;
  if (const char* const mode = std::getenv("TAUTLINE_GOLDEN");
      mode && mode == std::string("write")) {
    std::ofstream(file) << text;
  }
  ASSERT_TRUE(std::filesystem::exists(file)) << file;
  EXPECT_EQ(content_of(file), text) << "if this is meant, write it with TAUTLINE_GOLDEN=write";
}

std::string printed(std::vector<std::string> arguments) {
  const Outcome outcome = program(arguments);
  EXPECT_EQ(outcome.errors, "");
  return outcome.output;
}

/// Two engines, one better than limits ask, one that failed; and a case of its own for each.
bench::Report report_of(double value) {
  bench::Report report = bt::made_report();
  bt::add_engine(report, "good");
  bt::add_engine(report, "poor", "float32");
  bt::add_run(report, "good", 1e-3);
  bt::add_run(report, "good", 1e-4, 1e-4);
  bt::add_run(report, "poor", value);
  bt::add_bad_run(report, "poor", bench::Status::stopped, "it left the table").key.step = 1e-4;
  report.summary = bench::summary(report.runs);
  return report;
}

TEST(Golden, Solve) {
  expect_golden("solve.txt", printed({"solve", "caught-swing", "--every", "1"}) + "\n" +
                                 printed({"solve", "level-beam", "--until", "1"}) + "\n" +
                                 printed({"solve", "spinning-rod", "--until", "0.2"}));
  expect_golden("solve.json", printed({"solve", "bouncing-ball", "--until", "2.7", "--every", "1",
                                       "--json", "-"}));
  expect_golden("solve.csv", printed({"solve", "caught-swing", "--every", "1", "--csv", "-"}));
}

TEST(Golden, Help) {
  std::string all = printed({"help"});
  for (const char* command :
       {"solve", "run", "bench", "merge", "compare", "trend", "ensemble", "bridge", "check",
        "calibrate", "reproduce", "engines", "cases", "schema", "help"}) {
    all += "\n" + printed({"help", command});
  }
  expect_golden("help.txt", all);
}

TEST(Golden, Report) {
  const bench::Report report = report_of(0.5);
  bench::Replay replay;
  replay.cases.resize(report.cases.size());
  replay.runs.resize(report.runs.size());
  expect_golden("report.json", bench::report_json(report, replay));
  expect_golden("report.md", bench::report_markdown(report));
  expect_golden("report.txt", bench::report_summary(report, true, narrow));
}

TEST(Golden, Compare) {
  const bench::Report before = report_of(0.5);
  const bench::Report after = report_of(0.9);
  const bench::Changes changes = bench::changes(before, after);
  expect_golden("changes.txt", bench::changes_text(changes, narrow));
  expect_golden("changes.json", bench::changes_json(changes));
  const bench::Trend trend =
      bench::trend({before, before, after}, {"a.json", "b.json", "c.json"}, bench::Noise());
  expect_golden("trend.txt", bench::trend_text(trend, false, narrow));
  expect_golden("trend.json", bench::trend_json(trend));
}

}  // namespace
}  // namespace tautline::test
