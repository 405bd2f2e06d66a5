// A cable for Bullet: massless, inextensible with restitution or elastic, between two bodies or a
// body and the world. It only ever pulls, and bounces as Bullet's contacts do: gap rate after the
// step = -restitution * gap rate before it, measured at the pivots, not at the centres. Header
// only; for either precision of Bullet. docs/guides/cables.md says what it guarantees.
//
//   btCableConstraint* cable = new btCableConstraint(*load, pivotInLoad, pointInWorld, length);
//   cable->setRestitution(btScalar(0.7));
//   world->addConstraint(cable);  // and step as ever

#ifndef TAUTLINE_BT_CABLE_CONSTRAINT_H
#define TAUTLINE_BT_CABLE_CONSTRAINT_H

#include "tautline/bullet/btCableInSolver.h"
#include "tautline/bullet/btCableRow.h"
#include "tautline/bullet/btCableSolve.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

class btMultiBodyLinkCollider;

/// A cable between two bodies, or a body and the world: it pulls at its length, never pushes, and
/// rebounds.
class btCableConstraint : public btCableInSolver {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// From `pivotInA` of `rbA` to `pivotInB` of `rbB`, each in its body's frame [m].
  btCableConstraint(btRigidBody& rbA, btRigidBody& rbB, const btVector3& pivotInA,
                    const btVector3& pivotInB, btScalar maxLength)
      : btCableInSolver(rbA, rbB, pivotInA, pivotInB, positive(maxLength)) {}

  /// From `pivotInA` of `rbA`, in its frame, to the point `pivotInWorld` [m].
  btCableConstraint(btRigidBody& rbA, const btVector3& pivotInA, const btVector3& pivotInWorld,
                    btScalar maxLength)
      : btCableConstraint(rbA, getFixedBody(), pivotInA, pivotInWorld, maxLength) {}

  /// A link of a btMultiBody cannot be an end: constraints of this kind know rigid bodies alone.
  /// Hold a small body to the link with a btMultiBodyPoint2Point, and hang the cable there.
  btCableConstraint(btMultiBodyLinkCollider& link, const btVector3& pivotInLink,
                    const btVector3& pivotInWorld, btScalar maxLength) = delete;
  btCableConstraint(btMultiBodyLinkCollider& link, btRigidBody& rbB, const btVector3& pivotInLink,
                    const btVector3& pivotInB, btScalar maxLength) = delete;
  btCableConstraint(btRigidBody& rbA, btMultiBodyLinkCollider& link, const btVector3& pivotInA,
                    const btVector3& pivotInLink, btScalar maxLength) = delete;

  /// Longest distance of the pivots [m], >= 0. Another length wakes the bodies.
  void setMaxLength(btScalar maxLength) {
    if (maxLength != m_rule.length) {
      m_spring.set_length(m_rule.length, positive(maxLength));
      m_rule.length = positive(maxLength);
      wake();
    }
  }
  btScalar getMaxLength() const { return m_rule.length; }  // [m], at this instant

  /// A winch: the rate at which steps from now on pay the cable out, or, if negative, haul it in,
  /// down to a length of 0 [m/s]; 0 unless set. An impact counts the speed relative to the length.
  /// While it runs its bodies do not fall asleep.
  void setMaxLengthRate(btScalar rate) {
    m_rule.length_rate = finite(rate);
    wake();
  }
  btScalar getMaxLengthRate() const { return m_rule.length_rate; }  // [m/s], > 0: pays out

  /// Newton's coefficient e [-]; 0 unless set. What is outside [0, 1] asserts, and is clamped.
  void setRestitution(btScalar restitution) { m_rule.restitution = part(restitution); }
  btScalar getRestitution() const { return m_rule.restitution; }  // [-], 0 to 1

  /// Impacts slower than this do not rebound [m/s], >= 0; 0 unless set, where Bullet's contacts
  /// have 0.2.
  void setRestitutionThreshold(btScalar threshold) { m_rule.threshold = positive(threshold); }
  btScalar getRestitutionThreshold() const { return m_rule.threshold; }  // [m/s]

  /// Rebound with e^2 of the energy of the arrival at zero gap, so that a falling load rises to e^2
  /// of its height. The rates before and after the step then differ from e by gravity's part of
  /// them. Off unless set.
  void setReboundByEnergy(bool byEnergy) { m_rule.by_energy = byEnergy; }
  bool getReboundByEnergy() const { return m_rule.by_energy; }  // off by default

  /// The speed at which overstretch is taken out, at most, unless the ends themselves are faster
  /// [m/s], >= 0; 1 unless set.
  void setMaxCorrectionSpeed(btScalar speed) { m_rule.correction_speed = positive(speed); }
  btScalar getMaxCorrectionSpeed() const { return m_rule.correction_speed; }  // [m/s]

  /// Lets the cable stretch beyond its maximum length, by the law and the scheme of
  /// tautline/cable_spring.h; inextensible unless set, or without stiffness. The restitution, its
  /// threshold, the rebound by energy, ERP and CFM say nothing to an elastic cable: it has no
  /// impacts, and its snap is in getTension, getTautTension and setBreakingTension. A law with a
  /// `problem` asserts, and changes nothing. Wakes the bodies.
  void setElasticity(const tautline::CableElasticity& elasticity) {
    btAssert(elasticity.problem() == nullptr);
    if (elasticity.problem() == nullptr) {
      m_spring.set(elasticity);
      m_compliance = 0;
      wake();
    }
  }
  const tautline::CableElasticity& getElasticity() const { return m_spring.law(); }  // as set

