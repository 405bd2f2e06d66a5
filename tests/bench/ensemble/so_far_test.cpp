// What an ensemble says of draws that are missing, have no value or have not locked, and of those
// so far.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/ensemble/output/atlas.hpp"
#include "bench/ensemble/output/comparison.hpp"
#include "bench/ensemble/output/output.hpp"
#include "bench/ensemble/output/results_so_far.hpp"
#include "bench/ensemble/team.hpp"
#include "tests/bench/ensemble/solved.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench {
namespace {

/// The sentences on `result`, one a line.
std::string words_of(const EnsembleRequest& request, const EnsembleResult& result) {
  const Findings findings = findings_of(request, result, 1);
  std::string words;
  for (const std::string& sentence : ensemble_sentences({request, result, findings})) {
    words += sentence + "\n";
  }
  return words;
}

bool has(const std::string& words, const std::string& part) {
  return words.find(part) != std::string::npos;
}

// of a restitution of 1 a body bounces for ever, of 0 it locks with the first impact on both cables
TEST(EnsembleWords, WhatSomeDrawsHaveIsNotTheSameInAll) {
  const EnsembleRequest request = request_of(
      "case = \"breakwater/1910121100\"\nuntil = 5\ncount = 20\n"
      "[[vary]]\nquantities = [\"restitution\"]\nlist = [1.0, 0.0]\n");
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 1);
  const EnsembleReport report{request, result, findings};
  const std::size_t lock = place_of_statistic(findings.statistics, "lock");
  const Summary& locks = findings.summaries[0][lock];
  ASSERT_GT(locks.count, 0U);
  ASSERT_GT(locks.without, 0U);
  EXPECT_FALSE(common_value(report, lock));
  const std::string words = words_of(request, result);
  EXPECT_FALSE(has(words, "lock (")) << words;
  EXPECT_TRUE(has(words, "first cable (0)")) << words;
  EXPECT_TRUE(
      has(words, "exact: " + std::to_string(locks.without) +
                     " of 20 draws have not locked by 5 s: later impacts than the last ones "
                     "until then may follow."))
      << words;
  EXPECT_TRUE(has(ensemble_text(report, {}), "\nlock [s]"));
}

TEST(EnsembleWords, WhatHasNotLockedIsNeitherCapturedNorReleased) {
  const EnsembleRequest request =
      request_of(perturbed("1910121100", 12) + "[[exact]]\nname = \"a\"\n");
  EnsembleRequest early = request;
  std::get<Case>(early.spec.the_case).duration = 3.0;  // it locks after some 8 s
  const EnsembleResult result = solved(early);
  const std::size_t captured = place_of_statistic(statistics_of(early.spec), "captured");
  for (const DrawTable& draws : result.draws) {
    for (std::size_t draw = 0; draw < draws.size(); ++draw) {
      EXPECT_TRUE(draws.solved(draw));
      EXPECT_FALSE(draws.value(draw, captured));
    }
  }
  const std::string words = words_of(early, result);
  EXPECT_FALSE(has(words, "captured")) << words;
  EXPECT_TRUE(has(words, "exact: 12 of 12 draws have not locked by 3 s")) << words;
  EXPECT_TRUE(has(words, "a: 12 of 12 draws have not locked by 3 s")) << words;
  EXPECT_FALSE(has(words_of(request, solved(request)), "not locked"));
}

TEST(EnsembleWords, AnEngineWithoutTheModelsIsNamed) {
  EnsembleRequest request = request_of(perturbed("1510121100", 12));
  RegisteredEngine engine;
  engine.name = "other";
  engine.info.emplace();
  for (const char* const model : {"rope", "event-handler"}) {
    engine.info->models.emplace_back().name = model;
  }
  request.engines = {engine};
  request.spec.models = {"event"};
  request.setups = setups_of(request.spec, request.engines);
  ASSERT_EQ(request.setups.size(), 1U);
  const EnsembleResult result = solved(request);
  EXPECT_TRUE(has(words_of(request, result),
                  "other has no part: it has no model event; it has rope and event-handler."));
  request.spec.models = {"rope"};
  request.spec.steps = {1e-3};
  request.setups = setups_of(request.spec, request.engines);
  EnsembleResult both = solved(request_of(perturbed("1510121100", 12)));
  both.draws.push_back(both.draws.front());
  EXPECT_FALSE(has(words_of(request, both), "has no part"));
}

