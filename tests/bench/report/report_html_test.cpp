#include "bench/report/output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <vector>

#include "bench/base/html.hpp"
#include "bench/replay/replay.hpp"
#include "bench/report/json/json.hpp"
#include "bench/report/scorecard.hpp"
#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using bench::page_assets;
using bench::Report;
using bench::report_html;
using nlohmann::ordered_json;

/// The report and the page of a small suite with good, stopped, failed and missing rows.
struct Made {
  Report report;
  bench::Replay replay;
  std::string page;
};

const Made& made() {
  static const Made result = [] {
    const TemporaryFolder out;
    const std::string engines = "exact," + bad_engine("segfault") + "," + bad_engine("mute") + "," +
                                bad_engine("no-taut-motion");
    static_cast<void>(
        program({"bench", "bouncing-ball", "breakwater/1510121100", "--engines", engines, "--steps",
                 "1e-2,1e-3", "--out", (out.path() / "r").string()}));
    const bench::ReportReading read =
        bench::report_from(content_of(out.path() / "r/report.json"), "report.json");
    EXPECT_TRUE(read.report) << bench::joined(read.problems, "and");
    return Made{read.report.value_or(Report()), read.replay,
                content_of(out.path() / "r/index.html")};
  }();
  return result;
}

/// A problem that is listed.
bench::Verdict listed_problem() {
  return {bench::Word::listed_problem,
          {{"energy", "gains energy in flight", 4.0, true, "the engine says so"}}};
}
const std::string listed_text = "energy: gains energy in flight";

/// The same report with everything in it that a suite may leave.
Report full_report() {
  Report report = made().report;
  for (bench::RunRow& run : report.runs) {
    run.verdict = listed_problem();
  }
  bench::CableRow cable;
  cable.length = 1.0;
  cable.restitution = 0.75;
  for (bench::CaseRow& the_case : report.cases) {
    the_case.plane = bench::PlaneRow{{}, Vec2::Zero(), {cable, cable}};
  }
  report.findings = {
      {"e", "m", "lost-below", "bounces slower than 0.2 m/s are lost", 0.2, "m/s", 3, 17, {}}};
  bench::CausesRow causes;
  causes.key = {"e", "m", 0.01};
  causes.cases = 4;
  causes.deviation = bench::MedianAndWorst{1.5e-3, 2.5e-3};
  causes.shares = bench::CauseParts{0.625, 0.375};
  causes.remainder = 1e-5;
  report.causes = {causes};
  return report;
}

/// The page without what stands in its scripts and its style.
std::string without_scripts(std::string page) {
  for (const std::string element : {"script", "style"}) {
    for (std::size_t at = page.find("<" + element); at != std::string::npos;
         at = page.find("<" + element, at + 1)) {
      const std::size_t start = page.find('>', at) + 1;
      page.erase(start, page.find("</" + element, start) - start);
    }
  }
  return page;
}

/// The names of the tags in their order, "/p" for an end; a quoted '>' does not end one.
std::vector<std::string> tags(const std::string& page) {
  static const std::regex tag("<(/?[a-zA-Z!][a-zA-Z0-9]*)(\"[^\"]*\"|[^\">])*>",
                              std::regex::optimize);
  const std::string text = without_scripts(page);
  std::vector<std::string> result;
  for (auto found = std::sregex_iterator(text.begin(), text.end(), tag);
       found != std::sregex_iterator(); ++found) {
    result.push_back((*found)[1]);
  }
  return result;
}

