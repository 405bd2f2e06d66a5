#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/bench/program.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// The report and the page of the chapter's cases, run whole on the exact engine; once for all
/// tests.
class ReportChapter : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const TemporaryFolder out;
    const Outcome outcome = program({"bench", "breakwater/*", "--engines", "exact", "--models",
                                     "event", "--steps", "0.1", "--out", out.path() / "r"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    chapter = json::parse(content_of(out.path() / "r/report.json")).at("chapter");
    page = content_of(out.path() / "r/index.html");
  }

  static json chapter;
  static std::string page;
};

json ReportChapter::chapter;
std::string ReportChapter::page;

TEST_F(ReportChapter, NamesTheSwingFirst) {
  const json& first = chapter.at("corrections").at(0);
  EXPECT_NE(first.at("right").get<std::string>().find("a swing without losses"), std::string::npos);
  EXPECT_EQ(first.at("holds"), false);
  EXPECT_LT(page.find("a swing without losses"), page.find("Eq. 5.4"));
}

TEST_F(ReportChapter, HasEveryTableAndFigure) {
  EXPECT_EQ(chapter.at("tables").size(), 3U);
  EXPECT_EQ(chapter.at("figures").size(), 15U);
  for (const json& figure : chapter.at("figures")) {
    EXPECT_NE(page.find("data-figure=\"" + figure.at("name").get<std::string>() + "\""),
              std::string::npos);
  }
}

TEST_F(ReportChapter, ThinsCurvesWithoutLosingTheirExtent) {
  constexpr std::size_t most_points = 600;
  for (const json& figure : chapter.at("figures")) {
    EXPECT_FALSE(figure.at("curves").empty()) << figure.at("name");
    for (const json& curve : figure.at("curves")) {
      EXPECT_LE(curve.at("x").size(), most_points) << figure.at("name");
      EXPECT_EQ(curve.at("x").size(), curve.at("y").size()) << figure.at("name");
    }
  }
  // the angle of case 1911121100 over the 20 time units of its run, by the largest that the caption
  // names
  const auto& figures = chapter.at("figures");
  const auto rotation = std::find_if(figures.begin(), figures.end(), [](const json& figure) {
    return figure.at("name") == "5.12";
  });
  ASSERT_NE(rotation, figures.end());
  const auto times = rotation->at("curves").at(0).at("x").get<std::vector<double>>();
  const auto angles = rotation->at("curves").at(0).at("y").get<std::vector<double>>();
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 20.0);
  const auto [least, largest] = std::minmax_element(angles.begin(), angles.end());
  const std::string truth = rotation->at("truth");
  const std::size_t at = truth.find("largest |theta| ") + std::string("largest |theta| ").size();
  const double named = std::stod(truth.substr(at));
  // a sample each 0.01 and corners within 5e-4 of the extent miss a peak by less than a thousandth
  EXPECT_NEAR(std::max(-*least, *largest), named, 1e-3 * (*largest - *least));
}

}  // namespace
}  // namespace tautline::test
