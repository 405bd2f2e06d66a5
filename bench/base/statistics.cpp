#include "bench/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tautline::bench {

double quantile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  const double place = part * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  const double weight = place - static_cast<double>(below);
  return weight == 0.0 ? values[below] : (1.0 - weight) * values[below] + weight * values[above];
}

double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

double slope(const std::vector<double>& steps, const std::vector<double>& errors) {
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    mean_x += std::log10(steps[i]) / static_cast<double>(steps.size());
    mean_y += std::log10(errors[i]) / static_cast<double>(steps.size());
  }
  double xy = 0.0;
  double xx = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double x = std::log10(steps[i]) - mean_x;
    xy += x * (std::log10(errors[i]) - mean_y);
    xx += x * x;
  }
  return xy / xx;
}

}  // namespace tautline::bench
