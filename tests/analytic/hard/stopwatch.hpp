#pragma once

#include <gtest/gtest.h>

#include <ctime>

#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {

/// Processor time since `begin` [s].
inline double seconds_since(std::clock_t begin) {
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Processor time of the standard case to t = 20 [s], measured here and now: what the times of
/// other systems are divided by. A slow machine, sanitizers and other programs slow both.
inline double time_of_standard_case() {
  constexpr int times = 20;
  const Case standard = shipped_cases().front();
  const std::clock_t begin = std::clock();
  for (int time = 0; time < times; ++time) {
    EXPECT_EQ(solve(standard).ending(), Ending::reached_duration);
  }
  return seconds_since(begin) / times;
}

}  // namespace tautline::test
