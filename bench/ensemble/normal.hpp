#pragma once

#include <boost/math/distributions/normal.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace tautline::bench {

/// The quantile of the standard normal distribution at `part` in (0, 1).
template <class Wide>
[[nodiscard]] Wide normal_quantile_in(double part) {
  return boost::math::quantile(boost::math::normal_distribution<Wide>(0, 1), Wide(part));
}

/// The same, made of integers: the logarithms of the C library differ from one processor to the
/// next.
[[nodiscard]] inline double normal_quantile(double part) {
  using Wide = boost::multiprecision::cpp_bin_float_double_extended;
  return static_cast<double>(normal_quantile_in<Wide>(part));
}

}  // namespace tautline::bench
