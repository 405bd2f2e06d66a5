// A cable's straight line between two bodies at a pose: the Jacobian of its row.

#ifndef TAUTLINE_BT_CABLE_LINE_H
#define TAUTLINE_BT_CABLE_LINE_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// The gap's rate is m_towards * (vA - vB) + m_momentA * wA - m_momentB * wB.
struct btCableLine {
  btScalar m_distance;  // of the pivots [m]
  btVector3 m_towards;  // from A to B, of length 1; zero if the distance is
  btVector3 m_momentA;  // arm of A x towards [m]
  btVector3 m_momentB;  // arm of B x towards [m]

  btCableLine(const btTransform& poseA, const btVector3& pivotInA, const btTransform& poseB,
              const btVector3& pivotInB) {
    const btVector3 armA = poseA.getBasis() * pivotInA;
    const btVector3 armB = poseB.getBasis() * pivotInB;
    m_towards = poseB.getOrigin() + armB - poseA.getOrigin() - armA;
    m_distance = m_towards.length();
    m_towards *= m_distance > SIMD_EPSILON ? 1 / m_distance : btScalar(0);
    m_momentA = armA.cross(m_towards);
    m_momentB = armB.cross(m_towards);
  }

  /// The rate of the gap [m/s].
  btScalar rate(const btRigidBody& a, const btRigidBody& b) const {
    return m_towards.dot(a.getLinearVelocity() - b.getLinearVelocity()) +
           m_momentA.dot(a.getAngularVelocity()) - m_momentB.dot(b.getAngularVelocity());
  }

  /// What the bodies' forces and torques add to that rate in a second [m/s^2].
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
