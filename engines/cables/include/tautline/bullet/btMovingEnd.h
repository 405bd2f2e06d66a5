// A kinematic body at a cable's end, a hook say, in a step that is split: it goes its way evenly
// over the parts. Bullet by itself would have it jump the whole way in the first of them.

#ifndef TAUTLINE_BT_MOVING_END_H
#define TAUTLINE_BT_MOVING_END_H

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btMotionState.h>
#include <LinearMath/btTransformUtil.h>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// Takes the place of the body's motion state for one step, and gives it back.
class btMovingEnd : public btMotionState {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// From where `body` was after the last step to where its motion state, or the user, has it now.
  btMovingEnd(btRigidBody* body, btScalar timeStep)
      : m_body(body),
        m_users(body->getMotionState()),
        m_from(body->getInterpolationWorldTransform()),
        m_to(body->getWorldTransform()),
        m_timeStep(timeStep) {
    if (m_users != nullptr) {
      m_users->getWorldTransform(m_to);
    }
    btTransformUtil::calculateVelocity(m_from, m_to, timeStep, m_velocity, m_spin);
    m_body->setLinearVelocity(m_velocity);
    m_body->setAngularVelocity(m_spin);
    m_body->setMotionState(this);
  }
  ~btMovingEnd() override { m_body->setMotionState(m_users); }
  btMovingEnd(const btMovingEnd&) = delete;
  btMovingEnd& operator=(const btMovingEnd&) = delete;

  /// Bullet moves such a body at once if it is awake, and else not at all.
  static bool drives(const btRigidBody& body) {
    return body.isKinematicObject() && body.getActivationState() != ISLAND_SLEEPING;
  }

  const btRigidBody* body() const { return m_body; }
  void advance(btScalar time) { m_time += time; }

  /// The pose `time` [s] from now.
  btTransform poseAfter(btScalar time) const {
    if (m_time + time >= m_timeStep * (1 - 10 * SIMD_EPSILON)) {
      return m_to;  // without rounding
    }
    btTransform pose;
    btTransformUtil::integrateTransform(m_from, m_velocity, m_spin, m_time + time, pose);
    return pose;
  }

  /// The world asks for the pose at the end of a part.
  void getWorldTransform(btTransform& pose) const override { pose = poseAfter(0); }
  void setWorldTransform(const btTransform& /*pose*/) override {}

 private:
  btRigidBody* m_body;
  btMotionState* m_users;
  btTransform m_from;
  btTransform m_to;
  btVector3 m_velocity;  // [m/s]
  btVector3 m_spin;      // [rad/s]
  btScalar m_timeStep;   // [s], the whole step
  btScalar m_time = 0;   // of it, gone [s]
};

// NOLINTEND(modernize-use-nodiscard)

#endif
