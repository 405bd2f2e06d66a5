#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tautline {

// The solver is generic in its scalar `Real`: double, or a number of more digits that Eigen and the
// functions of <cmath> (found by argument-dependent lookup) know, such as Boost.Multiprecision's.
// The names without a template argument (State, Case, Solution, ...) are the ones for double.

// What a call abs(x) in this namespace finds for a double; for other scalars their own is found.
using std::abs;
using std::atan;
using std::copysign;
using std::cos;
using std::isfinite;
using std::isnan;
using std::max;
using std::min;
using std::pow;
using std::sin;
using std::sqrt;

/// The spacing of the numbers at 1 [-].
template <class Real>
[[nodiscard]] Real epsilon() {
  return std::numeric_limits<Real>::epsilon();
}

/// Of any number type that has one.
template <class Real>
[[nodiscard]] Real infinity() {
  return std::numeric_limits<Real>::infinity();
}

/// Of any number type that has one.
template <class Real>
[[nodiscard]] Real not_a_number() {
  return std::numeric_limits<Real>::quiet_NaN();
}

}  // namespace tautline
