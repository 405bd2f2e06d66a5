#pragma once

#include <vector>

namespace tautline::bench {

/// The `part` (0 to 1) of `values`, at least one: linear between neighbours in their order.
[[nodiscard]] double quantile(std::vector<double> values, double part);

/// Half of `values`, at least one, are smaller; the mean of the middle two where they are even in
/// number.
[[nodiscard]] double median(std::vector<double> values);

/// The slope of log10 `errors` over log10 `steps` by least squares; sizes equal, at least 2, all >
/// 0.
[[nodiscard]] double slope(const std::vector<double>& steps, const std::vector<double>& errors);

}  // namespace tautline::bench
