// How a user's force goes on from one evaluation to the next, in steps that are split at impacts.
// Bullet's and ODE's drop-in cables share it; it knows neither, and needs C++11 alone.
//
// A step holds the force that the user computed as it began, and a step by events puts a body where
// that takes it. Of a spring this would be Euler's explicit method, which adds energy. So a force
// that changes smoothly acts by the mean that it is expected to have until the next evaluation, and
// is put right there: by what the trapezoidal rule had been instead. That takes some energy out, as
// long as a body swings no faster than once in eight steps. A force that is constant, jumps or acts
// for one step acts as it is given.

#pragma once

#include <algorithm>
#include <cmath>

namespace tautline {

/// A force [N], or a torque [N m], from evaluation to evaluation. Start anew after an impact, which
/// may change the force at once.
template <typename Real>
class ForceTrend {
 public:
  /// Replaces `force`, as the user has computed it now, by the mean that acts for the next `dt`
  /// [s].
  void next(Real* force, Real dt) {
    Real slope[3];
    Real change[3];
    for (int axis = 0; axis < 3; ++axis) {
      slope[axis] = known_ > 0 ? (force[axis] - last_[axis]) / last_dt_ : Real(0);
      change[axis] = slope[axis] - slope_[axis];
    }
    const Real jump = Real(0.8);  // what changes its slope by as much of it is not smooth
    const bool smooth =
        known_ > 1 && length(change) <= jump * std::max(length(slope), length(slope_));
    for (int axis = 0; axis < 3; ++axis) {
      const Real now = force[axis];
      const Real right = smooth ? (now + last_[axis]) / 2 : last_[axis];
      const Real owed = known_ > 0 ? last_dt_ * (right - used_[axis]) : Real(0);  // [N s]
      used_[axis] = smooth ? now + slope[axis] * dt / 2 : now;
      force[axis] = used_[axis] + owed / dt;
      slope_[axis] = slope[axis];
      last_[axis] = now;
    }
    last_dt_ = dt;
    known_ = std::min(known_ + 1, 2);
  }

 private:
  static Real length(const Real* of) {
    return std::sqrt(of[0] * of[0] + of[1] * of[1] + of[2] * of[2]);
  }

  int known_ = 0;       // evaluations, at most 2
  Real last_[3] = {0};  // the last one
  Real slope_[3] = {0};
  Real used_[3] = {0};  // the mean that acted since
  Real last_dt_ = 0;    // [s]
};

}  // namespace tautline
