#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "support.hpp"
#include "tautline/impact.hpp"

namespace tautline::test {

// Random systems from families that are hard for a double.

/// A difficulty: what it makes of an ordinary random case of ten seconds.
struct HardFamily {
  const char* name;
  Case (*make)(Random&, Case);
};

/// All of them: inertia from 1e-9 to 1e9 of m a^2, spin to 1e7 rad/s, each cable twice, cables that
/// wedge the body, cables near one line, sizes from 1e-6 to 1e6, an origin 1e6 away, and elastic
/// cables beside plastic ones.
[[nodiscard]] const std::array<HardFamily, 8>& hard_families();

inline constexpr std::uint64_t hard_seed = 20261114;

/// A case and the law of its impacts.
struct HardSystem {
  Case the_case;
  ImpactLaw law;
};

/// The next of a family, of which `sample` have been drawn from `random`: cables one to eight and
/// laws in turn, every third with a second difficulty. None where its anchors come out so far apart
/// that the body cannot float.
[[nodiscard]] std::optional<HardSystem> hard_system(Random& random, const HardFamily& family,
                                                    int sample);

}  // namespace tautline::test
