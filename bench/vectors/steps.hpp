#pragma once

#include "bench/vectors/vector.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// A row may be off by this many steps times `fastest` times `growth`: a scheme that meets an
/// impact a step late is off by the way there and by the way back.
inline constexpr double allowed_steps = 2.0;

/// Sets `step` of each row: the longest step of a scheme of first order that the row can judge. It
/// never rises. From some instant on a step is too long because
///
/// - it may be off by a twentieth of the shortest cable;
/// - impacts of two cables are so close that such a scheme may come to them in the other order, or
///   to both in one step;
/// - a cable just misses an impact, which such a scheme may have.
///
/// `solution` is the motion in doubles, which is right as far as rows have a growth.
void set_steps(Vector& vector, const Solution& solution);

}  // namespace tautline::bench
