#include <gtest/gtest.h>

#include <algorithm>

#include "tests/bench/reproduce/reproduced.hpp"

namespace tautline::test {
namespace {

using nlohmann::json;

/// The page of the chapter as the program wrote it.
class ReproducedPage : public Reproduced {
 protected:
  static std::string page() { return content_of(out() / "chapter.html"); }

  /// The figures that its script draws.
  static json figures() {
    const std::string text = page();
    const std::string tag = "id=\"chapter-data\">";
    const std::size_t start = text.find(tag) + tag.size();
    return json::parse(text.substr(start, text.find("</script>", start) - start)).at("figures");
  }
};

TEST_F(ReproducedPage, NamesTheSwingFirst) {
  const std::string text = page();
  const std::size_t first = text.find("<ol class=\"corrections\">");
  ASSERT_NE(first, std::string::npos);
  const std::string item = text.substr(first, text.find("</li>", first) - first);
  EXPECT_NE(item.find("a swing without losses"), std::string::npos) << item;
  EXPECT_LT(text.find("a swing without losses"), text.find("Eq. 5.4"));
}

TEST_F(ReproducedPage, HasEveryTableFigureAndCorrection) {
  const std::string text = page();
  for (const char* id : {"table-5-1", "table-5-2", "table-5-3"}) {
    EXPECT_NE(text.find("<table id=\"" + std::string(id) + "\">"), std::string::npos) << id;
  }
  EXPECT_EQ(figures().size(), 15U);
  for (const json& figure : chapter().at("figures")) {
    EXPECT_NE(text.find("<b>Fig. " + figure.at("name").get<std::string>() + ".</b>"),
              std::string::npos);
    EXPECT_NE(text.find("href=\"chapter/" + figure.at("file").get<std::string>() + "\""),
              std::string::npos);
  }
  for (const json& one : chapter().at("corrections")) {
    EXPECT_NE(text.find("<strong>" + one.at("where").get<std::string>()), std::string::npos);
  }
}

TEST_F(ReproducedPage, ThinsCurvesWithoutLosingTheirExtent) {
  constexpr std::size_t most_points = 600;
  const json drawn = figures();
  for (const json& figure : drawn) {
    EXPECT_FALSE(figure.at("curves").empty()) << figure.at("name");
    for (const json& curve : figure.at("curves")) {
      EXPECT_LE(curve.at("x").size(), most_points) << figure.at("name");
      EXPECT_EQ(curve.at("x").size(), curve.at("y").size()) << figure.at("name");
    }
  }
  // the angle of case 1911121100 over the 20 time units of its run, by the largest that the caption
  // names
  const auto rotation = std::find_if(
      drawn.begin(), drawn.end(), [](const json& figure) { return figure.at("name") == "5.12"; });
  ASSERT_NE(rotation, drawn.end());
  const auto times = rotation->at("curves").at(0).at("x").get<std::vector<double>>();
  const auto angles = rotation->at("curves").at(0).at("y").get<std::vector<double>>();
  EXPECT_EQ(times.front(), 0.0);
  EXPECT_EQ(times.back(), 20.0);
  const auto [least, largest] = std::minmax_element(angles.begin(), angles.end());
  const std::string truth = entry("figures", "name", "5.12").at("truth");
  const std::size_t at = truth.find("largest |theta| ") + std::string("largest |theta| ").size();
  const double named = std::stod(truth.substr(at));
  // a sample each 0.01 and corners within 5e-4 of the extent miss a peak by less than a thousandth
  EXPECT_NEAR(std::max(-*least, *largest), named, 1e-3 * (*largest - *least));
}

}  // namespace
}  // namespace tautline::test