  /// The largest tension of a step since an elastic cable became stretched last [N]; 0 if
  /// inextensible.
  btScalar getPeakTension() const {
    return btMax(static_cast<btScalar>(m_spring.peak()),
                 m_spring.is_elastic() ? tautTension() : btScalar(0));
  }

  /// Where the ends are, in their bodies' frames [m]. Another place wakes the bodies.
  void setPivotA(const btVector3& pivotA) { setPivot(m_pivotInA, pivotA); }
  void setPivotB(const btVector3& pivotB) { setPivot(m_pivotInB, pivotB); }  // the same at B
  const btVector3& getPivotInA() const { return m_pivotInA; }                // [m]
  const btVector3& getPivotInB() const { return m_pivotInB; }                // [m]

  /// The pivots in the world, now [m].
  btVector3 getPivotAInWorld() const { return m_rbA.getCenterOfMassTransform() * m_pivotInA; }
  /// Where the end at B is [m], in the world.
  btVector3 getPivotBInWorld() const { return m_rbB.getCenterOfMassTransform() * m_pivotInB; }

  /// The maximum length minus the distance of the pivots, now [m]; negative is overstretch.
  btScalar getGap() const { return m_rule.length - getLine().m_distance; }

  /// The gap's rate, now [m/s]; negative while the pivots move apart faster than the cable is paid
  /// out.
  btScalar getGapRate() const { return getLine().rate(m_rbA, m_rbB) + m_rule.length_rate; }

  /// True if the cable pulled in the last step; else it was slack.
  bool isTaut() const { return m_appliedImpulse > 0; }

  /// Tension of the last step [N]; its mean if there was an impact. `timeStep` is that step's [s].
  btScalar getTension(btScalar timeStep) const { return m_appliedImpulse / timeStep; }

  /// The impulse of the last step's impacts [N s]: in a fixed step all of its impulse, if it or a
  /// cable that hangs together with it went taut there, or was jerked; by events that of the
  /// instants in which cables went taut.
  btScalar getImpactImpulse() const { return impactImpulse(); }

  /// Tension of the rest of the last step [N]: its mean over the time in which the cable was held
  /// taut. 0 where it was not, as in a fixed step with an impact.
  btScalar getTautTension() const { return tautTension(); }

  /// A tension outside of impacts, getTautTension, as large as this breaks the cable [N], >= 0;
  /// infinity unless set. It does not see impacts: where a cable that does not stretch goes taut,
  /// its tension has no largest value. setBreakingImpulseThreshold [N s] sees those.
  void setBreakingTension(btScalar tension) { m_breakingTension = positive(tension); }
  btScalar getBreakingTension() const { return m_breakingTension; }  // [N]

  /// False as well once the impulse of a step has reached setBreakingImpulseThreshold [N s], or its
  /// tension setBreakingTension; asked as a btTypedConstraint, from the next step on.
  bool isEnabled() const { return btTypedConstraint::isEnabled() && !hasBroken(); }
  /// True mends it, if it has broken.
  void setEnabled(bool enabled) {
    m_appliedImpulse = enabled && hasBroken() ? btScalar(0) : m_appliedImpulse;
    btTypedConstraint::setEnabled(enabled);
  }

  /// How many steps by events (btStepWithCables) ran out of parts and ended as a fixed step.
  int getStepsOutOfParts() const { return m_stepsOutOfParts; }

  /// BT_CONSTRAINT_ERP: part of the overstretch that a step takes out while the cable rests taut
  /// [-], in [0, 1], 0.2 unless set. BT_CONSTRAINT_CFM: as in Bullet's joints, 0 unless set. A
  /// cable has one axis, and one of each: the parameters of limits (STOP) are the same.
  void setParam(int num, btScalar value, int /*axis*/ = -1) override {
    if (num == BT_CONSTRAINT_ERP || num == BT_CONSTRAINT_STOP_ERP) {
      m_rule.erp = part(value);
    } else if (num == BT_CONSTRAINT_CFM || num == BT_CONSTRAINT_STOP_CFM) {
      m_cfm = positive(value);
    } else {
      btAssertConstrParams(false);
    }
  }
  /// What setParam set.
  btScalar getParam(int num, int /*axis*/ = -1) const override {
    if (num == BT_CONSTRAINT_ERP || num == BT_CONSTRAINT_STOP_ERP) {
      return m_rule.erp;
    }
    btAssertConstrParams(num == BT_CONSTRAINT_CFM || num == BT_CONSTRAINT_STOP_CFM);
    return m_cfm;
  }

 private:
  void setPivot(btVector3& pivot, const btVector3& to) {
    if (pivot != to) {
      pivot = to;
      m_spring.forget();
      wake();
    }
  }
  static btScalar finite(btScalar value) {
    btAssert(btFabs(value) < SIMD_INFINITY);  // neither is NaN
    return btFabs(value) < SIMD_INFINITY ? value : btScalar(0);
  }
  static btScalar positive(btScalar value) {
    btAssert(value >= 0);
    return value >= 0 ? value : btScalar(0);
  }
  static btScalar part(btScalar value) {
    btAssert(value >= 0 && value <= 1);
    return value >= 0 ? btMin(value, btScalar(1)) : btScalar(0);
  }
};

// NOLINTEND(modernize-use-nodiscard)

#endif
