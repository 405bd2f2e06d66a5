#pragma once

#include <vector>

namespace tautline::bench {

/// Of `values`, at least one; the mean of the middle two where they are even in number.
[[nodiscard]] double median(std::vector<double> values);

/// The slope of log10 `errors` over log10 `steps` by least squares; sizes equal, at least 2, all >
/// 0.
[[nodiscard]] double slope(const std::vector<double>& steps, const std::vector<double>& errors);

}  // namespace tautline::bench
