// The four words of verdicts are said alike wherever a report is shown.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "bench/page/page_assets.hpp"
#include "bench/report/output.hpp"
#include "bench/report/report.hpp"
#include "bench/report/summary.hpp"
#include "bench/report/words.hpp"
#include "tests/bench/gate/made_report.hpp"
#include "tests/bench/support.hpp"

namespace tautline::bench::test {
namespace {

/// On one line, without marks.
std::string plainly(const std::string& text) {
  std::istringstream words(text);
  std::string result;
  for (std::string word; words >> word;) {
    result += (result.empty() ? "" : " ") + word;
  }
  return std::regex_replace(result, std::regex("\\*|</?(em|strong)>"), "");
}

/// A report whose engine "e" has a run with each of the words.
Report report_of_all_words() {
  Report report = made_report();
  report.listed = ProblemsSource{"made.toml", "1"};
  add_engine(report, "e");
  for (const Word word : all_words) {
    RunRow& run = add_run(report, "e", 0.5);
    run.key.the_case = "ball" + std::to_string(report.runs.size());
    run.verdict = Verdict{word, {}};
    CaseRow the_case = report.cases.front();
    the_case.name = run.key.the_case;
    report.cases.push_back(the_case);
  }
  report.summary = summary(report.runs);
  return report;
}

/// A report of an engine of this precision whose errors at 1e-2, 1e-3 and 1e-4 s are these [m], in
/// a case of 2 m whose window is 3 s: single precision may add up to 3.6e-3 m at the finest step.
ConvergenceRow converging(const std::string& precision, const std::vector<double>& errors) {
  Report report = made_report();
  report.cases.front().extent = 2.0;
  add_engine(report, "some", precision);
  double step = 1e-2;
  for (const double error : errors) {
    add_run(report, "some", error, step).details->of_windows.front().until = 3.0;
    step /= 10.0;
  }
  return convergence(report).at(0);
}

TEST(Convergence, RoundingHasNoSlope) {
  const std::vector<double> rising = {2e-6, 5e-6, 4e-5};
  const ConvergenceRow single = converging("float32", rising);
  EXPECT_FALSE(single.slope);
  EXPECT_EQ(single.cases_at_rounding, 1U);
  const ConvergenceRow in_double = converging("float64", rising);
  ASSERT_TRUE(in_double.slope);
  EXPECT_LT(in_double.slope->median, 0.0);
  EXPECT_EQ(in_double.cases_at_rounding, 0U);
  EXPECT_EQ(converging("float64", {1e-12, 2e-12, 1e-11}).cases_at_rounding, 1U);
}

TEST(Convergence, ASlopeEndsWhereRoundingBegins) {
  const ConvergenceRow flat = converging("float32", {1e-2, 1e-3, 1.1e-3});
  ASSERT_TRUE(flat.slope);
  EXPECT_NEAR(flat.slope->median, 1.0, 1e-9);
  EXPECT_EQ(flat.cases_at_rounding, 0U);
  // larger than rounding can be: it is the model that does not converge
  const ConvergenceRow wrong = converging("float32", {1e-2, 1e-2, 1e-2});
  ASSERT_TRUE(wrong.slope);
  EXPECT_NEAR(wrong.slope->median, 0.0, 1e-9);
}

TEST(VerdictWords, AreExplainedAlikeOnThePageInMarkdownOnATerminalAndInTheDocs) {
  const Report report = report_of_all_words();
  const std::filesystem::path docs = std::filesystem::path(TAUTLINE_README).parent_path() / "docs";
  const std::string page = plainly(report_html(report, {}, page_assets()));
  const std::string markdown = plainly(report_markdown(report));
  const std::string terminal = plainly(report_summary(report, true, unlimited));
  const std::string recipe = plainly(content_of(docs / "guides" / "ci-recipe.md"));
  for (const Word word : all_words) {
    const std::string said = std::string(to_string(word)) + ": " + std::string(meaning_of(word));
    EXPECT_NE(page.find(said), std::string::npos) << said;
    EXPECT_NE(markdown.find(said), std::string::npos) << said;
    EXPECT_NE(terminal.find(said), std::string::npos) << said << "\n" << terminal;
    EXPECT_NE(recipe.find(said), std::string::npos) << said;
  }
}

TEST(VerdictWords, TheWorstOfAllCasesStandsInTheAnswersOfEveryRenderingWithItsCount) {
  Report report = report_of_all_words();
  for (const Word word : {Word::problem, Word::listed_problem, Word::too_few}) {
    const std::string said =
        std::string(to_string(word)) + " in 1 of " + std::to_string(report.runs.size());
    EXPECT_NE(report_html(report, {}, page_assets()).find(said), std::string::npos) << said;
    EXPECT_NE(report_markdown(report).find(said), std::string::npos) << said;
    EXPECT_NE(report_summary(report, true, unlimited).find(said), std::string::npos) << said;
    std::erase_if(report.runs, [&](const RunRow& run) { return run.verdict->word == word; });
    report.summary = summary(report.runs);
  }
  EXPECT_NE(report_summary(report, true, unlimited).find("sound"), std::string::npos);
}

TEST(VerdictWords, EachHasALookOfItsOwnOnThePage) {
  const std::string page = report_html(report_of_all_words(), {}, page_assets());
  for (const char* look : {"sound", "listed-problem", "problem", "too-few-to-tell"}) {
    EXPECT_NE(page.find(std::string("class=\"verdict ") + look + "\""), std::string::npos) << look;
    EXPECT_NE(page.find(std::string(".verdict.") + look), std::string::npos) << look;
  }
}

}  // namespace
}  // namespace tautline::bench::test
