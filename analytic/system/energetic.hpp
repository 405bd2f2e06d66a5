#pragma once

#include "impact/energetic_impact.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// The springs of the energetic law move in the space of their cables' rows. It may have this many
/// dimensions, those of one planar body: what is held at the edge is enumerated (box_forces.hpp).
inline constexpr std::size_t most_energetic = 3;

/// Stronge's law for up to `most_energetic` touching cables of a system; NaN for more.
template <class Real, int D>
[[nodiscard]] SpringImpulses<Real> energetic_impulses(const BasicSystem<Real, D>& system,
                                                      const BasicSystemState<Real, D>& before,
                                                      CableSet cables);

}  // namespace tautline
