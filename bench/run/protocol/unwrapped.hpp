#pragma once

#include "tautline/case.hpp"

namespace tautline::bench {

/// Throws ProtocolError if the angle jumps by about a turn or more in a move of `dt` [s] for which
/// the spins before and after give no reason: engines keep angles that know no turns.
void refuse_wrapped(const State& before, const State& after, double dt);

}  // namespace tautline::bench
