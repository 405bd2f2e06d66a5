#include "bench/base/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tautline::bench {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

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
