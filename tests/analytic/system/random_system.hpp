#pragma once

#include "support.hpp"
#include "tautline/system.hpp"

namespace tautline::test {

/// A random system of 1 to 5 bodies on 1 to 8 cables, with rings, moving ends, winches, waves, drag
/// and mass ratios up to 1 : 1000; one in some hundreds has `problems`.
[[nodiscard]] System random_system(Random& random);
/// A random system in space, likewise.
[[nodiscard]] SpatialSystem random_spatial_system(Random& random);

}  // namespace tautline::test
