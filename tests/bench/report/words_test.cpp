// The four words of verdicts are said alike wherever a report is shown.

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <sstream>
#include <string>

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
