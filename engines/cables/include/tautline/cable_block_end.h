// How a cable pulls at a body, as the solve of cable_block.h feels it.

#pragma once

#include <algorithm>
#include <cmath>

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

/// What the impulses of all cables together do to the turning of a body.
struct CableTorque {
  double torque[3] = {0.0, 0.0, 0.0};  // impulse of it [N m s]
  double turned[3] = {0.0, 0.0, 0.0};  // what it changes the spin by, as much of it as is kept
  double change[3] = {0.0, 0.0, 0.0};  // the same by all of it [rad/s]
  double arms = 0.0;                   // impulse times arm, of all ends [N m s]
  int pulling = 0;                     // cables

  /// A step follows what turns by less than this in it [rad].
  static double farthest_turn() { return 0.3; }

  /// Adds a cable that pulls at `end` with `impulse` [N s].
  void add(const CableBlockEnd& end, double impulse) {
    ++pulling;
    arms += impulse * end.arm;
    for (int axis = 0; axis < 3; ++axis) {
      torque[axis] += end.moment[axis] * impulse;
      turned[axis] += end.turn[axis] * impulse;
      change[axis] += end.turn[axis] * impulse / end.kept;
    }
  }

  /// How much of it a step of `dt` [s] can follow, of a body with `spin` [rad/s]; see
  /// CableBlock::solve_stiffly.
  double part_to_keep(const double* spin, double dt) const {
    const double work = CableBlockEnd::dot(torque, change);
    if (pulling < 2 || !(work > 0.0)) {
      return 1.0;
    }
    const double inertia = CableBlockEnd::dot(torque, torque) / work;
    const double resolved = 4.0;
    const double followed = inertia / (inertia + std::max(arms * dt - resolved * inertia, 0.0));
    const double reverses = -2.0 * CableBlockEnd::dot(torque, spin) / work;
    const double wanted = std::min(followed, part_within(spin, farthest_turn() / dt));
    return std::min(std::max(wanted, reverses), 1.0);
  }
  /// How much of the change leaves `spin` no faster than `fastest` [rad/s].
  double part_within(const double* spin, double fastest) const {
    const double square = CableBlockEnd::dot(change, change);
    const double along = CableBlockEnd::dot(change, spin);
    const double room = fastest * fastest - CableBlockEnd::dot(spin, spin);
    if (square + 2.0 * along <= room) {
      return 1.0;
    }
    const double root = along * along + square * room;
    return std::max(((root > 0.0 ? std::sqrt(root) : 0.0) - along) / square, 0.0);
  }
};

}  // namespace tautline
// NOLINTEND(modernize-use-nodiscard)
