// A cable's straight line between two bodies at a pose: the Jacobian of its row.

#ifndef TAUTLINE_BT_CABLE_LINE_H
#define TAUTLINE_BT_CABLE_LINE_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include "tautline/cable_rule.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// True if a cable moves it. The solver has a place for no other.
inline bool btCableMoves(const btRigidBody& body) {
  return body.getInvMass() > 0 && !body.isStaticOrKinematicObject();
}

/// How a body moves, for a line's rates.
struct btCableMotion {
  btVector3 m_velocity;  // [m/s]
  btVector3 m_spin;      // [rad/s]

  explicit btCableMotion(const btRigidBody& body)
      : m_velocity(body.getLinearVelocity()), m_spin(body.getAngularVelocity()) {}
  btCableMotion(const btVector3& velocity, const btVector3& spin)
      : m_velocity(velocity), m_spin(spin) {}
};

/// The gap's rate is m_towards * (vA - vB) + m_momentA * wA - m_momentB * wB.
struct btCableLine {
  btScalar m_distance;  // of the pivots [m]
  btVector3 m_towards;  // from A to B, of length 1; zero if the distance is
  btVector3 m_armA;     // from A's centre to its pivot [m]
  btVector3 m_armB;     //
  btVector3 m_momentA;  // arm of A x towards [m]
  btVector3 m_momentB;  // arm of B x towards [m]

  btCableLine(const btTransform& poseA, const btVector3& pivotInA, const btTransform& poseB,
              const btVector3& pivotInB)
      : m_armA(poseA.getBasis() * pivotInA), m_armB(poseB.getBasis() * pivotInB) {
    m_towards = poseB.getOrigin() + m_armB - poseA.getOrigin() - m_armA;
    m_distance = m_towards.length();
    m_towards *= m_distance > SIMD_EPSILON ? 1 / m_distance : btScalar(0);
    m_momentA = m_armA.cross(m_towards);
    m_momentB = m_armB.cross(m_towards);
  }

  /// The rate of the gap [m/s].
  btScalar rate(const btCableMotion& a, const btCableMotion& b) const {
    return m_towards.dot(a.m_velocity - b.m_velocity) + m_momentA.dot(a.m_spin) -
           m_momentB.dot(b.m_spin);
  }
  btScalar rate(const btRigidBody& a, const btRigidBody& b) const {
    return rate(btCableMotion(a), btCableMotion(b));
  }

  tautline::CableSwing<btScalar> swing(const btCableMotion& a, const btCableMotion& b) const {
    const btVector3 relative =
        b.m_velocity + b.m_spin.cross(m_armB) - a.m_velocity - a.m_spin.cross(m_armA);
    const btScalar along = m_towards.dot(relative);
    tautline::CableSwing<btScalar> result;
    result.along = along * along;
    result.across = btMax(relative.length2() - result.along, btScalar(0));
    result.inward = m_towards.dot(b.m_spin.cross(b.m_spin.cross(m_armB)) -
                                  a.m_spin.cross(a.m_spin.cross(m_armA)));
    result.reach = b.m_spin.length2() * m_armB.length() + a.m_spin.length2() * m_armA.length();
    result.spin = btSqrt(btMax(a.m_spin.length2(), b.m_spin.length2()));
    return result;
  }

  /// What the bodies' forces and torques add to the rate in a second [m/s^2].
  btScalar acceleration(const btRigidBody& a, const btRigidBody& b) const {
    return m_towards.dot(a.getTotalForce() * a.getInvMass() - b.getTotalForce() * b.getInvMass()) +
           m_momentA.dot(a.getInvInertiaTensorWorld() * a.getTotalTorque()) -
           m_momentB.dot(b.getInvInertiaTensorWorld() * b.getTotalTorque());
  }

  /// J M^-1 J^T [1/kg]: what an impulse of 1 N s adds to that rate.
  btScalar inverseMass(const btRigidBody& a, const btRigidBody& b) const {
    return a.getInvMass() + b.getInvMass() +
           m_momentA.dot(a.getInvInertiaTensorWorld() * m_momentA) +
           m_momentB.dot(b.getInvInertiaTensorWorld() * m_momentB);
  }
};

// NOLINTEND(modernize-use-nodiscard)

#endif
