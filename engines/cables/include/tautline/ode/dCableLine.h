// A cable's straight line between two ODE bodies at a pose: the Jacobian of its row.

#ifndef TAUTLINE_ODE_CABLE_LINE_H
#define TAUTLINE_ODE_CABLE_LINE_H

#include <ode/ode.h>

#include <cmath>

#include "tautline/cable_rule.h"
#include "tautline/force_trend.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// A force [N] and a torque [N m] on a body, in the world; none unless set.
struct dxPush {
  dVector3 force;
  dVector3 torque;

  dxPush() : force(), torque() {}
  /// What acts on `body` in the next step, but gravity.
  explicit dxPush(dBodyID body) {
    dCopyVector3(force, dBodyGetForce(body));
    dCopyVector3(torque, dBodyGetTorque(body));
  }
  void set(dBodyID body) const {
    dBodySetForce(body, force[0], force[1], force[2]);
    dBodySetTorque(body, torque[0], torque[1], torque[2]);
  }
  dxPush& operator+=(const dxPush& other) {
    dAddVectors3(force, force, other.force);
    dAddVectors3(torque, torque, other.torque);
    return *this;
  }
  dxPush& operator-=(const dxPush& other) {
    dSubtractVectors3(force, force, other.force);
    dSubtractVectors3(torque, torque, other.torque);
    return *this;
  }
};

/// What dStepWithCables remembers of the user's forces on a body.
struct dxPushes {
  struct Trend {
    tautline::ForceTrend<dReal> force;
    tautline::ForceTrend<dReal> torque;

    void next(dxPush& push, dReal dt) {
      force.next(push.force, dt);
      torque.next(push.torque, dt);
    }
  };

  void forget() { given = added = Trend(); }

  Trend given;             // before the steps
  Trend added;             // by the step function, in the parts
  dxPush last;             // that it added in the last part
  bool is_struck = false;  // by an impact since
};

/// One end of a cable: a point of a body, or of the world.
struct dxCableEnd {
  dBodyID body;     // 0: the world
  dReal anchor[4];  // in the body's frame, or the world's [m]
  dxPushes pushes;

  explicit dxCableEnd(dBodyID the_body = nullptr) : body(the_body), anchor() {}

  /// Fastens the end to the point (x, y, z) of the world as it is now [m].
  void fasten(dReal x, dReal y, dReal z) {
    if (body != nullptr) {
      dBodyGetPosRelPoint(body, x, y, z, anchor);
    } else {
      anchor[0] = x, anchor[1] = y, anchor[2] = z;
    }
  }
  /// Where it is now, in the world [m].
  void position(dReal* result) const {
    if (body != nullptr) {
      dBodyGetRelPointPos(body, anchor[0], anchor[1], anchor[2], result);
    } else {
      result[0] = anchor[0], result[1] = anchor[1], result[2] = anchor[2];
    }
  }
  /// True if ODE steps it; of a hook, if it goes anywhere.
  bool is_awake() const {
    return body != nullptr && dBodyIsEnabled(body) != 0 &&
           (is_moved() || dCalcVectorLengthSquare3(dBodyGetLinearVel(body)) > 0 ||
            dCalcVectorLengthSquare3(dBodyGetAngularVel(body)) > 0);
  }
  /// True if forces move it.
  bool is_moved() const { return body != nullptr && dBodyIsKinematic(body) == 0; }
};

/// Of gravity [m/s^2] and the user's forces on a body that they move [m/s^2].
inline void dxBodyAcceleration(dBodyID body, const dReal* gravity, dReal* result) {
  const dReal falls = dBodyGetGravityMode(body) != 0 ? dReal(1) : dReal(0);
  dCopyScaledVector3(result, gravity, falls);
  const dReal* force = dBodyGetForce(body);
  if (dCalcVectorLengthSquare3(force) > 0) {
    dMass mass;
    dBodyGetMass(body, &mass);
    dAddScaledVectors3(result, result, force, 1, 1 / mass.mass);
  }
}

/// True if a body has the same moment about any axis: a ball's.
inline bool dxMassIsRound(const dMass& mass) {
  const dReal* moments = mass.I;
  return moments[0] == moments[5] && moments[5] == moments[10] && moments[1] == 0 &&
         moments[2] == 0 && moments[6] == 0;  // exactly, or it is not
}

/// result = I^-1 vector, both in the world.
inline void dxBodySolveInertia(dBodyID body, const dMass& mass, const dReal* vector,
                               dReal* result) {
  const dReal* moments = mass.I;
  if (dxMassIsRound(mass)) {
    dCopyScaledVector3(result, vector, moments[0] > 0 ? 1 / moments[0] : 0);
    return;
  }
  dMatrix3 inverse = {0};  // stays so if a user has given no inertia
  dInvertMatrix3(inverse, moments);
  dVector3 local, turned;
  dMultiply1_331(local, dBodyGetRotation(body), vector);
  dMultiply0_331(turned, inverse, local);
  dMultiply0_331(result, dBodyGetRotation(body), turned);
}
inline void dxBodySolveInertia(dBodyID body, const dReal* vector, dReal* result) {
  dMass mass;
  dBodyGetMass(body, &mass);
  dxBodySolveInertia(body, mass, vector, result);
}

