// Normal numbers with the bits of `tautline ensemble`, for the package of Python.
#include <cstddef>
#include <cstdint>

#include "bench/ensemble/normal.hpp"

/// The quantiles of the standard normal distribution at `parts`, each in (0, 1). `margin`: see
/// `normal_quantile`.
extern "C" __attribute__((visibility("default"))) void tautline_normal_quantiles(
    const double* parts, std::size_t count, std::uint64_t margin, double* to) {
  for (std::size_t index = 0; index < count; ++index) {
    to[index] = tautline::bench::normal_quantile(parts[index], margin);
  }
}
