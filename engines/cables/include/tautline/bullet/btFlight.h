// How Bullet moves a body in a step in which nothing but forces acts, as it goes on in a step by
// events: with half of Bullet's way by the forces.

#ifndef TAUTLINE_BT_FLIGHT_H
#define TAUTLINE_BT_FLIGHT_H

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btTransformUtil.h>

#include "tautline/bullet/btMovingEnd.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// The bodies of btStepWithCables between impacts.
struct btFlight {
  /// True if forces move the body.
  static bool isMoved(const btRigidBody& body) {
    return !body.isStaticOrKinematicObject() && body.isActive();
  }

  /// [m/s^2] of gravity and the user's force; gravity is not in the total force between steps
  static btVector3 acceleration(const btRigidBody& body) {
    return isMoved(body) ? body.getGravity() * body.getLinearFactor() +
                               body.getTotalForce() * body.getInvMass()
                         : btVector3(0, 0, 0);
  }
  /// The velocity after `timeStep` [s] of Bullet's damping.
  static btVector3 damped(const btVector3& velocity, btScalar damping, btScalar timeStep) {
    return damping > 0 ? velocity * btPow(1 - damping, timeStep) : velocity;
  }
  /// [rad/s^2] of the user's torque
  static btVector3 turning(const btRigidBody& body) {
    return isMoved(body) ? body.getInvInertiaTensorWorld() * body.getTotalTorque()
                         : btVector3(0, 0, 0);
  }
  /// By half of what Bullet turns a body in a step that gives it the spin of `turning` in it.
  static btTransform turnedBack(const btTransform& pose, const btVector3& turning,
                                btScalar timeStep) {
    if (turning.isZero()) {
      return pose;
    }
    btTransform result;
    btTransformUtil::integrateTransform(pose, btVector3(0, 0, 0), -timeStep / 2 * turning, timeStep,
                                        result);
    return result;
  }
  /// `moving` moves it, if it is not null.
  static btTransform poseAfter(const btRigidBody& body, const btMovingEnd* moving,
                               btScalar timeStep);
};

inline btTransform btFlight::poseAfter(const btRigidBody& body, const btMovingEnd* moving,
                                       btScalar timeStep) {
  if (moving != nullptr) {
    return moving->poseAfter(timeStep);
  }
  const btTransform& pose = body.getCenterOfMassTransform();
  if (!isMoved(body)) {
    return pose;
  }
  btVector3 spin = damped(body.getAngularVelocity(), body.getAngularDamping(), timeStep) +
                   timeStep * turning(body);
  if (body.getFlags() & BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY) {
    spin += body.computeGyroscopicImpulseImplicit_Body(timeStep);
  }
  const btVector3 velocity = damped(body.getLinearVelocity(), body.getLinearDamping(), timeStep) +
                             timeStep / 2 * acceleration(body);
  btTransform result;
  btTransformUtil::integrateTransform(pose, velocity, spin, timeStep, result);
  return turnedBack(result, turning(body), timeStep);
}

// NOLINTEND(modernize-use-nodiscard)

#endif
