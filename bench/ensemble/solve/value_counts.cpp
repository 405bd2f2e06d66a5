#include "bench/ensemble/solve/value_counts.hpp"

#include <cmath>

namespace tautline::bench {
namespace {

/// The nearest number of `counted_digits` binary digits.
double rounded(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);  // 0.5 to 1
  return std::ldexp(std::nearbyint(std::ldexp(fraction, counted_digits)),
                    exponent - counted_digits);
}

}  // namespace

void ValueCounts::add(std::optional<double> value) {
  if (!value) {
    ++without_;
    return;
  }
  ++values_[rounded(*value)];
  ++count_;
}

}  // namespace tautline::bench
