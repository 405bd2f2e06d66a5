// Normal numbers with the bits of `tautline ensemble`, for the package of Python.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "bench/ensemble/normal.hpp"

namespace {

/// True if the double next to `value` may be another after an error of `margin` units in the last
/// of 64 bits.
bool in_doubt(long double value, std::uint64_t margin) {
  constexpr std::uint64_t below_double = (1U << 11U) - 1;  // 64 bits less the 53 of a double
  constexpr std::uint64_t between = 1U << 10U;             // two doubles
  int exponent = 0;
  const long double mantissa = std::ldexp(std::frexp(std::fabs(value), &exponent), 64);
  const std::uint64_t rest = static_cast<std::uint64_t>(mantissa) & below_double;
  return rest + margin >= between && rest <= between + margin;
}

}  // namespace

/// The quantiles of the standard normal distribution at `parts`, each in (0, 1). The program
/// computes them with integers of 64 bits, 20 microseconds each. The processor's numbers of 64 bits
/// take a fiftieth of that and are as exact, but not equal to the last bit. So integers decide only
/// where the two could round to different doubles: within `margin` units of the last bit. 2048 is
/// always.
extern "C" __attribute__((visibility("default"))) void tautline_normal_quantiles(
    const double* parts, std::size_t count, std::uint64_t margin, double* to) {
  for (std::size_t index = 0; index < count; ++index) {
    const auto fast = tautline::bench::normal_quantile_in<long double>(parts[index]);
    to[index] = in_doubt(fast, margin) ? tautline::bench::normal_quantile(parts[index])
                                       : static_cast<double>(fast);
  }
}