/// Turns a body where it is, by `angle` [rad] about `axis`, of any length.
inline void dxBodyTurn(dBodyID body, const dReal* axis, dReal angle) {
  if (angle != 0) {
    dQuaternion rotation, turned;
    dQFromAxisAndAngle(rotation, axis[0], axis[1], axis[2], angle);
    dQMultiply0(turned, rotation, dBodyGetQuaternion(body));
    dBodySetQuaternion(body, turned);
  }
}

/// Of gravity and the user's forces on a body, a hook or the world [m/s^2].
inline void dxEndAcceleration(const dxCableEnd& end, dReal* result) {
  dVector3 gravity = {0, 0, 0, 0};
  dCopyVector3(result, gravity);
  if (end.is_moved()) {
    dWorldGetGravity(dBodyGetWorld(end.body), gravity);
    dxBodyAcceleration(end.body, gravity, result);
  }
}

/// Turns `arm` by `angle` [rad] about `axis`, of any length.
inline void dxTurn(dReal* arm, const dReal* axis, dReal angle) {
  if (angle == 0) {
    return;
  }
  dVector3 unit, quarter, half;
  dCopyScaledVector3(unit, axis, 1 / dCalcVectorLength3(axis));
  // Rodrigues: arm + sin(angle) axis x arm + (1 - cos(angle)) axis x (axis x arm)
  dCalcVectorCross3(quarter, unit, arm);
  dCalcVectorCross3(half, unit, quarter);
  dAddScaledVectors3(quarter, quarter, half, std::sin(angle), 1 - std::cos(angle));
  dAddVectors3(arm, arm, quarter);
}

/// Where an end is after `stepsize` if nothing but forces acts; ODE's gyroscopic torque is left
/// out.
inline void dxEndAfter(const dxCableEnd& end, dReal stepsize, dReal* result) {
  if (end.body == nullptr || dBodyIsEnabled(end.body) == 0) {
    end.position(result);
    return;
  }
  dVector3 linear = {0, 0, 0, 0};
  dVector3 angular = {0, 0, 0, 0};
  if (end.is_moved()) {
    dVector3 gravity;
    dWorldGetGravity(dBodyGetWorld(end.body), gravity);
    dxBodyAcceleration(end.body, gravity, linear);
    dxBodySolveInertia(end.body, dBodyGetTorque(end.body), angular);
  }
  dVector3 spin, arm;
  dAddScaledVectors3(spin, dBodyGetAngularVel(end.body), angular, 1, stepsize);
  // ODE's turn of a step: of first order and normalised, or by the whole angle
  const dReal angle = dCalcVectorLength3(spin) * stepsize;
  const bool finite = dBodyGetFiniteRotationMode(end.body) != 0;
  dBodyVectorToWorld(end.body, end.anchor[0], end.anchor[1], end.anchor[2], arm);
  dxTurn(arm, spin, finite ? angle : 2 * std::atan(angle / 2));
  dxTurn(arm, angular, -stepsize * stepsize / 2 * dCalcVectorLength3(angular));
  const dReal* velocity = dBodyGetLinearVel(end.body);
  const dReal* position = dBodyGetPosition(end.body);
  for (int axis = 0; axis < 3; ++axis) {
    result[axis] = position[axis] + arm[axis] + stepsize * velocity[axis] +
                   stepsize * stepsize / 2 * linear[axis];
  }
}

/// The spin of a body after `stepsize` of ODE's gyroscopic torque, which it takes implicitly: it
/// solves (I - h L x) w = L for it, with the angular momentum L of the spin now [rad/s].
inline void dxBodyGyroscopicSpin(dBodyID body, dReal stepsize, dReal* result) {
  dCopyVector3(result, dBodyGetAngularVel(body));
  if (dBodyGetGyroscopicMode(body) == 0 || dCalcVectorLengthSquare3(result) == 0) {
    return;
  }
  dMass mass;
  dBodyGetMass(body, &mass);
  if (dxMassIsRound(mass)) {
    return;
  }
  dMatrix3 turned = {0}, inertia = {0}, inverse = {0};
  dMultiply2_333(turned, mass.I, dBodyGetRotation(body));
  dMultiply0_333(inertia, dBodyGetRotation(body), turned);
  dVector3 momentum;
  dMultiply0_331(momentum, inertia, result);
  dMatrix3 cross = {0};
  dSetCrossMatrixMinus(cross, momentum, 4);
  for (int index = 0; index < 12; ++index) {
    inertia[index] += stepsize * cross[index];
  }
  if (dInvertMatrix3(inverse, inertia) != 0) {
    dMultiply0_331(result, inverse, momentum);
  }
}

