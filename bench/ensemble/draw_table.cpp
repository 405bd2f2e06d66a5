#include "bench/ensemble/draw_table.hpp"

#include <cmath>
#include <limits>

namespace tautline::bench {
namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// The nearest number of `counted_digits` binary digits.
double in_counted_digits(double value) {
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
  ++values_[in_counted_digits(*value)];
  ++count_;
}

DrawTable::DrawTable(std::size_t statistics, std::size_t draws, std::size_t held)
    : columns_(statistics, std::vector<double>(held, no_value)),
      solved_(held, false),
      counts_(held < draws ? statistics : 0) {}

void DrawTable::put(const DrawResult& result) {
  ++ended_;
  if (!result.problem.empty()) {
    if (problems_ == 0 || result.draw < first_with_problem_) {
      first_with_problem_ = result.draw;
      first_problem_ = result.problem;
    }
    ++problems_;
    return;
  }
  for (std::size_t statistic = 0; statistic < counts_.size(); ++statistic) {
    counts_[statistic].add(result.values[statistic]);
  }
  if (result.draw >= size()) {
    return;
  }
  solved_[result.draw] = true;
  for (std::size_t statistic = 0; statistic < columns_.size(); ++statistic) {
    columns_[statistic][result.draw] = result.values[statistic].value_or(no_value);
  }
}

std::optional<double> DrawTable::value(std::size_t draw, std::size_t statistic) const {
  const double value = columns_[statistic][draw];
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

}  // namespace tautline::bench
