// Which cables may pull at one body in a step: their rows depend on each other, and need more of
// the solver's iterations than a row alone. Bullet has no list of a body's constraints (its
// btRigidBody::getConstraintRef lists those whose bodies do not collide), so the cables count
// themselves.

#ifndef TAUTLINE_BT_CABLES_IN_STEP_H
#define TAUTLINE_BT_CABLES_IN_STEP_H

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <unordered_map>

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// The cables of one call of the solver: all are added, then all ask.
class btCablesInStep {
 public:
  /// One per thread, for worlds may be stepped side by side. A solver that builds the rows of one
  /// world in several threads finds less sharing than there is.
  static btCablesInStep& ofThisThread() {
    static thread_local btCablesInStep cables;
    return cables;
  }

  void add(const btRigidBody& a, const btRigidBody& b, bool bounces) {
    if (m_asked) {
      m_bodies.clear();  // of the step before
      m_asked = false;
    }
    for (const btRigidBody* body : {&a, &b}) {
      // what does not move couples nothing
      if (body->getInvMass() > 0) {
        Pulled& pulled = m_bodies[body];
        ++pulled.m_cables;
        pulled.m_bounces = pulled.m_bounces || bounces;
      }
    }
  }

  /// True if `a` or `b` has another cable.
  bool share(const btRigidBody& a, const btRigidBody& b) {
    m_asked = true;
    return pulled(a).m_cables > 1 || pulled(b).m_cables > 1;
  }
  /// True if a cable of `a` or `b` bounces.
  bool bounces(const btRigidBody& a, const btRigidBody& b) const {
    return pulled(a).m_bounces || pulled(b).m_bounces;
  }

 private:
  struct Pulled {
    int m_cables;
    bool m_bounces;
  };

  Pulled pulled(const btRigidBody& body) const {
    const auto found = m_bodies.find(&body);
    return found != m_bodies.end() ? found->second : Pulled{0, false};
  }

  std::unordered_map<const btRigidBody*, Pulled> m_bodies;
  bool m_asked = false;
};

// NOLINTEND(modernize-use-nodiscard)

#endif
