#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "tautline/detail/scalar.hpp"

namespace tautline {

/// A function of place between two ends, x = middle + half cos(phase), as the sum over j of a_j
/// cos(j phase): Chebyshev's polynomials. Its coefficients fall by a factor from one to the next
/// while the function is smooth well beyond the ends.
class CosineSum {
 public:
  static constexpr std::size_t terms = 32;
  using Values = std::array<double, terms>;

  /// The phases (k + 1/2) pi / terms of the values that make a sum.
  struct Nodes {
    Values cosine;
    Values sine;
  };
  [[nodiscard]] static double phase(std::size_t k) { return angle(2 * k + 1); }
  [[nodiscard]] static const Nodes& nodes() {
    static const Nodes result = [] {
      Nodes made{};
      for (std::size_t k = 0; k < terms; ++k) {
        made.cosine[k] = cos(angle(2 * k + 1));
        made.sine[k] = sin(angle(2 * k + 1));
      }
      return made;
    }();
    return result;
  }

  /// Zero everywhere.
  CosineSum() = default;

  /// Through `values` at the nodes.
  explicit CosineSum(const Values& values) {
    for (std::size_t k = 0; k < terms; ++k) {
      const Values& of_node = weights()[k];
      for (std::size_t j = 0; j < terms; ++j) {
        coefficients_[j] += of_node[j] * values[k];
      }
    }
    for (std::size_t j = 0; j < terms; ++j) {
      const double size = std::abs(coefficients_[j]);
      size_ += size;
      tail_ += j >= terms * 3 / 4 ? size : 0.0;
      most_curvature_ += static_cast<double>(j * j) * size;
    }
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    nearest_to_zero_ = std::max(*least, -*largest);
  }

  [[nodiscard]] double mean() const { return coefficients_[0]; }  // over the phase

  /// The integral over the phase from 0 to `phase` [rad].
  [[nodiscard]] double integral(double phase) const {
    double sum = coefficients_[0] * phase;
    for (std::size_t j = 1; j < terms; ++j) {
      const auto times = static_cast<double>(j);
      sum += coefficients_[j] * sin(times * phase) / times;
    }
    return sum;
  }

  /// The phase [rad] of the maximum near node `k`, whose value is not below those beside it, by
  /// Newton's method. At the ends of the phase the function is flat: a maximum there is found, too.
  [[nodiscard]] double phase_of_maximum(std::size_t k) const {
    double phase = CosineSum::phase(k);
    constexpr int enough = 16;  // most take four: a maximum that is flatter than a parabola is slow
    for (int iteration = 0; iteration < enough; ++iteration) {
      const auto [slope, bend] = slope_and_bend(phase);
      const double step = -slope / bend;
      constexpr double distance = std::numbers::pi / terms;
      if (!(bend < 0.0 && std::abs(phase + step - CosineSum::phase(k)) <= distance)) {
        return CosineSum::phase(k);
      }
      phase += step;
      constexpr double half_of_digits = 1e-8;  // [rad]
      if (std::abs(step) <= half_of_digits) {
        break;
      }
    }
    return phase;
  }

  /// True where the function has no zero between the ends, as far as the sum knows it: its values
  /// at the nodes have one sign, and it curves too little to reach zero between two of them, nor
  /// between the first or last and an end, where it is symmetric.
  [[nodiscard]] bool has_no_zero() const {
    constexpr double distance = std::numbers::pi / terms;
    return is_known() && nearest_to_zero_ > distance * distance / 8.0 * most_curvature_ + rest();
  }

  /// True where the coefficients fall so fast that those beyond `terms` are a millionth of the
  /// whole; the mean, which by its nature knows twice as many, is right to rounding then. False
  /// where a value is not finite.
  [[nodiscard]] bool is_known() const {
    constexpr double part = 1e-6;  // [-], of the last quarter in all
    return std::isfinite(size_) && tail_ <= part * size_;
  }

 private:
  static double angle(std::size_t halves) {
    return static_cast<double>(halves) * std::numbers::pi / (2 * terms);
  }

  /// Of each value in each coefficient.
  static const std::array<Values, terms>& weights() {
    static const auto result = [] {
      std::array<Values, terms> made{};
      for (std::size_t k = 0; k < terms; ++k) {
        for (std::size_t j = 0; j < terms; ++j) {
          made[k][j] = (j == 0 ? 1.0 : 2.0) / terms * cos(angle(j * (2 * k + 1)));
        }
      }
      return made;
    }();
    return result;
  }

  /// The first and the second derivative by the phase.
  [[nodiscard]] std::array<double, 2> slope_and_bend(double phase) const {
    double slope = 0.0;
    double bend = 0.0;
    const double twice = 2.0 * cos(phase);
    // sines and cosines of multiples of the phase, each from the two before
    double sine_before = 0.0;
    double sine = sin(phase);
    double cosine_before = 1.0;
    double cosine = twice / 2.0;
    for (std::size_t j = 1; j < terms; ++j) {
      const auto times = static_cast<double>(j);
      slope -= times * coefficients_[j] * sine;
      bend -= times * times * coefficients_[j] * cosine;
      sine_before = std::exchange(sine, twice * sine - sine_before);
      cosine_before = std::exchange(cosine, twice * cosine - cosine_before);
    }
    return {slope, bend};
  }

  /// A bound of what follows the last term, ten times over.
  [[nodiscard]] double rest() const { return 10.0 * tail_; }

  Values coefficients_{};
  double size_ = 0.0;             // the sum of their sizes
  double tail_ = 0.0;             // that of the last quarter
  double most_curvature_ = 0.0;   // a bound of the second derivative by the phase
  double nearest_to_zero_ = 0.0;  // of the values at the nodes; < 0 where they have both signs
};

}  // namespace tautline
