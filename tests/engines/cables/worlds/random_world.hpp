// Worlds drawn from a seed: the acceptance's many.

#pragma once

#include "engines/cables/worlds/world.hpp"

namespace tautline::test {

/// The world of `seed`: 1 to 10 loads on 1 to 10 cables; the kinds follow each other by seed.
[[nodiscard]] World random_world(std::uint64_t seed);

}  // namespace tautline::test
