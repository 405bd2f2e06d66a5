#pragma once

#include <cstdint>

namespace tautline::bench {

/// What random numbers are for. Those of one purpose tell nothing of those of another.
enum class Purpose : std::uint64_t { draw = 1, shift = 2, permutation = 3 };

/// 64 random bits that follow from these numbers alone, on any machine and in any order: Philox4x64
/// with ten rounds (Salmon et al. 2011), from Random123.
[[nodiscard]] std::uint64_t random_bits(std::uint64_t seed, Purpose purpose, std::uint64_t index,
                                        std::uint64_t place);

/// The same as a number in (0, 1), evenly spread; never 0 or 1.
[[nodiscard]] double random_part(std::uint64_t seed, Purpose purpose, std::uint64_t index,
                                 std::uint64_t place);

}  // namespace tautline::bench
