#include "bench/replay/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tautline::bench {
namespace {

std::vector<Eigen::Vector3d> poses(const GridColumn& x, const GridColumn& y,
                                   const GridColumn& angle) {
  const std::vector<double> columns[3] = {numbers(x), numbers(y), numbers(angle)};
  std::vector<Eigen::Vector3d> result;
  for (std::size_t index = 0; index < columns[0].size(); ++index) {
    result.emplace_back(columns[0][index], columns[1][index], columns[2][index]);
  }
  return result;
}

/// The last index with `times[index]` <= `time`; 0 before the first.
std::size_t index_at(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

}  // namespace

DrawnPath::DrawnPath(const Path& path)
    : time_(numbers(path.time)),
      knots_(poses(path.x, path.y, path.angle)),
      bends_(poses(path.x_bends, path.y_bends, path.angle_bends)),
      energy_time_(numbers(path.energy_time)),
      energy_(numbers(path.energy)) {
  for (const TautColumns& cable : path.cables) {
    taut_.push_back(numbers(cable.times));
    taut_grid_.push_back(cable.times.scale);
  }
}

Eigen::Vector3d DrawnPath::pose(double time) const {
  const std::size_t i = index_at(time_, time);
  if (i + 1 >= time_.size() || time <= time_[i]) {
    return knots_[i];
  }
  const double s = (time - time_[i]) / (time_[i + 1] - time_[i]);
  return knots_[i] + s * (knots_[i + 1] - knots_[i]) +
         3.0 * s * (1.0 - s) * ((1.0 - s) * bends_[2 * i] + s * bends_[2 * i + 1]);
}

double DrawnPath::energy(double time) const {
  const std::size_t i = index_at(energy_time_, time);
  if (i + 1 >= energy_time_.size() || time <= energy_time_[i]) {
    return energy_[i];
  }
  const double s = (time - energy_time_[i]) / (energy_time_[i + 1] - energy_time_[i]);
  return energy_[i] + s * (energy_[i + 1] - energy_[i]);
}

bool DrawnPath::is_taut(std::size_t cable, double time) const {
  const std::vector<double>& times = taut_[cable];
  for (std::size_t from = 0; from + 1 < times.size(); from += 2) {
    // the ends are on a grid
    if (time >= times[from] - taut_grid_[cable] && time <= times[from + 1] + taut_grid_[cable]) {
      return true;
    }
  }
  return false;
}

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
