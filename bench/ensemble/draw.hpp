#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "bench/ensemble/spec.hpp"

namespace tautline::bench {

/// One draw of an ensemble: a value for each of `EnsembleSpec::varied`.
using DrawnValues = std::vector<double>;

/// Draw `index` of `spec`, with `seed` in place of its own. It follows from these alone: not from
/// the count, nor from what was drawn before.
[[nodiscard]] DrawnValues drawn_values(const EnsembleSpec& spec, std::uint64_t seed,
                                       std::size_t index);

/// The case with these values. It may have `problems`: a start beyond the end of a cable.
[[nodiscard]] AnyCase case_of(const EnsembleSpec& spec, const DrawnValues& values);

/// The point of the grid that draw `index` is at.
[[nodiscard]] std::size_t grid_point(const EnsembleSpec& spec, std::size_t index);

}  // namespace tautline::bench
