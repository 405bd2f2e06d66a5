#pragma once

namespace tautline::bench {

/// A run that freezes: the body stops in one go where the exact motion swings on.
struct Freeze {
  double moving = 0.0;  // [s], of the last sample before
  double time = 0.0;    // [s], of the first sample from which on nothing moves
  double lost = 0.0;    // [J], of energy between the two
};

}  // namespace tautline::bench
