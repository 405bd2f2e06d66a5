#include "bench/report/motion/column.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tautline::bench {

GridColumn on_grid(const std::vector<double>& numbers, double grid) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  GridColumn column;
  column.scale = grid;
  double place = 0.0;  // [grid widths] from the start, whole
  for (const double number : numbers) {
    if (column.steps.empty()) {
      column.start = number;
    }
    const double to = std::round((number - column.start) / grid);
    const double step = std::clamp(to - place, -most, most);
    column.steps.push_back(static_cast<std::int32_t>(step));
    place += step;
  }
  return column;
}

std::vector<double> numbers(const GridColumn& column) {
  std::vector<double> result;
  result.reserve(column.steps.size());
  std::int64_t place = 0;
  for (const std::int32_t step : column.steps) {
    place += step;
    result.push_back(column.start + column.scale * static_cast<double>(place));
  }
  return result;
}

}  // namespace tautline::bench