/// How a body moves, for a line's rates; the world does not.
struct dxMotion {
  dVector3 velocity;  // [m/s]
  dVector3 spin;      // [rad/s]

  explicit dxMotion(dBodyID body = nullptr) : velocity(), spin() { find(body); }

  void find(dBodyID body) {
    if (body != nullptr) {
      dCopyVector3(velocity, dBodyGetLinearVel(body));
      dCopyVector3(spin, dBodyGetAngularVel(body));
    }
  }
  /// After `stepsize` in which only gravity and the user's forces act.
  void find(dBodyID body, const dReal* gravity, dReal stepsize) {
    find(body);
    if (body != nullptr && dBodyIsKinematic(body) == 0) {
      dVector3 acceleration;
      dxBodyAcceleration(body, gravity, acceleration);
      dAddScaledVectors3(velocity, velocity, acceleration, 1, stepsize);
      dxBodyGyroscopicSpin(body, stepsize, spin);
      const dReal* torque = dBodyGetTorque(body);
      if (dCalcVectorLengthSquare3(torque) > 0) {
        dxBodySolveInertia(body, torque, acceleration);
        dAddScaledVectors3(spin, spin, acceleration, 1, stepsize);
      }
    }
  }
};

/// The gap's rate is towards * (v1 - v2) + moment1 * w1 - moment2 * w2.
struct dxCableLine {
  dReal distance;      // of the anchors [m]
  dVector3 towards;    // from 1 to 2, of length 1; zero if the distance is
  dVector3 point[2];   // the anchors [m]
  dVector3 arm[2];     // from a body's centre to its anchor [m]
  dVector3 moment[2];  // arm x towards [m]; zero for the world

  dxCableLine() : distance(0), towards(), point(), arm(), moment() {}

  explicit dxCableLine(const dxCableEnd* end) : dxCableLine() { find(end); }

  /// The line between the ends now.
  void find(const dxCableEnd* end) {
    for (int index = 0; index < 2; ++index) {
      const dBodyID body = end[index].body;
      if (body != nullptr) {
        dMultiply0_331(arm[index], dBodyGetRotation(body), end[index].anchor);
        dAddVectors3(point[index], arm[index], dBodyGetPosition(body));
      } else {
        dCopyVector3(point[index], end[index].anchor);
      }
    }
    dSubtractVectors3(towards, point[1], point[0]);
    distance = dCalcVectorLength3(towards);
    if (distance > 0) {
      dScaleVector3(towards, 1 / distance);
    }
    for (int index = 0; index < 2; ++index) {
      if (end[index].body != nullptr) {
        dCalcVectorCross3(moment[index], arm[index], towards);
      }
    }
  }

  /// The rate of the gap [m/s].
  dReal rate(const dxMotion& one, const dxMotion& two) const {
    return dCalcVectorDot3(towards, one.velocity) - dCalcVectorDot3(towards, two.velocity) +
           dCalcVectorDot3(moment[0], one.spin) - dCalcVectorDot3(moment[1], two.spin);
  }
  dReal rate(const dxCableEnd* end) const {
    return rate(dxMotion(end[0].body), dxMotion(end[1].body));
  }

  tautline::CableSwing<dReal> swing(const dxMotion& one, const dxMotion& two) const {
    dVector3 relative, turning;
    dSubtractVectors3(relative, two.velocity, one.velocity);
    dCalcVectorCross3(turning, two.spin, arm[1]);
    dAddVectors3(relative, relative, turning);
    dCalcVectorCross3(turning, one.spin, arm[0]);
    dSubtractVectors3(relative, relative, turning);
    const dReal along = dCalcVectorDot3(towards, relative);
    const dReal rest = dCalcVectorLengthSquare3(relative) - along * along;
    tautline::CableSwing<dReal> result;
    result.along = along * along;
    result.across = rest > 0 ? rest : 0;
    result.inward = centripetal(two, 1) - centripetal(one, 0);
    result.reach = dCalcVectorLengthSquare3(two.spin) * dCalcVectorLength3(arm[1]) +
                   dCalcVectorLengthSquare3(one.spin) * dCalcVectorLength3(arm[0]);
    result.spin = std::max(dCalcVectorLength3(one.spin), dCalcVectorLength3(two.spin));
    return result;
  }

 private:
  dReal centripetal(const dxMotion& motion, int index) const {
    dVector3 turning, twice;
    dCalcVectorCross3(turning, motion.spin, arm[index]);
    dCalcVectorCross3(twice, motion.spin, turning);
    return dCalcVectorDot3(towards, twice);
  }
};

// NOLINTEND(modernize-use-nodiscard)

#endif
