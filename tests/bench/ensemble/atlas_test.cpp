// The maps of an ensemble over two grids: what their cells have, and what their colours say.

#include "bench/ensemble/output/atlas.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "bench/ensemble/output/comparison.hpp"
#include "tests/bench/ensemble/solved.hpp"

namespace tautline::bench {
namespace {

/// Two grids of so many points, and so many draws at each.
std::string two_grids(int across, int up, int per_cell) {
  return "case = \"breakwater/1910121100\"\nuntil = 4\ncount = " + std::to_string(per_cell) +
         "\n[[vary]]\nquantities = [\"x\"]\ngrid = [-0.08, 0.08]\npoints = " +
         std::to_string(across) +
         "\n[[vary]]\nquantities = [\"spin\"]\ngrid = [-8, 8]\npoints = " + std::to_string(up) +
         "\n[[vary]]\nquantities = [\"velocity_x\"]\nuniform = [-0.5, 0.5]\n";
}

/// An atlas of one row of amounts.
Atlas row_of(const std::vector<double>& amounts) {
  const std::vector<double> places(amounts.size(), 0.0);
  const Varied across{"x", {Distribution::Kind::grid, places}};
  const Varied up{"spin", {Distribution::Kind::grid, {0.0}}};
  AtlasMap map{0, {}, {}};
  map.cells.assign(amounts.begin(), amounts.end());
  const std::vector<std::size_t> draws(amounts.size(), 0);
  return {{across, up}, {map}, draws, std::vector<bool>(amounts.size(), false)};
}

const Statistic any_count{"impacts", "impacts",      "",        as_count, true,
                          true,      OfEngines::all, "how many"};

/// The colour of each cell, in their order.
std::vector<std::string> colours_of(const std::string& svg) {
  const std::regex cell("fill=\"([^\"]*)\"><title>");
  std::vector<std::string> result;
  for (std::sregex_iterator next(svg.begin(), svg.end(), cell), end; next != end; ++next) {
    result.push_back((*next)[1]);
  }
  return result;
}

/// The colour beside each word of the legend.
std::map<std::string, std::string> legend_of(const std::string& svg) {
  const std::regex entry("fill=\"([^\"]*)\"/>\\n<text[^>]*>([^<]*)</text>");
  std::map<std::string, std::string> result;
  for (std::sregex_iterator next(svg.begin(), svg.end(), entry), end; next != end; ++next) {
    result[(*next)[2]] = (*next)[1];
  }
  return result;
}

// the two grids go fastest: cell c has the draws c, c + 12, ...
TEST(Atlas, ACellHasWhatItsDrawsHave) {
  const EnsembleRequest request = request_of(two_grids(4, 3, 5));
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 1);
  const Atlas atlas = atlas_of({request, result, findings}).value();
  ASSERT_EQ(atlas.maps.size(), 5U);
  std::size_t mixed = 0;  // cells whose draws hit different cables first
  for (const AtlasMap& map : atlas.maps) {
    const std::string& name = findings.statistics[map.statistic].name;
    const bool is_cable = name == "first_cable";
    ASSERT_EQ(map.cells.size(), 12U);
    EXPECT_EQ(map.names.empty(), !is_cable && name != "captured");
    for (std::size_t cell = 0; cell < 12; ++cell) {
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t draw = cell; draw < 60; draw += 12) {
        if (const auto value = result.draws[0].value(draw, map.statistic)) {
          sum += *value;
          count += 1.0;
        }
      }
      if (is_cable) {
        ASSERT_EQ(count, 5.0);
        EXPECT_EQ(map.cells[cell], sum > 2.0 ? 1.0 : 0.0) << "of five of cable 0 or 1";
        mixed += sum > 0.0 && sum < 5.0 ? 1U : 0U;
      } else if (count > 0.0) {
        EXPECT_NEAR(map.cells[cell].value(), sum / count, 1e-12 * (1.0 + sum));
      } else {
        EXPECT_FALSE(map.cells[cell]);
      }
    }
  }
  EXPECT_GT(mixed, 0U);
}

/// The atlas of two by two cells of so many draws each, whose `captured` are these.
AtlasMap map_of_captured(int per_cell, const std::vector<double>& captured) {
  const EnsembleRequest request = request_of(two_grids(2, 2, per_cell));
  const std::vector<Statistic> statistics = statistics_of(request.spec);
  const std::size_t place = place_of_statistic(statistics, "captured");
  EnsembleResult result;
  result.draws.emplace_back(statistics.size(), captured.size(), captured.size());
  for (std::size_t draw = 0; draw < captured.size(); ++draw) {
    DrawResult of_draw{draw, {}, StatisticValues(statistics.size())};
    of_draw.values[place] = captured[draw];
    result.draws.back().put(of_draw);
  }
  Findings findings;
  findings.statistics = statistics;
  return atlas_of({request, result, findings}).value().maps[3];
}

TEST(Atlas, WhatIsCapturedHasANameOrAShare) {
  EXPECT_EQ(map_of_captured(1, {1.0, 0.0, 1.0, 1.0}).names,
            (std::vector<std::string>{"released", "captured"}));
  const AtlasMap shares = map_of_captured(2, {1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0, 1.0});
  EXPECT_TRUE(shares.names.empty());
  EXPECT_EQ(shares.cells, (std::vector<std::optional<double>>{0.5, 0.0, 1.0, 1.0}));
}

