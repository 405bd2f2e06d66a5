#pragma once

#include <cstddef>
#include <vector>

namespace tautline::bench {

/// The largest distance between the distribution functions of two samples in rising order, neither
/// empty: 0 where they are alike, 1 where no value of the one lies among those of the other.
[[nodiscard]] double kolmogorov_distance(const std::vector<double>& one,
                                         const std::vector<double>& other);

/// How likely two samples of these sizes from one distribution are at least this far apart: the
/// limit of large samples, which is off by less than 0.004 for two of 10. Where it is below 0.1 it
/// errs to the safe side, and more so where values are equal. By hand: Boost.Math has this
/// distribution from 1.75 on, Debian 12 has 1.74. Stephens' correction is for one sample.
[[nodiscard]] double kolmogorov_probability(double distance, std::size_t one, std::size_t other);

/// The distance that is just as unlikely as `probability`, in (0, 1).
[[nodiscard]] double critical_distance(double probability, std::size_t one, std::size_t other);

/// The smallest shift that would move a sample, in rising order, as far as `distance` from itself:
/// the shortest interval that holds this share of it.
[[nodiscard]] double visible_shift(const std::vector<double>& sample, double distance);

}  // namespace tautline::bench
