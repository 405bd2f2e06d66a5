#pragma once

#include "bodies.hpp"
#include "tautline/cable_set.hpp"

namespace tautline::simbody {

/// Newton's law for `cables` at the poses of `state`, as a complementarity problem (Eq. 14): the
/// gap of each opens with at least its rate of `rates` [m/s], and no cable is pushed. Changes the
/// speeds of `state`, which is realized to dynamics, and returns the impulses [N s]. Both vectors
/// have one entry per cable of `cables`. Jacobians and masses are Simbody's.
template <class TheCase>
[[nodiscard]] CableVector strike(Bodies<TheCase>& bodies, SimTK::State& state, CableSet cables,
                                 const CableVector& rates);

}  // namespace tautline::simbody
