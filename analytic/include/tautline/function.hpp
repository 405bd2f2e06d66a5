#pragma once

#include <Eigen/Core>
#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "tautline/detail/scalar.hpp"

namespace tautline {

/// A polynomial from one knot to the next.
template <class Real, int N>
struct BasicPiece {
  Real from;  // [s], the knot where it starts
  /// In rising order, of the time since `from`; coefficient k in the function's unit / s^k.
  std::vector<Eigen::Matrix<Real, N, 1>> coefficients;

  /// True where all of it is equal.
  bool operator==(const BasicPiece&) const = default;
};

/// amplitude cos(frequency t + phase).
template <class Real, int N>
struct BasicWave {
  Eigen::Matrix<Real, N, 1> amplitude;  // in the function's unit
  Real frequency;                       // [rad/s], >= 0
  Real phase = Real(0);                 // [rad], at time 0

  /// True where it changes over time.
  [[nodiscard]] bool varies() const { return frequency > 0 && amplitude.squaredNorm() > 0; }
  /// True where all of it is equal.
  bool operator==(const BasicWave&) const = default;
};

/// N numbers that are given over time: a sum of waves, and of polynomials from knot to knot. Empty:
/// zero at all times.
template <class Real, int N>
struct BasicFunction {
  using Value = Eigen::Matrix<Real, N, 1>;  // at a time
  using Piece = BasicPiece<Real, N>;        // between knots
  using Wave = BasicWave<Real, N>;          // at all times

  /// In rising time. The last one lasts for ever; before the first one its value at `from` holds.
  std::vector<Piece> pieces = {};
  std::vector<Wave> waves = {};  // at all times

  /// True where all of it is equal.
  bool operator==(const BasicFunction&) const = default;

  /// `value` at all times.
  [[nodiscard]] static BasicFunction constant(const Value& value) {
    return {{{Real(0), {value}}}, {}};
  }
  /// One number, `value`, at all times.
  [[nodiscard]] static BasicFunction constant(const Real& value) requires(N == 1) {
    return constant(Value(value));
  }

  /// `values` at these rising `times` [s], linear between them, constant before and after.
  [[nodiscard]] static BasicFunction linear(const std::vector<Real>& times,
                                            const std::vector<Value>& values) {
    assert(!times.empty() && times.size() == values.size() && "a value for each time");
    BasicFunction result;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const Value slope = (values[i + 1] - values[i]) / Real(times[i + 1] - times[i]);
      result.pieces.push_back({times[i], {values[i], slope}});
    }
    result.pieces.push_back({times.back(), {values.back()}});
    return result;
  }