/// The first tag that does not fit; "" if every element is closed in its turn.
std::string unbalanced(const std::string& page) {
  const std::set<std::string> alone = {"!DOCTYPE", "meta", "link", "br"};
  std::vector<std::string> open;
  for (const std::string& name : tags(page)) {
    if (name.front() == '/') {
      if (open.empty() || "/" + open.back() != name) {
        return name + " closes " + (open.empty() ? "nothing" : open.back());
      }
      open.pop_back();
    } else if (!alone.contains(name)) {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : open.back() + " is open at the end";
}

/// What the page holds as its data.
std::string data_of(const std::string& page) {
  const std::string start = "<script type=\"application/json\" id=\"report-data\">";
  const std::size_t at = page.find(start) + start.size();
  return page.substr(at, page.find("</script>", at) - at);
}

void collect_numbers(const ordered_json& value, std::set<double>& numbers) {
  if (value.is_number()) {
    numbers.insert(value.get<double>());
  }
  if (value.is_structured()) {
    for (const ordered_json& part : value) {
      collect_numbers(part, numbers);
    }
  }
}

/// Half a unit of the last digit of a number as it is shown.
double half_unit(const std::string& shown) {
  const std::size_t exponent = shown.find('e');
  const std::string mantissa = shown.substr(0, exponent);
  const std::size_t point = mantissa.find('.');
  const auto digits = point == std::string::npos ? 0U : mantissa.size() - point - 1;
  const int power = exponent == std::string::npos ? 0 : std::stoi(shown.substr(exponent + 1));
  return 0.5 * std::pow(10.0, power - static_cast<int>(digits));
}

TEST(ReportPage, IsTheSameFromTheReportReadBack) {
  EXPECT_GT(made().page.size(), 10'000U);
  EXPECT_TRUE(made().page == report_html(made().report, made().replay, page_assets()));
}

TEST(ReportPage, IsWholeOrNotThere) {
  if (page_assets().plotly.empty()) {
    GTEST_SKIP() << "without Plotly the page is as small as the other files";
  }
  const TemporaryFolder out;
  const Outcome outcome =
      program({"bench", "bouncing-ball", "--engines", "exact", "--models", "event", "--steps",
               "1e-2", "--out", (out.path() / "r").string()},
              "ulimit -f 200;");  // room for every other file
  EXPECT_EQ(outcome.code, 1);
  EXPECT_NE(outcome.errors.find("index.html: File too large"), std::string::npos) << outcome.errors;
  const std::vector<std::string> whole = {"report.json", "report.md", "runs", "suite.json",
                                          "tautline-results.txt"};
  EXPECT_EQ(bench::test::names_in(out.path() / "r"), whole);
}

TEST(ReportPage, ClosesEveryElement) {
  EXPECT_EQ(unbalanced(made().page), "");
  EXPECT_EQ(unbalanced(report_html(full_report(), made().replay, page_assets())), "");
}

TEST(ReportPage, HasEverySection) {
  for (const std::string id : {"engines", "trust", "answers", "cases", "error", "replay", "audit",
                               "attribution", "models", "reading", "context"}) {
    EXPECT_NE(made().page.find("<section id=\"" + id + "\">"), std::string::npos) << id;
    EXPECT_NE(made().page.find("<a href=\"#" + id + "\">"), std::string::npos) << id;
  }
}

TEST(ReportPage, EveryNumberInItsTablesIsInTheReport) {
  const Report report = full_report();
  std::set<double> known;
  collect_numbers(ordered_json::parse(bench::report_json(report, made().replay)), known);
  // of the engines' own numbers scorecard_test says that they are those of the rows
  for (const bench::Scorecard& card : scorecards(report)) {
    for (const bench::ModelCard& of : card.models) {
      known.insert(100.0 * of.setups.back().off.value_or(0.0));
      known.insert(1e3 * (of.setups.back().cost ? of.setups.back().cost->second_cost : 0.0));
    }
  }
  const std::string page = without_scripts(report_html(report, made().replay, page_assets()));
  // the table of runs has five digits of each, or as many as it shows
  for (const double value : std::vector<double>(known.begin(), known.end())) {
    for (const int digits : {5, 6, 7, 8, 9}) {
      known.insert(bench::rounded(value, digits));
    }
  }
  static const std::regex cell("data-value=\"([^\"]+)\">([^<]*)<");
  std::size_t count = 0;
  for (auto found = std::sregex_iterator(page.begin(), page.end(), cell);
       found != std::sregex_iterator(); ++found) {
    const double value = std::stod((*found)[1]);
    const std::string shown = (*found)[2];
    EXPECT_TRUE(known.contains(value)) << (*found)[0];
    EXPECT_LE(std::abs(std::stod(shown) - value), half_unit(shown) * (1.0 + 1e-9)) << (*found)[0];
    ++count;
  }
  static const std::regex in_full("<td class=\"n\">([^<]*)<");  // what is shown is the value
  for (auto found = std::sregex_iterator(page.begin(), page.end(), in_full);
       found != std::sregex_iterator(); ++found) {
    EXPECT_TRUE(known.contains(std::stod((*found)[1]))) << (*found)[0];
    ++count;
  }
  EXPECT_GT(count, 200U);
}

TEST(ReportPage, HasTheRestitutionOfEachRunForItsBar) {
  const ordered_json data = ordered_json::parse(data_of(made().page));
  std::size_t bars = 0;
  for (std::size_t at = 0; at < made().report.runs.size(); ++at) {
    const bench::RunRow& row = made().report.runs[at];
    const ordered_json& run = data.at("runs").at(at);
    EXPECT_EQ(run.contains("status"), row.status != bench::Status::finished);
    if (row.key.the_case == "bouncing-ball" && row.key.engine == "exact") {
      EXPECT_EQ(run.at("e").at(0).get<int>() % 2, 0)
          << row.key.model << ": kept, or too few to tell";
      EXPECT_NEAR(run.at("e").at(1).get<double>(), 0.5, 0.02) << row.key.model;
      ++bars;
    }
    EXPECT_TRUE(row.judgement || !run.contains("e"));
  }
  EXPECT_GT(bars, 3U);
}

TEST(ReportPage, SaysWhichStepEachCaseNeeds) {
  for (const bench::CaseRow& row : made().report.cases) {
    const bench::StepNeeded& needed = row.step_needed.value();
    EXPECT_EQ(needed.part, 0.01);
    EXPECT_GT(needed.safe, 0.0);
    EXPECT_GE(needed.typical, needed.safe);
  }
  const std::size_t table = made().page.find("<table id=\"steps-table\"");
  ASSERT_NE(table, std::string::npos);
  // as tests/bench/judge has it of this case
  EXPECT_NE(
      made().page.find("<th scope=\"row\">bouncing-ball</th><td class=\"n\">0.01</td>", table),
      std::string::npos);
}

TEST(ReportPage, SaysWhatDifferenceOfDistributionsCouldHaveBeenSeen) {
  Report report = full_report();
  bench::Distributions of;
  of.draws = 20;
  of.statistics = {{"settling", "settled", "s", 1.0}};
  bench::DistributionRow row;
  row.statistic = "settling";
  row.visible = 0.634;
  of.setups = {{{"e", "m", 0.01}, 2, {row}}};
  report.distributions = of;
  const std::string page = report_html(report, made().replay, page_assets());
  EXPECT_NE(
      page.find("<td class=\"verdict too-few-to-tell\"><span>no difference above D = 0.63 seen, "
                "n = 18</span>"),
      std::string::npos);
}

TEST(ReportPage, AnEngineIsGreenOnlyWhereEveryModelWasJudged) {
  Report report = full_report();
  for (bench::RunRow& run : report.runs) {
    run.key.engine = "e";
    run.verdict = bench::Verdict{bench::Word::too_few, {}};
  }
  report.engines.front().name = report.engines.front().info->name = "e";
  report.models.clear();
  const std::string page = without_scripts(report_html(report, made().replay, page_assets()));
  EXPECT_NE(page.find("<b class=\"verdict too-few-to-tell\"><span>e</span>"), std::string::npos);
}

TEST(ReportPage, ShowsEveryRunAndWhyItFailed) {
  const std::string page = without_scripts(made().page);
  const std::size_t rows = made().report.runs.size();
  const std::size_t start = page.find("<table id=\"cases-table\"");
  const std::string table = page.substr(start, page.find("</table>", start) - start);
  std::size_t found = 0;
  for (std::size_t at = table.find("<tr"); at != std::string::npos;
       at = table.find("<tr", at + 1)) {
    ++found;
  }
  EXPECT_EQ(found, rows + 2);  // and two rows of headings
  EXPECT_NE(table.find("crashed: SIGSEGV"), std::string::npos);
  EXPECT_NE(table.find("stopped: a cable is taut"), std::string::npos);
  const std::size_t missing = page.find("<tbody class=\"missing\">");
  EXPECT_NE(page.find("mute</th>", missing), std::string::npos) << "an engine that does not answer";
}

TEST(ReportPage, ShowsProblemsBesideValuesAndNamesNoWinner) {
  const std::string page =
      without_scripts(report_html(full_report(), made().replay, page_assets()));
  EXPECT_NE(page.find("listed problem</span><br>" + listed_text + "</td>"), std::string::npos);
  for (const std::string word : {"winner", "best", "wins"}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
}

TEST(ReportPage, NamesNoNetworkAddress) {
  std::string page = made().page;
  const std::string names = "http://www.w3.org/";  // of XML's namespaces, which nothing fetches
  for (std::size_t at = page.find(names); at != std::string::npos; at = page.find(names, at)) {
    page.erase(at, names.size());
  }
  EXPECT_EQ(page.find("://"), std::string::npos) << page.substr(page.find("://") - 40, 80);
  const std::string ours =
      without_scripts(page) + std::string(page_assets().scripts) + std::string(page_assets().style);
  for (const std::string way :
       {" src=", "url(", "@import", "fetch(", "import(", "eval(", "XMLHttp"}) {
    EXPECT_EQ(ours.find(way), std::string::npos) << way;
  }
}

TEST(ReportPage, IsWholeWithoutPlotly) {
  bench::PageAssets bare = page_assets();
  bare.plotly = {};
  const std::string page = report_html(made().report, made().replay, bare);
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_EQ(page.find("<script id=\"plotly\">"), std::string::npos);
  EXPECT_NE(page.find("Charts are not in this build"), std::string::npos);
  EXPECT_NE(page.find("id=\"cases-table\""), std::string::npos);
}

TEST(ReportPage, IsWholeForAReportWithNothingInIt) {
  Report report;
  report.complete = false;
  const std::string page = report_html(report, made().replay, page_assets());
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_NE(page.find("This report is incomplete"), std::string::npos);
}

/// `report` with another name for a case, an engine or a model.
Report renamed(Report report, const std::string& from, const std::string& to) {
  const auto rename = [&](auto&... names) { ((names = names == from ? to : names), ...); };
  for (bench::EngineRow& engine : report.engines) {
    rename(engine.name);
    if (engine.info) {
      rename(engine.info->name);
      for (tautline::Model& model : engine.info->models) {
        rename(model.name);
      }
    }
  }
  for (bench::CaseRow& the_case : report.cases) {
    rename(the_case.name);
  }
  for (bench::SummaryRow& row : report.summary) {
    rename(row.key.engine, row.key.model);
  }
  for (bench::ConvergenceRow& row : report.convergence) {
    rename(row.engine, row.model);
  }
  for (bench::RunRow& run : report.runs) {
    rename(run.key.the_case, run.key.engine, run.key.model);
  }
  for (bench::CostRow& row : report.context.costs) {
    rename(row.key.engine, row.key.model);
  }
  for (bench::TimingRow& row : report.context.timing) {
    rename(row.key.the_case, row.key.engine, row.key.model);
  }
  return report;
}

TEST(ReportPage, HostileNamesAreHarmless) {
  const std::vector<std::string> expected =
      tags(report_html(full_report(), made().replay, page_assets()));
  const std::string names[] = {"</script><script>alert(1)</script>",
                               "\"><img src=x onerror=alert(1)>",
                               "' onmouseover='alert(1)",
                               "<!-- <script>",
                               "]]></td></table>&lt;&amp;**a** `b` *c*",
                               "line\nline\r\x1b[31m\x7f",
                               "\xe2\x80\xa8 and \xe2\x80\xae",
                               "\xff\xfe not UTF-8 \xc3",
                               std::string(10'240, 'x')};
  for (const std::string& name : names) {
    for (const std::string part : {"breakwater/1510121100", "exact", "event"}) {
      const Report report = renamed(full_report(), part, name);
      const std::string page = report_html(report, made().replay, page_assets());
      // where no `exact` is left to stand apart, there is a body less
      if (part != "exact") {
        EXPECT_TRUE(tags(page) == expected) << part << ": " << bench::printable(name);
      }
      EXPECT_EQ(unbalanced(page), "") << part << ": " << bench::printable(name);
      const std::string text = without_scripts(page);
      EXPECT_EQ(text.find('\r'), std::string::npos);
      EXPECT_EQ(text.find('\x1b'), std::string::npos);
      EXPECT_EQ(text.find(std::string(1000, 'x')), std::string::npos)
          << "a name of 10 kB is not cut";
      const std::string data = data_of(page);
      EXPECT_EQ(data.find('<'), std::string::npos);
      EXPECT_EQ(data.find("\xe2\x80\xa8"), std::string::npos);
      const ordered_json back = ordered_json::parse(data, nullptr, false);
      EXPECT_FALSE(back.is_discarded());
      EXPECT_TRUE(back == ordered_json::parse(bench::page_json(report, made().replay)))
          << "the data are not the report's";
    }
  }
}

TEST(Html, MarksUpPairsAndNothingElse) {
  EXPECT_EQ(bench::html_prose("**a** and *b* and `c<d`"),
            "<strong>a</strong> and <em>b</em> and <code>c&lt;d</code>");
  EXPECT_EQ(bench::html_prose("2 * 3 * 4"), "2 * 3 * 4");
  EXPECT_EQ(bench::html_prose("one * alone, *open"), "one * alone, *open");
  EXPECT_EQ(bench::html_text("a & <b> \"c\" 'd'"), "a &amp; &lt;b&gt; &quot;c&quot; &#39;d&#39;");
}

TEST(ReportMarkdown, SaysTheVerdictOfEveryRunAndWhatIsWrong) {
  Report report = full_report();
  ASSERT_TRUE(report.listed);
  const std::string said = "listed problem: " + listed_text + " ";
  const std::string markdown = bench::report_markdown(report);
  std::size_t count = 0;
  for (std::size_t at = markdown.find(said); at != std::string::npos;
       at = markdown.find(said, at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, report.runs.size());
  report.listed.reset();
  EXPECT_EQ(bench::report_markdown(report).find(said), std::string::npos);
}

}  // namespace
}  // namespace tautline::test
