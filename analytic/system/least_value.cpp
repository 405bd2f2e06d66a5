#include "system/least_value.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tautline {
namespace {

/// Halves an interval until a bound of the slope tells the sign in each part.
class ZeroSearch {
 public:
  ZeroSearch(const Function<1>& function, double begin, double end)
      : function_(function), narrowest_((end - begin) * 1e-12) {}

  [[nodiscard]] std::optional<ValueAtTime> run(double begin, double end) {
    const double middle = begin + (end - begin) / 2.0;
    const double value = function_.at(middle)[0];
    if (!(value > 0.0)) {
      return ValueAtTime{middle, value};
    }
    if (value > fall(begin, end)) {
      return std::nullopt;
    }
    if (end - begin <= narrowest_ || asked_ == most_asked) {
      return std::nullopt;  // it comes within rounding of zero: only a run can tell
    }
    ++asked_;
    const auto found = run(begin, middle);
    return found ? found : run(middle, end);
  }

 private:
  static constexpr int most_asked = 100'000;

  /// How far it may fall at most from the middle to elsewhere in the interval, which holds no knot
  /// but at its ends.
  [[nodiscard]] double fall(double begin, double end) const {
    const double half = (end - begin) / 2.0;
    double sum = 0.0;
    if (const auto* piece = function_.piece(begin)) {
      const double since = std::max(std::abs(begin - piece->from), std::abs(end - piece->from));
      double power = 1.0;
      for (std::size_t k = 1; k < piece->coefficients.size(); ++k, power *= since) {
        sum += half * static_cast<double>(k) * std::abs(piece->coefficients[k][0]) * power;
      }
    }
    for (const auto& wave : function_.waves) {
      sum += std::abs(wave.amplitude[0]) * std::min(2.0, half * wave.frequency);
    }
    return sum;
  }

  const Function<1>& function_;
  double narrowest_;  // [s]
  int asked_ = 0;
};

}  // namespace

std::optional<ValueAtTime> not_above_zero(const Function<1>& function, double begin, double end) {
  std::vector<double> stops = {begin, end};
  for (const auto& piece : function.pieces) {
    if (piece.from > begin && piece.from < end) {
      stops.push_back(piece.from);
    }
  }
  std::sort(stops.begin(), stops.end());
  for (const double stop : stops) {
    if (const double value = function.at(stop)[0]; !(value > 0.0)) {
      return ValueAtTime{stop, value};
    }
  }
  for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
    ZeroSearch search(function, stops[i], stops[i + 1]);
    if (const auto found = search.run(stops[i], stops[i + 1])) {
      return found;
    }
  }
  return std::nullopt;
}

}  // namespace tautline
