// How a cable pulls at a body, as the solve of cable_block.h feels it.

#pragma once

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it
namespace tautline {

/// One end of a cable as the solve feels it: the gap's rate is the sum over both ends of
/// pull * velocity + moment * spin of its body, and an impulse of 1 N s changes these by `move` and
/// `turn`. A body of null does not move.
struct CableBlockEnd {
  const void* body;  // whose end it is; null: does not move
  double pull[3];    // [-]
  double moment[3];  // [m]
  double move[3];    // [1/kg]
  double turn[3];    // [rad/(kg m)]
  double spin[3];    // of the body if no cable pulls [rad/s]
  double arm;        // from its centre to the end [m]
  double kept;       // the part of the torque that `turn` stands for [-], see solve_stiffly

  /// The product of two vectors in space.
  static double dot(const double* a, const double* b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  /// What an impulse at `other` adds to the rate here [1/kg].
  double coupling(const CableBlockEnd& other) const {
    return body != nullptr && body == other.body ? dot(pull, other.move) + dot(moment, other.turn)
                                                 : 0.0;
  }
};

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
