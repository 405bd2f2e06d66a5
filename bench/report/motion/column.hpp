#pragma once

#include <cstdint>
#include <vector>

namespace tautline::bench {

/// Numbers on a grid, each a whole number of grid widths from the one before: a few bytes each in
/// JSON, and the same to the last bit wherever they are read.
struct GridColumn {
  double start = 0.0;               // the first number
  double scale = 1.0;               // width of the grid, > 0
  std::vector<std::int32_t> steps;  // one for each number; the first is 0
};

/// `numbers`, each moved by at most half a `grid`; none may be further from the one before than
/// 2^31 grid widths.
[[nodiscard]] GridColumn on_grid(const std::vector<double>& numbers, double grid);

/// The numbers of `column`.
[[nodiscard]] std::vector<double> numbers(const GridColumn& column);

}  // namespace tautline::bench