TEST(Atlas, NamesHaveColoursOfTheirOwnAndALegend) {
  const EnsembleRequest request = request_of(two_grids(5, 4, 1));
  const EnsembleResult result = solved(request);
  const Findings findings = findings_of(request, result, 1);
  const Atlas atlas = atlas_of({request, result, findings}).value();
  const AtlasMap& map = atlas.maps.back();
  const Statistic& statistic = findings.statistics[map.statistic];
  ASSERT_EQ(statistic.name, "first_cable");
  const std::string svg = atlas_svg(atlas, map, statistic);
  const std::map<std::string, std::string> legend = legend_of(svg);
  ASSERT_EQ(legend.size(), 2U);
  EXPECT_NE(legend.at("cable 0"), legend.at("cable 1"));
  const std::vector<std::string> colours = colours_of(svg);
  ASSERT_EQ(colours.size(), 20U);
  for (std::size_t cell = 0; cell < 20; ++cell) {
    EXPECT_EQ(colours[cell], legend.at(map.cells[cell] == 1.0 ? "cable 1" : "cable 0")) << cell;
  }
  EXPECT_NE(svg.find(": cable 1</title>"), std::string::npos);
}

TEST(Atlas, OneCellDoesNotLeaveTheOthersDark) {
  std::vector<double> amounts(200);
  std::iota(amounts.begin(), amounts.end(), 100.0);
  amounts.back() = 1e6;
  const Atlas atlas = row_of(amounts);
  const std::string svg = atlas_svg(atlas, atlas.maps.front(), any_count);
  const std::vector<std::string> colours = colours_of(svg);
  EXPECT_GT(std::set<std::string>(colours.begin(), colours.end()).size(), 150U);
  EXPECT_EQ(colours[0], colours[2]) << "two hundredths are four cells, two at each end";
  EXPECT_NE(colours[2], colours[4]);
  EXPECT_NE(colours[196], colours[197]);
  EXPECT_EQ(colours[197], colours[199]);
  EXPECT_NE(svg.find(">≤ 102</text>"), std::string::npos);
  EXPECT_NE(svg.find(">≥ 297</text>"), std::string::npos);
  EXPECT_NE(svg.find(": 1e+06</title>"), std::string::npos) << "the cell has its own number";
}

TEST(Atlas, AmountsOverDecadesHaveColoursByTheirLogarithm) {
  const Atlas atlas = row_of({0.0, 1.0, 10.0, 100.0, 1000.0, 10000.0});
  const std::string svg = atlas_svg(atlas, atlas.maps.front(), any_count);
  const std::vector<std::string> colours = colours_of(svg);
  // the colours of viridis at 0, 1/4, ..., and none darker for 0
  const std::vector<std::string> even = {"rgb(68,1,84)",    "rgb(68,1,84)",   "rgb(59,82,139)",
                                         "rgb(33,145,140)", "rgb(94,201,98)", "rgb(253,231,37)"};
  EXPECT_EQ(colours, even);
  for (const char* words : {"log scale", "≤ 1", "10", "100", "1000", "1e+04"}) {
    EXPECT_NE(svg.find(fmt::format(">{}</text>", words)), std::string::npos) << words;
  }
}

TEST(Atlas, LessThanADecadeAndSharesHaveEvenColours) {
  const Atlas small = row_of({1.0, 4.0, 7.0});
  EXPECT_EQ(atlas_svg(small, small.maps.front(), any_count).find("log scale"), std::string::npos);
  Statistic share = any_count;
  share.name = "captured";
  const Atlas shares = row_of({0.01, 0.5, 1.0});
  EXPECT_EQ(atlas_svg(shares, shares.maps.front(), share).find("log scale"), std::string::npos);
}

TEST(Atlas, ItsNumbersAreALineForEachCell) {
  Atlas atlas = row_of({3.0, 5.0});
  atlas.maps.front().cells.back().reset();
  const std::string csv = atlas_csv(atlas, atlas.maps.front(), any_count);
  const Varied& across = atlas.axes[0];
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3) << csv;
  EXPECT_NE(csv.find(fmt::format("{},", across.distribution.numbers[0])), std::string::npos) << csv;
  EXPECT_NE(csv.find(",3\n"), std::string::npos) << csv;
  EXPECT_TRUE(csv.ends_with(",\n")) << csv;
}

TEST(Atlas, TheBarHasTheNumbersOfFewCells) {
  const Atlas atlas = row_of({3.0, 5.0, 4.0});
  const std::string svg = atlas_svg(atlas, atlas.maps.front(), any_count);
  EXPECT_NE(svg.find(">3</text>"), std::string::npos);
  EXPECT_NE(svg.find(">5</text>"), std::string::npos);
  EXPECT_EQ(std::set<std::string>({"rgb(68,1,84)", "rgb(253,231,37)"}),
            std::set<std::string>({colours_of(svg)[0], colours_of(svg)[1]}));
}

TEST(Atlas, OneOtherCellAmongManyIsSeen) {
  std::vector<double> amounts(400, 7.0);
  amounts[13] = 9.0;
  const Atlas atlas = row_of(amounts);
  const std::string svg = atlas_svg(atlas, atlas.maps.front(), any_count);
  const std::vector<std::string> colours = colours_of(svg);
  EXPECT_NE(colours[13], colours[14]);
  EXPECT_NE(svg.find(">7</text>"), std::string::npos);
  EXPECT_NE(svg.find(">9</text>"), std::string::npos);
}

}  // namespace
}  // namespace tautline::bench
