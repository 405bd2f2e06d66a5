#include "bench/store/shard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bench/cases/catalogue.hpp"
#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

/// Every shipped case on three engines that are not here, one of them with six models.
SuiteOptions some_suite() {
  SuiteOptions options;
  const std::vector<std::string> all = {"*"};
  const std::vector<Case> cases = select_cases(all).cases;
  options.cases.assign(cases.begin(), cases.end());
  options.steps = {1e-2, 1e-3, 1e-4};
  for (const std::size_t models : {1U, 6U, 3U}) {
    RegisteredEngine engine;
    engine.name = "engine-" + std::to_string(models);
    engine.info = EngineInfo{};
    engine.info->name = engine.name;
    for (std::size_t model = 0; model < models; ++model) {
      engine.info->models.push_back({"model-" + std::to_string(model), "", {}});
    }
    options.engines.push_back(engine);
  }
  return options;
}

double whole_cost(const SuiteOptions& options) {
  const std::vector<PlannedRun> runs = plan(options);
  return std::accumulate(runs.begin(), runs.end(), 0.0, [&](double sum, const PlannedRun& run) {
    return sum + expected_cost(options, run);
  });
}

TEST(Plan, GivesEachCaseTheModelsThatHaveItsCables) {
  SuiteOptions options;
  const SpatialSystem rigid = shipped_spatial_systems().front().system;
  SpatialSystem stretches = rigid;
  stretches.cables.front().elasticity = Elasticity{.stiffness = {1e3}};
  options.cases = {shipped_cases().front(), rigid, stretches};
  options.steps = {1e-2};
  RegisteredEngine engine;
  engine.info = EngineInfo{};
  const std::vector<std::pair<std::string, Cables>> models = {
      {"row", Cables::inextensible}, {"spring", Cables::elastic}, {"plain", Cables::any}};
  for (const auto& [name, cables] : models) {
    Model& model = engine.info->models.emplace_back();
    model.name = name;
    model.in_space.emplace();
    model.cables = cables;
  }
  options.engines = {engine};
  std::vector<std::string> planned(options.cases.size());
  for (const PlannedRun& run : plan(options)) {
    planned[run.the_case] += run.model.name + " ";
  }
  EXPECT_EQ(planned, (std::vector<std::string>{"row plain ", "row plain ", "spring plain "}));
}

TEST(Shard, IsTwoWholeNumbersTheFirstAtMostTheSecond) {
  EXPECT_EQ(shard_from("3/16"), (Shard{3, 16}));
  EXPECT_EQ(shard_from("1/1"), (Shard{1, 1}));
  for (const char* wrong :
       {"0/3", "4/3", "a/b", "1/0", "", "/", "1", "1/", "/3", "1/3/5", "-1/3", "+1/3", " 1/3",
        "1/3 ", "1.0/3", "0x1/3", "1/99999999999999999999999", "1/10001"}) {
    EXPECT_EQ(shard_from(wrong), std::nullopt) << wrong;
  }
}

TEST(Shard, EveryRunIsInExactlyOne) {
  SuiteOptions options = some_suite();
  options.engines.resize(1);
  const std::size_t runs = plan(options).size();
  for (const std::size_t of : {std::size_t{1}, std::size_t{2}, std::size_t{16}, runs + 5}) {
    std::multiset<std::size_t> places;
    for (std::size_t number = 1; number <= of; ++number) {
      options.shard = {number, of};
      const auto mine = places_in_shard(options);
      EXPECT_TRUE(std::is_sorted(mine.begin(), mine.end()));
      places.insert(mine.begin(), mine.end());
    }
    EXPECT_EQ(places.size(), runs) << of;
    EXPECT_EQ(std::set<std::size_t>(places.begin(), places.end()).size(), runs) << of;
  }
}

TEST(Shard, AllAreExpectedToCostTheSameButForOneRun) {
  const SuiteOptions options = some_suite();
  const std::vector<PlannedRun> runs = plan(options);
  for (const std::size_t of : {2U, 3U, 16U}) {
    const std::vector<std::size_t> numbers = shard_numbers(options, of);
    std::vector<double> cost(of, 0.0);
    double dearest = 0.0;
    for (std::size_t index = 0; index < runs.size(); ++index) {
      const double one = expected_cost(options, runs[index]);
      cost[numbers[index] - 1] += one;
      dearest = std::max(dearest, one);
    }
    const auto [least, most] = std::minmax_element(cost.begin(), cost.end());
    EXPECT_LE(*most - *least, dearest) << of;
    EXPECT_LE(*most, 1.05 * whole_cost(options) / static_cast<double>(of)) << of;
  }
}

// An engine may cost ten times another: no shard may get all of it.
TEST(Shard, EachHasAboutAsManyDearRunsOfEveryModel) {
  const SuiteOptions options = some_suite();
  const std::vector<PlannedRun> runs = plan(options);
  constexpr std::size_t of = 3;  // which divides the number of models of both
  const std::vector<std::size_t> numbers = shard_numbers(options, of);
  std::map<std::pair<std::size_t, std::string>, std::array<int, of>> counts;
  for (std::size_t index = 0; index < runs.size(); ++index) {
    if (runs[index].step == 1e-4) {
      ++counts[{runs[index].engine, runs[index].model.name}][numbers[index] - 1];
    }
  }
  for (const auto& [model, of_shard] : counts) {
    const auto [least, most] = std::minmax_element(of_shard.begin(), of_shard.end());
    EXPECT_LE(*most - *least, 6) << model.first << " " << model.second;
    EXPECT_GE(*least, 5) << model.first << " " << model.second;
  }
}

}  // namespace
}  // namespace tautline::bench
