// Systems in which one cable hangs side by side with another, kept because a solver once hung in
// them, or chattered at rounding without end.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <vector>

#include "tautline/case_file.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

std::vector<std::filesystem::path> kept_systems() {
  std::vector<std::filesystem::path> result;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(TAUTLINE_TEST_DATA) / "redundant")) {
    result.push_back(entry.path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

class RedundantCables : public ::testing::TestWithParam<std::filesystem::path> {};

TEST_P(RedundantCables, ComeToTheirEndInTimeUnderEveryLaw) {
  const CaseReading reading = read_case(GetParam());
  ASSERT_TRUE(reading.the_case.has_value());
  for (const ImpactLaw law : impact_laws) {
    SolveOptions options;
    options.law = law;
    options.max_events = 20'000;
    const auto begin = std::chrono::steady_clock::now();
    const Solution solution = solve(*reading.the_case, options);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    EXPECT_TRUE(solution.ending() == Ending::reached_duration || solution.ending() == Ending::rest)
        << to_string(law) << ": " << to_string(solution.ending());
    EXPECT_EQ(solution.end_time(), reading.the_case->duration);
    EXPECT_LT(taken.count(), 5.0) << to_string(law);  // [s]; some hundredths, or a hang
    double overstretch = 0.0;
    for (const Arc& arc : solution.arcs()) {
      for (const Cable& cable : reading.the_case->cables) {
        overstretch = std::max(overstretch, -gap(cable, arc.initial) / cable.length);
      }
    }
    EXPECT_LE(overstretch, 1e-12) << to_string(law);
  }
}

INSTANTIATE_TEST_SUITE_P(Kept, RedundantCables, ::testing::ValuesIn(kept_systems()),
                         [](const auto& param) { return param.param.stem().string(); });

}  // namespace
}  // namespace tautline::bench
