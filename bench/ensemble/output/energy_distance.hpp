#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tautline::bench {

// The energy distance of two samples (Székely and Rizzo 2013), 2 E|X-Y| - E|X-X'| - E|Y-Y'|, which
// on a line is twice the integral of the squared difference of the distribution functions. By hand,
// in one pass: no kept library of C++ has it. Samples are finite and in rising order.

/// The distance as a share of 2 E|X-Y|: 0 for one distribution, 1 for two points apart.
[[nodiscard]] double energy_coefficient(const std::vector<double>& one,
                                        const std::vector<double>& other);

/// How likely two samples of one distribution are at least this far apart: the share of random
/// permutations between the two that are, out of `permutations`. Ends earlier where twenty of them
/// are (Besag and Clifford 1991): the share is large then.
[[nodiscard]] double energy_probability(const std::vector<double>& one,
                                        const std::vector<double>& other, std::uint64_t seed,
                                        std::size_t permutations);

}  // namespace tautline::bench
