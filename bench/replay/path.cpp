#include "bench/replay/path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tautline::bench {
namespace {

template <int N>
std::vector<Eigen::Matrix<double, N, 1>> rows(const ForEach<const GridColumn*, N>& columns) {
  std::vector<Eigen::Matrix<double, N, 1>> result;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::vector<double> column = numbers(*columns[k]);
    result.resize(column.size());
    for (std::size_t index = 0; index < column.size(); ++index) {
      result[index][static_cast<Eigen::Index>(k)] = column[index];
    }
  }
  return result;
}

template <std::size_t N>
std::array<const GridColumn*, N> addresses(const std::array<GridColumn, N>& columns) {
  std::array<const GridColumn*, N> result{};
  std::transform(columns.begin(), columns.end(), result.begin(), [](const auto& c) { return &c; });
  return result;
}

/// The last index with `times[index]` <= `time`; 0 before the first.
std::size_t index_at(const std::vector<double>& times, double time) {
  const auto after = std::upper_bound(times.begin(), times.end(), time);
  return after == times.begin() ? 0 : static_cast<std::size_t>(after - times.begin()) - 1;
}

}  // namespace

template <int N>
DrawnCurve<N>::DrawnCurve(const GridColumn& time, const ForEach<const GridColumn*, N>& places,
                          const ForEach<const GridColumn*, N>& bends)
    : time_(numbers(time)), knots_(rows<N>(places)), bends_(rows<N>(bends)) {}

template <int N>
typename DrawnCurve<N>::Numbers DrawnCurve<N>::at(double time) const {
  const std::size_t i = index_at(time_, time);
  if (i + 1 >= time_.size() || time <= time_[i]) {
    return knots_[i];
  }
  const double s = (time - time_[i]) / (time_[i + 1] - time_[i]);
  return knots_[i] + s * (knots_[i + 1] - knots_[i]) +
         3.0 * s * (1.0 - s) * ((1.0 - s) * bends_[2 * i] + s * bends_[2 * i + 1]);
}

template class DrawnCurve<3>;
template class DrawnCurve<7>;

DrawnPath::DrawnPath(const Path& path)
    : plane_(path.time, {&path.x, &path.y, &path.angle},
             {&path.x_bends, &path.y_bends, &path.angle_bends}),
      energy_time_(numbers(path.energy_time)),
      energy_(numbers(path.energy)) {
  for (const TautColumns& cable : path.cables) {
    taut_.push_back(numbers(cable.times));
    taut_grid_.push_back(cable.times.scale);
  }
  for (const BodyPath& body : path.bodies.value_or(std::vector<BodyPath>())) {
    bodies_.emplace_back(body.time, addresses(body.places), addresses(body.bends));
  }
}

SpatialState DrawnPath::pose(std::size_t body, double time) const {
  const auto at = bodies_.at(body).at(time);
  SpatialState state;
  state.position = at.head<3>();
  state.orientation = at.tail<4>().normalized();
  return state;
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
