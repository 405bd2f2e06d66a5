// The user's forces in a step of Bullet that is split at impacts. Bullet forgets the forces on a
// body after each part; here they act over the whole step, wherever the user gives them: before the
// step, they are given again before each part; in a tick callback, the cables see them as the part
// is solved, and the next part is expected to have the same ones.

#ifndef TAUTLINE_BT_FORCES_OF_STEP_H
#define TAUTLINE_BT_FORCES_OF_STEP_H

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <LinearMath/btTransformUtil.h>

#include <vector>

#include "tautline/bullet/btCableInSolver.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// For the length of one btStepWithCables.
class btForcesOfStep {
 public:
  /// Of a step of `timeStep` [s] with these cables, all of which outlive it.
  btForcesOfStep(btDiscreteDynamicsWorld* world, btCableInSolver* const* cables, int numCables,
                 btScalar timeStep)
      : m_world(world) {
    for (int index = 0; index < numCables; ++index) {
      btCableInSolver& cable = *cables[index];
      m_ends.push_back(End{&cable.m_rbA, &cable.m_pushesOnA});
      m_ends.push_back(End{&cable.m_rbB, &cable.m_pushesOnB});
    }
    forgetBeforeImpacts();
    for (const End& end : m_ends) {
      if (!end.m_body->isStaticOrKinematicObject() && find(end.m_body) == nullptr) {
        m_pushed.push_back(Pushed{end.m_body, btPush(*end.m_body), *end.m_pushes});
        Pushed& one = m_pushed.back();
        one.m_known.m_given.next(one.m_given, timeStep);
      }
    }
    const btAlignedObjectArray<btRigidBody*>& bodies = world->getNonStaticRigidBodies();
    for (int index = 0; index < bodies.size(); ++index) {
      btRigidBody* body = bodies[index];
      if ((!body->getTotalForce().isZero() || !body->getTotalTorque().isZero()) &&
          find(body) == nullptr) {
        m_pushed.push_back(Pushed{body, btPush(*body), btPushes()});
      }
    }
    expect();
  }
  btForcesOfStep(const btForcesOfStep&) = delete;
  btForcesOfStep& operator=(const btForcesOfStep&) = delete;
  /// Bullet's world forgets the forces.
  ~btForcesOfStep() {
    for (const End& end : m_ends) {
      const Pushed* one = find(end.m_body);
      if (one != nullptr) {
        const bool isStruck = end.m_pushes->m_isStruck;  // at the end of the last part
        *end.m_pushes = one->m_known;
        end.m_pushes->m_isStruck = isStruck;
      }
    }
  }

  /// Gives all bodies the forces that the next part is expected to have.
  void expect() const {
    for (const Pushed& one : m_pushed) {
      set(one, one.m_known.m_last);
    }
  }
  /// Before a part: takes away what a tick callback will add itself.
  void withdraw() {
    forgetBeforeImpacts();
    for (const Pushed& one : m_pushed) {
      set(one, btPush());
    }
    for (const End& end : m_ends) {
      end.m_pushes->m_isSeen = false;
    }
  }
  /// After a part: what its tick callbacks added.
  void learn(btScalar timeStep) {
    for (Pushed& one : m_pushed) {
      for (const End& end : m_ends) {
        if (end.m_body == one.m_body && end.m_pushes->m_isSeen) {
          end.m_pushes->m_isSeen = false;
          const btPush value = added(one, end.m_pushes->m_seen);
          one.m_known.m_last = value;
          one.m_known.m_added.next(one.m_known.m_last, timeStep);
          push(one, value, timeStep);
          break;
        }
      }
    }
  }

 private:
  struct End {
    btRigidBody* m_body;
    btPushes* m_pushes;
  };
  struct Pushed {
    btRigidBody* m_body;
    btPush m_given;  // before the step, or its mean over it
    btPushes m_known;
  };

  void set(const Pushed& one, const btPush& more) const {
    // a tick callback may have taken it out of the world
    const btAlignedObjectArray<btRigidBody*>& bodies = m_world->getNonStaticRigidBodies();
    if (bodies.findLinearSearch(one.m_body) < bodies.size()) {
      one.m_body->clearForces();
      one.m_body->applyCentralForce(one.m_given.m_force + more.m_force);
      one.m_body->applyTorque(one.m_given.m_torque + more.m_torque);
    }
  }
  /// Of all that acted, with gravity; nothing if it is rounding.
  static btPush added(const Pushed& one, const btPush& all) {
    const btRigidBody& body = *one.m_body;
    const btScalar mass = body.getInvMass() > 0 ? 1 / body.getInvMass() : btScalar(0);
    const btVector3 weight = body.getGravity() * mass * body.getLinearFactor();
    const btVector3 given = one.m_given.m_force * body.getLinearFactor();
    const btVector3 torque = one.m_given.m_torque * body.getAngularFactor();
    btPush result;
    result.m_force = all.m_force - weight - given;
    result.m_torque = all.m_torque - torque;
    const btScalar rounding = 8 * SIMD_EPSILON;
    if (result.m_force.length() <= rounding * (weight.length() + given.length())) {
      result.m_force.setZero();
    }
    if (result.m_torque.length() <= rounding * torque.length()) {
      result.m_torque.setZero();
    }
    return result;
  }
  /// It had `value` for a part, and gets the rest of the mean.
  static void push(const Pushed& one, const btPush& value, btScalar timeStep) {
    const btVector3 force = one.m_known.m_last.m_force - value.m_force;
    const btVector3 torque = one.m_known.m_last.m_torque - value.m_torque;
    if (force.isZero() && torque.isZero()) {
      return;
    }
    btRigidBody& body = *one.m_body;
    const btVector3 velocity = timeStep * body.getInvMass() * force;
    const btVector3 spin = timeStep * (body.getInvInertiaTensorWorld() * torque);
    btTransform pose;
    btTransformUtil::integrateTransform(body.getCenterOfMassTransform(), velocity, spin, timeStep,
                                        pose);
    body.setCenterOfMassTransform(pose);
    body.setLinearVelocity(body.getLinearVelocity() + velocity);
    body.setAngularVelocity(body.getAngularVelocity() + spin);
  }
  Pushed* find(const btRigidBody* body) {
    for (Pushed& one : m_pushed) {
      if (one.m_body == body) {
        return &one;
      }
    }
    return nullptr;
  }
  void forgetBeforeImpacts() {
    for (const End& end : m_ends) {
      if (end.m_pushes->m_isStruck) {
        for (const End& other : m_ends) {
          if (other.m_body == end.m_body) {
            other.m_pushes->forget();
          }
        }
        Pushed* one = find(end.m_body);
        if (one != nullptr) {
          one->m_known.forget();
        }
        end.m_pushes->m_isStruck = false;
      }
    }
  }

  btDiscreteDynamicsWorld* m_world;
  std::vector<End> m_ends;
  std::vector<Pushed> m_pushed;
};

// NOLINTEND(modernize-use-nodiscard)

#endif
