#include "bench/tools/reproduce/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tautline::bench {
namespace {

/// A figure that plots the second column over the first.
ChapterFigure figure_of(std::vector<DataRow> rows) {
  ChapterFigure figure;
  figure.case_number = "1";
  figure.data = {{"t", "y"}, std::move(rows)};
  figure.y = 1;
  return figure;
}

TEST(FigureCurves, KeepTheCornersOfABounceAndNothingElse) {
  std::vector<DataRow> rows;
  for (int index = 0; index <= 2000; ++index) {
    const double time = index / 100.0;
    rows.push_back({{time, std::abs(time - 10.0)}, {}});
  }
  const std::vector<Curve> curves = figure_curves(figure_of(std::move(rows)));
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves.front().name, "case 1");
  EXPECT_EQ(curves.front().x, (std::vector<double>{0.0, 10.0, 20.0}));
  EXPECT_EQ(curves.front().y, (std::vector<double>{10.0, 0.0, 10.0}));
}

TEST(FigureCurves, StayWithinHalfAThousandthOfTheExtent) {
  std::vector<DataRow> rows;
  for (int index = 0; index <= 2000; ++index) {
    const double time = index / 100.0;
    rows.push_back({{time, std::sin(time)}, {}});
  }
  const Curve curve = figure_curves(figure_of(std::move(rows))).front();
  EXPECT_LT(curve.x.size(), most_points);
  for (std::size_t index = 1; index < curve.x.size(); ++index) {
    const double middle = (curve.x[index - 1] + curve.x[index]) / 2;
    const double drawn = (curve.y[index - 1] + curve.y[index]) / 2;
    // measured across the curve as it is drawn, y is off by at most this times the secant
    EXPECT_NEAR(drawn, std::sin(middle), 5e-4 * 2.0 * std::hypot(1.0, 10.0)) << middle;
  }
}

TEST(FigureCurves, OfNoiseHaveNoMorePointsThanAPlotShows) {
  std::vector<DataRow> rows;
  for (int index = 0; index < 5000; ++index) {
    rows.push_back({{index / 100.0, std::fmod(index * 0.618034, 1.0)}, {}});
  }
  const Curve curve = figure_curves(figure_of(std::move(rows))).front();
  EXPECT_LE(curve.x.size(), most_points);
  EXPECT_TRUE(std::is_sorted(curve.x.begin(), curve.x.end()));
}

TEST(FigureCurves, OfImpactsAreTheFastestOfEachCableInTheirOrder) {
  std::vector<DataRow> rows;
  for (int index = 0; index < 2000; ++index) {
    const double speed = index % 2 == 0 ? 2000.0 - index : 1.0;
    rows.push_back({{index / 100.0, speed, index % 2 == 0 ? 0.0 : 1.0}, {}});
  }
  ChapterFigure figure = figure_of(std::move(rows));
  figure.by = 2;
  const std::vector<Curve> curves = figure_curves(figure);
  ASSERT_EQ(curves.size(), 2U);
  EXPECT_EQ(curves[0].name, "cable 0");
  EXPECT_EQ(curves[1].name, "cable 1");
  ASSERT_EQ(curves[0].x.size(), most_points);
  for (std::size_t index = 0; index < most_points; ++index) {
    EXPECT_EQ(curves[0].y[index], 2000.0 - 2.0 * static_cast<double>(index));
  }
}

}  // namespace
}  // namespace tautline::bench
