#include "bench/ensemble/spec.hpp"

namespace tautline::bench {

std::vector<std::size_t> grid_axes(const EnsembleSpec& spec) {
  std::vector<std::size_t> axes;
  for (std::size_t place = 0; place < spec.varied.size(); ++place) {
    if (spec.varied[place].distribution.kind == Distribution::Kind::grid) {
      axes.push_back(place);
    }
  }
  return axes;
}

std::size_t grid_points(const EnsembleSpec& spec) {
  std::size_t points = 1;
  for (const std::size_t axis : grid_axes(spec)) {
    points *= spec.varied[axis].distribution.numbers.size();
    if (points > most_draws) {  // refused: before it overflows
      break;
    }
  }
  return points;
}

std::size_t draw_count(const EnsembleSpec& spec) { return spec.count * grid_points(spec); }

}  // namespace tautline::bench
