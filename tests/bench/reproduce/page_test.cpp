#include "bench/tools/reproduce/output.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

namespace tautline::bench {
namespace {

using nlohmann::json;

constexpr PageAssets assets{"body {}\n", "", "run();\n", "plotly();", "MIT"};
constexpr const char* hostile = "</script><script>alert(1)</script>";

/// A report with one of everything.
ChapterReport small_report() {
  ChapterFigure figure;
  figure.number = "5.6";
  figure.title = "y over x";
  figure.file = "figure_5_06.csv";
  figure.data = {{"x [S]", "y [S]"}, {{{0.0, 1.0 / 3.0}, {}}, {{1.0, 2.0}, {}}}};
  figure.y = 1;
  figure.case_number = "1";
  figure.chapter = "It says.";
  figure.truth = "**It is.**";
  figure.marks = {{0.5, hostile}};
  figure.boundary = Boundary{
      "figure_5_06_boundary.csv",
      {{"x", "right", "left", "lowest"}, {{{0.0, 1.0, 2.0, 2.0}, {}}, {{1.0, 1.0, 2.0, 2.0}, {}}}}};
  const ChapterTable table{
      "Table 5.2",
      "Moments of *inertia*.",
      "table_5_2.csv",
      1,
      {{"shape", "", ""},
       {"printed", "mS^2", ""},
       {"exact", "mS^2", "{:.2f}"},
       {"impacts", "", ""}},
      {{"circle", "0.012", 0.0123456789, 7L}, {"box, flat", "0.1", ChapterCell(), 8L}},
      {"A **note**."}};
  const Correction wrong{false,       "Section 5.1", "It settles.",
                         "It moves.", "By 1.",       {{"by", {1.0}}}};
  const Correction swing{false,
                         "Section 5.8",
                         "It settles.",
                         "It swings.",
                         "By 0.65 rad.",
                         {},
                         {"cases", {{{"pair", {1L, 2L}}}}},
                         true};
  const Correction holds{true, "Table 5.1", hostile, "It does.", "By 0.", {}};
  return {"The *source*.", {"Units."}, {table}, {figure}, {wrong, swing, holds}};
}

/// The first tag that does not fit; "" if every element is closed in its turn.
std::string unbalanced(const std::string& page) {
  static const std::regex tag("<(/?[a-zA-Z!][a-zA-Z0-9]*)(\"[^\"]*\"|[^\">])*>");
  const std::set<std::string> alone = {"!DOCTYPE", "meta", "link", "br"};
  std::vector<std::string> open;
  for (auto found = std::sregex_iterator(page.begin(), page.end(), tag);
       found != std::sregex_iterator(); ++found) {
    const std::string name = (*found)[1];
    if (name.front() != '/' && !alone.contains(name)) {
      open.push_back(name);
    } else if (name.front() == '/') {
      if (open.empty() || open.back() != name.substr(1)) {
        return name;
      }
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

bool holds_text(const std::string& page, const std::string& text) {
  return page.find(text) != std::string::npos;
}

TEST(ChapterPage, ClosesEveryElementWhateverTheTextsHold) {
  const std::string page = chapter_page(small_report(), assets);
  EXPECT_EQ(unbalanced(page), "");
  EXPECT_FALSE(holds_text(page, "<script>alert"));
}

TEST(ChapterPage, SetsTablesInHtmlWithTheirNumbersInFull) {
  const std::string page = chapter_page(small_report(), assets);
  EXPECT_TRUE(holds_text(page, "<table id=\"table-5-2\">"));
  EXPECT_TRUE(holds_text(page, "<td data-value=\"0.0123456789\">0.01</td>"));
  EXPECT_TRUE(holds_text(page, "<td class=\"n\">0.012</td>")) << "printed digits stay as they are";
  EXPECT_TRUE(holds_text(page, "<th scope=\"row\">circle</th>"));
  EXPECT_TRUE(holds_text(page, ">7</td>"));
  EXPECT_TRUE(holds_text(page, "<a href=\"chapter/table_5_2.csv\">"));
}

TEST(ChapterPage, TellsFirstWhatTheChapterMissed) {
  const std::string page = chapter_page(small_report(), assets);
  EXPECT_LT(page.find("Section 5.8"), page.find("Section 5.1"));
  EXPECT_LT(page.find("It swings."), page.find("<main>"));
}

TEST(ChapterPage, GivesItsScriptTheCurvesOfEveryFigure) {
  const json figure = json::parse(chapter_page_data(small_report())).at("figures").at(0);
  EXPECT_EQ(figure.at("name"), "5.6");
  EXPECT_EQ(figure.at("curves").at(0).at("y"), (std::vector<double>{0.333333, 2.0}));
  EXPECT_EQ(figure.at("boundary").at("name"), "boundary at angle 0");
  EXPECT_EQ(figure.at("marks").at(0).at("meaning"), hostile);
}

TEST(ChapterPage, SetsSignsThatTextSpells) {
  ChapterReport report = small_report();
  report.tables.front().notes = {"Y <= H in sqrt(S/g), at 2 m/s^2."};
  const std::string page = chapter_page(report, assets);
  EXPECT_TRUE(holds_text(page, "Y ≤ H in √(S/g), at 2 m/s²."));
  EXPECT_TRUE(holds_text(page, "[mS²]"));
}

TEST(ChapterPage, WithoutPlotlySaysSoAndLeavesNoEmptyPlot) {
  PageAssets bare = assets;
  bare.plotly = "";
  const std::string page = chapter_page(small_report(), bare);
  EXPECT_TRUE(holds_text(page, "without Plotly"));
  EXPECT_FALSE(holds_text(page, "class=\"chart\""));
  EXPECT_TRUE(holds_text(page, "<b>Fig. 5.6.</b>"));
}

TEST(ChapterCsv, HasTheColumnsTheNumbersAndTheWords) {
  ChapterReport report = small_report();
  EXPECT_EQ(data_csv(report.figures.front().data), "x [S],y [S]\n0,0.333333333333\n1,2\n");
  report.figures.front().data.columns.emplace_back("kind");
  for (DataRow& row : report.figures.front().data.rows) {
    row.words.emplace_back("impact");
  }
  EXPECT_TRUE(data_csv(report.figures.front().data).ends_with("1,2,impact\n"));
  EXPECT_EQ(table_csv(report.tables.front()),
            "shape,printed [mS^2],exact [mS^2],impacts\n"
            "circle,0.012,0.0123456789,7\n"
            "\"box, flat\",0.1,,8\n");
}

TEST(ChapterJson, NamesOneNumberAloneAndSeveralAsAList) {
  const json corrections = json::parse(chapter_json(small_report())).at("corrections");
  EXPECT_EQ(corrections.at(0).at("numbers"), json::parse(R"({"by": 1.0})"));
  EXPECT_EQ(corrections.at(1).at("numbers"), json::parse(R"({"cases": [{"pair": [1, 2]}]})"));
  EXPECT_EQ(corrections.at(2).at("numbers"), json::object());
}

}  // namespace
}  // namespace tautline::bench
