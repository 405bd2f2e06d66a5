#include "bench/check/measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tautline::bench {

double worse(double a, double b) {
  return std::isnan(b) ? std::numeric_limits<double>::infinity() : std::max(a, b);
}

double largest_difference(const State& a, const State& b) {
  double largest = 0.0;
  for (const double apart :
       {a.position.x() - b.position.x(), a.position.y() - b.position.y(), a.angle - b.angle,
        a.velocity.x() - b.velocity.x(), a.velocity.y() - b.velocity.y(), a.spin - b.spin}) {
    largest = worse(largest, std::abs(apart));
  }
  return largest;
}

std::string_view not_finite(double number) {
  if (std::isnan(number)) {
    return "NaN";
  }
  return number > 0.0 ? "infinity" : "-infinity";
}

}  // namespace tautline::bench