  /// A cubic spline through them, constant before and after, whose second derivative is continuous
  /// between the first time and the last, and whose rate is zero at both.
  [[nodiscard]] static BasicFunction spline(const std::vector<Real>& times,
                                            const std::vector<Value>& values) {
    assert(!times.empty() && times.size() == values.size() && "a value for each time");
    const std::vector<Value> rates = spline_rates(times, values);
    BasicFunction result;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      const Real step = times[i + 1] - times[i];
      const Value slope = (values[i + 1] - values[i]) / step;
      const Value square = (3 * slope - 2 * rates[i] - rates[i + 1]) / step;
      const Value cube = (rates[i] + rates[i + 1] - 2 * slope) / Real(step * step);
      result.pieces.push_back({times[i], {values[i], rates[i], square, cube}});
    }
    result.pieces.push_back({times.back(), {values.back()}});
    return result;
  }

  /// True where it is zero at all times because nothing is given.
  [[nodiscard]] bool empty() const { return pieces.empty() && waves.empty(); }

  /// True where it is the same at all times.
  [[nodiscard]] bool is_constant() const {
    return !has_varying_waves() && pieces.size() < 2 &&
           (pieces.empty() || pieces.front().coefficients.size() < 2);
  }

  /// The piece that holds at `time` [s] and right after it; none before the first.
  [[nodiscard]] const Piece* piece(const Real& time) const {
    const Piece* result = nullptr;
    for (const Piece& one : pieces) {
      if (one.from <= time) {
        result = &one;
      }
    }
    return result;
  }

  /// Its first Taylor coefficients at `time` [s], from there on; as many as `result` has.
  void expand(const Real& time, std::span<Value> result) const {
    for (Value& one : result) {
      one.setZero();
    }
    expand_piece(time, result);
    for (const Wave& wave : waves) {
      const Real angle = wave.frequency * time + wave.phase;
      const Real cosine = cos(angle);
      const Real sine = sin(angle);
      Real scale(1);  // frequency^k / k!
      for (std::size_t k = 0; k < result.size(); ++k) {
        const Real turn = k % 2 == 0 ? cosine : Real(-sine);
        result[k] += Real((k % 4 < 2 ? turn : Real(-turn)) * scale) * wave.amplitude;
        scale *= wave.frequency / static_cast<double>(k + 1);
      }
    }
  }

  /// Its value at `time` [s]; at a knot, after it.
  [[nodiscard]] Value at(const Real& time) const {
    Value result;
    expand(time, std::span(&result, 1));
    return result;
  }

  /// The first knot after `time` [s]; infinite if there is none.
  [[nodiscard]] Real next_knot(const Real& time) const {
    for (const Piece& one : pieces) {
      if (one.from > time && !has_one_value()) {
        return one.from;
      }
    }
    return infinity<Real>();
  }

  /// True where it does not change from `time` [s] on.
  [[nodiscard]] bool is_constant_from(const Real& time) const {
    const Piece* last = piece(time);
    return is_constant() || (!has_varying_waves() && !pieces.empty() && last == &pieces.back() &&
                             last->coefficients.size() < 2);
  }

 private:
  [[nodiscard]] bool has_varying_waves() const {
    for (const Wave& wave : waves) {
      if (wave.varies()) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] bool has_one_value() const {
    return pieces.size() == 1 && pieces.front().coefficients.size() < 2;
  }

  void expand_piece(const Real& time, std::span<Value> result) const {
    if (pieces.empty() || result.empty()) {
      return;
    }
    const Piece* now = piece(time);
    if (!now || now->coefficients.size() < 2) {
      const Piece& constant = now ? *now : pieces.front();
      result[0] += constant.coefficients.empty() ? Value(Value::Zero()) : constant.coefficients[0];
      return;
    }
    std::vector<Value> shifted = now->coefficients;
    const Real since = time - now->from;
    for (std::size_t i = 0; i < shifted.size(); ++i) {
      for (std::size_t k = shifted.size() - 1; k-- > i;) {
        shifted[k] += since * shifted[k + 1];
      }
    }
    for (std::size_t k = 0; k < shifted.size() && k < result.size(); ++k) {
      result[k] += shifted[k];
    }
  }

  /// The rates at `times` of the spline: zero at both ends, a continuous second derivative between.
  static std::vector<Value> spline_rates(const std::vector<Real>& times,
                                         const std::vector<Value>& values) {
    const std::size_t count = times.size();
    std::vector<Value> rates(count, Value(Value::Zero()));
    std::vector<Real> upper(count, Real(0));  // of the eliminated rows of a tridiagonal system
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const Real before = Real(1) / Real(times[i] - times[i - 1]);
      const Real after = Real(1) / Real(times[i + 1] - times[i]);
      const Real diagonal = 2 * (before + after) - before * upper[i - 1];
      const Value right = 3 * (Real(before * before) * (values[i] - values[i - 1]) +
                               Real(after * after) * (values[i + 1] - values[i]));
      upper[i] = after / diagonal;
      rates[i] = (right - before * rates[i - 1]) / diagonal;
    }
    for (std::size_t i = count; i-- > 1;) {
      rates[i - 1] -= upper[i - 1] * rates[i];
    }
    return rates;
  }
};
/// In double.
template <int N>
using Function = BasicFunction<double, N>;

}  // namespace tautline
