#pragma once

#include "tautline/solution.hpp"

namespace tautline::bench {

/// The largest tension of one cable along `solution` [N], also of a swing that it tells ahead; 0 if
/// no cable is ever taut. Impulses of impacts are no tensions. Redundant cables share their load by
/// the least sum of squares, as Solution::tensions says.
[[nodiscard]] double largest_tension(const Solution& solution);

}  // namespace tautline::bench
