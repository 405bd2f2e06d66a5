// A cable's straight line between two ODE bodies at a pose: the Jacobian of its row.

#ifndef TAUTLINE_ODE_CABLE_LINE_H
#define TAUTLINE_ODE_CABLE_LINE_H

#include <ode/ode.h>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// One end of a cable: a point of a body, or of the world.
struct dxCableEnd {
  dBodyID body;     // 0: the world
  dReal anchor[4];  // in the body's frame, or the world's [m]

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
  /// True if ODE steps it.
  bool is_awake() const { return body != nullptr && dBodyIsEnabled(body) != 0; }
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

/// result = I^-1 vector, both in the world.
inline void dxBodySolveInertia(dBodyID body, const dReal* vector, dReal* result) {
  dMass mass;
  dBodyGetMass(body, &mass);
  dMatrix3 inverse = {0};  // stays so if a user has given no inertia
  dInvertMatrix3(inverse, mass.I);
  dVector3 local, turned;
  dMultiply1_331(local, dBodyGetRotation(body), vector);
  dMultiply0_331(turned, inverse, local);
  dMultiply0_331(result, dBodyGetRotation(body), turned);
}

/// The gap's rate is towards * (v1 - v2) + moment1 * w1 - moment2 * w2.
struct dxCableLine {
  dReal distance;      // of the anchors [m]
  dVector3 towards;    // from 1 to 2, of length 1; zero if the distance is
  dVector3 point[2];   // the anchors [m]
  dVector3 moment[2];  // arm x towards [m]; zero for the world

  dxCableLine() : distance(0), towards(), point(), moment() {}

  explicit dxCableLine(const dxCableEnd* end) : dxCableLine() { find(end); }

  /// The line between the ends now.
  void find(const dxCableEnd* end) {
    dVector3 arm[2];
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
  dReal rate(const dxCableEnd* end) const {
    dReal result = 0;
    for (int index = 0; index < 2; ++index) {
      if (end[index].body != nullptr) {
        const dReal one = dCalcVectorDot3(towards, dBodyGetLinearVel(end[index].body)) +
                          dCalcVectorDot3(moment[index], dBodyGetAngularVel(end[index].body));
        result += index == 0 ? one : -one;
      }
    }
    return result;
  }

  /// What gravity [m/s^2] and the bodies' forces and torques add to that rate in a second [m/s^2].
  dReal acceleration(const dxCableEnd* end, const dReal* gravity) const {
    dReal result = 0;
    for (int index = 0; index < 2; ++index) {
      if (end[index].is_moved()) {
        dVector3 linear;
        dxBodyAcceleration(end[index].body, gravity, linear);
        dReal one = dCalcVectorDot3(towards, linear);
        const dReal* torque = dBodyGetTorque(end[index].body);
        if (dCalcVectorLengthSquare3(torque) > 0) {
          dVector3 angular;
          dxBodySolveInertia(end[index].body, torque, angular);
          one += dCalcVectorDot3(moment[index], angular);
        }
        result += index == 0 ? one : -one;
      }
    }
    return result;
  }

  /// J M^-1 J^T [1/kg]: what an impulse of 1 N s adds to that rate.
  dReal inverse_mass(const dxCableEnd* end) const {
    dReal result = 0;
    for (int index = 0; index < 2; ++index) {
      if (end[index].is_moved()) {
        dMass mass;
        dBodyGetMass(end[index].body, &mass);
        dVector3 turn;
        dxBodySolveInertia(end[index].body, moment[index], turn);
        result += 1 / mass.mass + dCalcVectorDot3(moment[index], turn);
      }
    }
    return result;
  }
};

// NOLINTEND(modernize-use-nodiscard)

#endif
