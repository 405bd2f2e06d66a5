#include "bench/ensemble/output/kolmogorov.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <limits>

namespace tautline::bench {
namespace {

/// Below this the series has too many terms, and its sum is 1 to 12 digits.
constexpr double least_argument = 0.2;

/// P(K > x) = 2 sum (-1)^(k-1) exp(-2 k^2 x^2) (Kolmogorov 1933).
double kolmogorov_tail(double x) {
  if (x < least_argument) {
    return 1.0;
  }
  double sum = 0.0;
  double sign = 2.0;
  for (int k = 1; k < 100; ++k) {
    const double term = std::exp(-2.0 * k * k * x * x);
    sum += sign * term;
    sign = -sign;
    if (term < std::numeric_limits<double>::epsilon() * sum) {
      break;
    }
  }
  return std::clamp(sum, 0.0, 1.0);
}

/// The distance of two samples of these sizes shrinks as its inverse (Smirnov 1939).
double scale_of(std::size_t one, std::size_t other) {
  const auto n = static_cast<double>(one);
  const auto m = static_cast<double>(other);
  return std::sqrt(n * m / (n + m));
}

}  // namespace

double kolmogorov_distance(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0.0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < one.size() && j < other.size()) {
    const double value = std::min(one[i], other[j]);
    while (i < one.size() && one[i] <= value) {
      ++i;
    }
    while (j < other.size() && other[j] <= value) {
      ++j;
    }
    largest =
        std::max(largest, std::abs(static_cast<double>(i) / static_cast<double>(one.size()) -
                                   static_cast<double>(j) / static_cast<double>(other.size())));
  }
  return largest;
}

double kolmogorov_probability(double distance, std::size_t one, std::size_t other) {
  return kolmogorov_tail(distance * scale_of(one, other));
}

double critical_distance(double probability, std::size_t one, std::size_t other) {
  constexpr double most = 10.0;  // e^-200: less likely than any number that is asked for
  const boost::math::tools::eps_tolerance<double> digits(40);
  std::uintmax_t rounds = 200;
  const auto [low, high] =
      boost::math::tools::bisect([&](double x) { return kolmogorov_tail(x) - probability; },
                                 least_argument, most, digits, rounds);
  return std::min(1.0, 0.5 * (low + high) / scale_of(one, other));
}

double visible_shift(const std::vector<double>& sample, double distance) {
  const double share = distance * static_cast<double>(sample.size());
  const auto span = static_cast<std::size_t>(std::ceil(share));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first + span < sample.size(); ++first) {
    least = std::min(least, sample[first + span] - sample[first]);
  }
  return least;
}

}  // namespace tautline::bench
