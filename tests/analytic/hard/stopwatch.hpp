#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {

/// Processor time since `begin` [s].
inline double seconds_since(std::clock_t begin) {
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// How much slower than an idle machine and an optimised build this is, here and now [-], at least
/// 1: by the standard case to t = 20, which takes 0.28 ms there. Sanitizers and other programs slow
/// both.
inline double slowness() {
  constexpr int times = 20;
  constexpr double idle = 0.28e-3;  // [s]
  const Case standard = shipped_cases().front();
  const std::clock_t begin = std::clock();
  for (int time = 0; time < times; ++time) {
    EXPECT_EQ(solve(standard).ending(), Ending::reached_duration);
  }
  return std::max(1.0, seconds_since(begin) / times / idle);
}

}  // namespace tautline::test