// of some cells of this grid a cable is stretched at the start
TEST(EnsembleWords, ACellWhoseDrawIsNoCaseLeadsNowhere) {
  const EnsembleRequest request = request_of(
      "case = \"breakwater/1510121100\"\nuntil = 3\ncount = 1\n"
      "[[vary]]\nquantities = [\"angle\"]\ngrid = [-0.4, 0.4]\npoints = 9\n"
      "[[vary]]\nquantities = [\"spin\"]\ngrid = [-1, 1]\npoints = 2\n");
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 1);
  const EnsembleReport report{request, result, findings};
  ASSERT_GT(findings.problems[0], 0U);
  ASSERT_LT(findings.problems[0], 18U);
  const Atlas atlas = atlas_of(report).value();
  const std::string page = ensemble_html(report, {});
  const test::TemporaryFolder folder;
  write_ensemble(folder.path(), report);
  for (std::size_t cell = 0; cell < 18; ++cell) {
    const bool is_case = result.draws[0].solved(cell);
    EXPECT_EQ(atlas.pictured[cell], is_case);
    EXPECT_EQ(has(page, "href=\"" + picture_name(cell) + "\""), is_case) << cell;
    EXPECT_EQ(std::filesystem::exists(folder.path() / picture_name(cell)), is_case) << cell;
  }
  const std::string picture = test::content_of(folder.path() / picture_name(4));
  EXPECT_TRUE(has(picture, "breakwater/1510121100, draw 4: angle = 0, spin = -1"))
      << picture.substr(0, 500);
}

TEST(ResultsSoFar, AreWrittenAfterAPauseAndSeldomEnough) {
  double now = 100.0;
  double takes = 0.1;  // [s], to write
  std::vector<double> written;
  ResultsSoFar results(
      [&](const EnsembleResult&) {
        written.push_back(now);
        now += takes;
      },
      [&] { return now; });
  const auto go_on = [&](double until) {
    for (; now < until; now += 0.25) {
      results.offer({});
    }
  };
  go_on(135.0);
  ASSERT_EQ(written.size(), 3U);
  EXPECT_NEAR(written[0], 110.0, 0.5);
  EXPECT_NEAR(written[1] - written[0], 10.0, 0.5);
  takes = 5.0;
  written.clear();
  go_on(1100.0);
  ASSERT_GT(written.size(), 5U);
  const double in_all = takes * static_cast<double>(written.size());
  EXPECT_LE(in_all, 0.055 * (1100.0 - 135.0)) << "of the time, a twentieth";
}

TEST(ResultsSoFar, AreShownAfterEachChunkAndSaySo) {
  const EnsembleRequest request = request_of(perturbed("1510121100", 500));
  std::vector<std::size_t> ended;
  std::string words;
  EnsembleOptions options;
  options.so_far = [&](const EnsembleResult& so_far) {
    EXPECT_TRUE(so_far.goes_on);
    ended.push_back(so_far.draws[0].ended());
    words = words_of(request, so_far);
  };
  const EnsembleResult result = solve_ensemble(request, options, [](auto&&...) {});
  EXPECT_EQ(ended, std::vector<std::size_t>({200, 400, 500}));
  EXPECT_TRUE(words.starts_with("Not all draws: these are the ones done when this was written.\n"))
      << words;
  EXPECT_FALSE(result.goes_on);
  EXPECT_FALSE(has(words_of(request, result), "Not all draws"));
}

// each process tells of all draws that somebody has begun before its own next ones
TEST(EnsembleTeam, AProcessTellsOfTheDrawsOfAll) {
  const EnsembleRequest request = request_of(perturbed("1510121100", 500));
  const test::TemporaryFolder folder;
  Team team;
  ASSERT_EQ(team.size(), 1U);
  static_cast<void>(team.next());  // the first chunk is another's
  EnsembleOptions options;
  options.out = folder.path();
  options.team = &team;
  std::size_t told = 0;
  static_cast<void>(solve_ensemble(request, options,
                                   [&](const auto&, std::size_t draws, bool) { told += draws; }));
  EXPECT_EQ(told, 500U);
}

}  // namespace
}  // namespace tautline::bench
