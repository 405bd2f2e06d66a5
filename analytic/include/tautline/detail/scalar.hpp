#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace tautline {

// The solver is generic in its scalar `Real`: double, or a number of more digits that Eigen and the
// functions of <cmath> (found by argument-dependent lookup) know, such as Boost.Multiprecision's.
// The names without a template argument (State, Case, Solution, ...) are the ones for double.

// What a call abs(x) in this namespace finds for a double; for other scalars their own is found.
using std::abs;
using std::copysign;
using std::isfinite;
using std::isnan;
using std::max;
using std::min;
using std::round;
using std::sqrt;

// Those above round as IEEE 754 says, or not at all. The other functions of <cmath> differ in their
// last digits from one library to the next, and with one library from one processor to the next.
// Here they are made of arithmetic alone for a double: the same input gives the same bits
// everywhere. (elementary.cpp)

/// The sine of an `angle` [rad] of any size, to three roundings; NaN unless it is finite.
[[nodiscard]] double sin(double angle);
/// Its cosine likewise.
[[nodiscard]] double cos(double angle);
/// The angle [rad] of the vector (x, y), -pi to pi, to four roundings; as std::atan2 where both are
/// zero. Requires finite numbers.
[[nodiscard]] double atan2(double y, double x);
/// e to the power of `value`, to two roundings.
[[nodiscard]] double exp(double value);
/// The logarithm of `value` > 0 to the base e, to two roundings of 1 or of itself.
[[nodiscard]] double log(double value);
/// The root of `value`, >= 0, of a `degree` [-] > 0, to 1e-9 of it; infinity of infinity.
[[nodiscard]] double root(double value, double degree);

/// That root to the digits of `Real`.
template <class Real>
[[nodiscard]] Real root(const Real& value, double degree) {
  return pow(value, Real(1) / degree);
}

/// Half the circumference of the unit circle [rad].
template <class Real>
[[nodiscard]] Real pi() {
  if constexpr (std::is_same_v<Real, double>) {
    return std::numbers::pi;
  } else {
    return 4 * atan(Real(1));
  }
}

/// The type of the number in `Real`: itself, where it is not several side by side.
template <class Real>
struct NumberOf {
  using type = Real;  ///< one number of it
};

/// The limits of that type.
template <class Real>
using LimitsOf = std::numeric_limits<typename NumberOf<Real>::type>;

/// The spacing of the numbers at 1 [-].
template <class Real>
[[nodiscard]] Real epsilon() {
  return LimitsOf<Real>::epsilon();
}

/// Of any number type that has one.
template <class Real>
[[nodiscard]] Real infinity() {
  return LimitsOf<Real>::infinity();
}

/// Of any number type that has one.
template <class Real>
[[nodiscard]] Real not_a_number() {
  return LimitsOf<Real>::quiet_NaN();
}

// What is done in every flight is written once for one number and for several side by side, lanes,
// as a processor computes them at once. A comparison of lanes is a mask, so that code for both
// chooses by `select` and asks `any`. For one number a mask is a bool. Lanes are of a type of
// their own, such as xsimd's, which brings its own select, any, sqrt and abs.

/// `yes` where the mask is set, else `no`.
template <class V>
[[nodiscard]] V select(bool mask, const V& yes, const V& no) {
  return mask ? yes : no;
}

/// True where the mask is set in a lane.
[[nodiscard]] constexpr bool any(bool mask) { return mask; }

/// The smaller of both in each lane, `a` where one is NaN, as std::min. Processors differ there.
template <class V>
[[nodiscard]] V least(const V& a, const V& b) {
  return select(b < a, b, a);
}

/// The larger of both in each lane, `a` where one is NaN, as std::max.
template <class V>
[[nodiscard]] V most(const V& a, const V& b) {
  return select(a < b, b, a);
}

/// Where `v` is neither infinite nor NaN.
template <class V>
[[nodiscard]] auto is_finite(const V& v) {
  return V(abs(v)) < infinity<V>();
}

}  // namespace tautline
