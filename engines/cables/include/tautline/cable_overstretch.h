// How a step takes the overstretch out of cables that share bodies: it moves their ends. Bullet's
// and ODE's drop-in cables share it; it knows neither, and needs C++11 alone.
//
// A Host has the cables that pull, in the order of the block's rows:
//
// clang-format off
//   Real distance(index)          of the ends, on the line of the row [m]
//   Real distance_now(index)      of the ends, where they are by now [m]
//   Real correction(index)        see CableRule; negative: may become longer [m]
//   Real length(index)            [m]
//   Real& aimed(index)            memory for a distance [m]
//   void move(index, push)        its ends, by as much as `push` changes their velocities [kg m]
//   void slow_turning()           halves the spin of bodies that turn too far for a step to follow
//   void look_again()             lines, rows and block are those of where the ends are by now
// clang-format on

#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "tautline/cable_block.h"

namespace tautline {

/// The largest correction of a cable that is no rounding [m]; notes the distances that they aim at.
template <typename Real, typename Host>
Real aim(Host& host, std::size_t count) {
  Real most = 0;
  for (std::size_t index = 0; index < count; ++index) {
    const Real correction = host.correction(index);
    host.aimed(index) = host.distance(index) - correction;
    if (correction > 4 * std::numeric_limits<Real>::epsilon() * host.length(index)) {
      most = std::max(most, correction);
    }
  }
  return most;
}

/// Newton's method for the gaps that the corrections ask for. One round does, unless bodies turn by
/// much; then the step goes on from the lines where they are now.
template <typename Real, typename Host>
void move_out_of_overstretch(Host& host, CableBlock& block, std::size_t count) {
  const Real most = aim<Real>(host, count);
  const int rounds = most > 0 ? 10 : 0;
  for (int done = 0; done < rounds; ++done) {
    for (std::size_t index = 0; index < count; ++index) {
      block.lacking(index) = host.distance(index) - host.aimed(index);
    }
    const bool bounded = block.solve_moves();
    for (std::size_t index = 0; index < count; ++index) {
      if (block.impulse(index) > 0) {
        host.move(index, block.impulse(index));
      }
    }
    Real left = 0;
    for (std::size_t index = 0; index < count; ++index) {
      const Real rounding = 100 * std::numeric_limits<Real>::epsilon() * host.length(index);
      left = std::max(left, host.distance_now(index) - host.aimed(index) - rounding);
    }
    const Real enough = Real(0.1);  // of the correction: the rest comes in the next steps
    const bool is_done = left <= enough * most;
    if (is_done && !bounded) {
      break;
    }
    if (done == 0 && !is_done) {
      host.slow_turning();
    }
    host.look_again();
    if (is_done) {
      break;
    }
  }
}

}  // namespace tautline
