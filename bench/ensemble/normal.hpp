#pragma once

#include <boost/math/distributions/normal.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace tautline::bench {

/// The quantile of the standard normal distribution at `part` in (0, 1).
template <class Wide>
[[nodiscard]] Wide normal_quantile_in(double part) {
  return boost::math::quantile(boost::math::normal_distribution<Wide>(0, 1), Wide(part));
}

/// True if the double next to `value` may be another after an error of `margin` units in the last
/// of 64 bits.
[[nodiscard]] inline bool in_doubt(long double value, std::uint64_t margin) {
  constexpr std::uint64_t below_double = (1U << 11U) - 1;  // 64 bits less the 53 of a double
  constexpr std::uint64_t between = 1U << 10U;             // two doubles
  int exponent = 0;
  const long double mantissa = std::ldexp(std::frexp(std::fabs(value), &exponent), 64);
  const std::uint64_t rest = static_cast<std::uint64_t>(mantissa) & below_double;
  return rest + margin >= between && rest <= between + margin;
}

/// The same, by integers of 64 bits: the logarithms of the C library differ from one processor to
/// the next. Integers take 20 microseconds. Where the processor has numbers of 64 bits, they take a
/// fiftieth of that and are as exact, but not equal to the last bit. So integers decide only where
/// the two could round to different doubles: within `margin` units of the last bit. 2048 is always.
[[nodiscard]] inline double normal_quantile(double part, std::uint64_t margin = 64) {
  if constexpr (std::numeric_limits<long double>::digits == 64) {
    const auto fast = normal_quantile_in<long double>(part);
    if (!in_doubt(fast, margin)) {
      return static_cast<double>(fast);
    }
  }
  using Integers = boost::multiprecision::cpp_bin_float_double_extended;
  return static_cast<double>(normal_quantile_in<Integers>(part));
}

}  // namespace tautline::bench
