#pragma once

#include <cstdint>

#include "bench/chapter/corrections/correction.hpp"

namespace tautline::bench {

/// The seed of every random draw below; the same states on every machine.
inline constexpr std::uint64_t chapter_seed = 20'260'101;

/// Random poses on g1 = 0 at which Eq. 5.66, as printed, has the sign of the boundary's slope
/// wrong.
[[nodiscard]] Share slope_signs_wrong();

/// Random impacts of one cable that leave the sign of the spin as it was.
[[nodiscard]] Share spins_kept();

}  // namespace tautline::bench
