// A cable for Bullet: massless and inextensible, with restitution, between two bodies or a body and
// the world. It only ever pulls, through one constraint row with limits [0, infinity), and bounces
// as Bullet's contacts do: gap rate after the step = -restitution * gap rate before it, measured at
// the pivots, not at the centres. Header only; for either precision of Bullet.
//
//   btCableConstraint* cable = new btCableConstraint(*load, pivotInLoad, pointInWorld, length);
//   cable->setRestitution(btScalar(0.7));
//   world->addConstraint(cable);  // and step as ever

#ifndef TAUTLINE_BT_CABLE_CONSTRAINT_H
#define TAUTLINE_BT_CABLE_CONSTRAINT_H

#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include "tautline/bullet/btCableLine.h"
#include "tautline/bullet/btCablesInStep.h"
#include "tautline/cable_rule.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

class btCableConstraint : public btTypedConstraint {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// From `pivotInA` of `rbA` to `pivotInB` of `rbB`, each in its body's frame [m].
  btCableConstraint(btRigidBody& rbA, btRigidBody& rbB, const btVector3& pivotInA,
                    const btVector3& pivotInB, btScalar maxLength)
      // no type of Bullet's own: its debug drawer casts those to its own classes
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, rbA, rbB),
        m_pivotInA(pivotInA),
        m_pivotInB(pivotInB) {
    m_rule.length = maxLength;
    enableFeedback(true);  // or getAppliedImpulse asserts
  }

  /// From `pivotInA` of `rbA`, in its frame, to the point `pivotInWorld` [m].
  btCableConstraint(btRigidBody& rbA, const btVector3& pivotInA, const btVector3& pivotInWorld,
                    btScalar maxLength)
      : btCableConstraint(rbA, getFixedBody(), pivotInA, pivotInWorld, maxLength) {}

  /// Longest distance of the pivots [m], >= 0.
  void setMaxLength(btScalar maxLength) { m_rule.length = maxLength; }
  btScalar getMaxLength() const { return m_rule.length; }

  /// Newton's coefficient e [-], in [0, 1]; 0 unless set.
  void setRestitution(btScalar restitution) { m_rule.restitution = restitution; }
  btScalar getRestitution() const { return m_rule.restitution; }

  /// Impacts slower than this do not rebound [m/s]; 0 unless set, where Bullet's contacts have 0.2.
  void setRestitutionThreshold(btScalar threshold) { m_rule.threshold = threshold; }
  btScalar getRestitutionThreshold() const { return m_rule.threshold; }

  /// Rebound with e^2 of the energy of the arrival at zero gap, so that a falling load rises to e^2
  /// of its height. The rates before and after the step then differ from e by gravity's part of
  /// them. Off unless set.
  void setReboundByEnergy(bool byEnergy) { m_rule.by_energy = byEnergy; }
  bool getReboundByEnergy() const { return m_rule.by_energy; }

  /// Most iterations of the solver in a step in which another cable of one of its bodies may pull
  /// too, if more than the world's: while all of them rest, and if one bounces. The world's 10
  /// leave elastic cables with more energy than they took, and close ones without rest. Joints and
  /// contacts keep the world's.
  void setSharedIterations(int atRest, int ifBouncing) {
    m_iterationsAtRest = atRest;
    m_iterationsIfBouncing = ifBouncing;
  }

  void setPivotA(const btVector3& pivotA) { m_pivotInA = pivotA; }
  void setPivotB(const btVector3& pivotB) { m_pivotInB = pivotB; }
  const btVector3& getPivotInA() const { return m_pivotInA; }
  const btVector3& getPivotInB() const { return m_pivotInB; }

  /// The maximum length minus the distance of the pivots, now [m]; negative is overstretch.
  btScalar getGap() const { return m_rule.length - getLine().m_distance; }

  /// The gap's rate, now [m/s]; negative while the pivots move apart.
  btScalar getGapRate() const { return getLine().rate(m_rbA, m_rbB); }

  /// True if the cable pulled in the last step; else it was slack.
  bool isTaut() const { return m_appliedImpulse > 0; }

  /// Tension of the last step [N]; its mean if there was an impact. `timeStep` is that step's [s].
  btScalar getTension(btScalar timeStep) const { return m_appliedImpulse / timeStep; }

  /// BT_CONSTRAINT_ERP: part of the overstretch that a step takes out while the cable rests taut
  /// [-], 0.2 unless set. BT_CONSTRAINT_CFM: as in Bullet's joints, the world's unless set. A cable
  /// has one axis, and one of each: the parameters of limits (STOP) are the same.
  void setParam(int num, btScalar value, int /*axis*/ = -1) override {
    if (num == BT_CONSTRAINT_ERP || num == BT_CONSTRAINT_STOP_ERP) {
      m_rule.erp = value;
    } else if (num == BT_CONSTRAINT_CFM || num == BT_CONSTRAINT_STOP_CFM) {
      m_cfm = value;
    } else {
      btAssertConstrParams(false);
    }
  }
  btScalar getParam(int num, int /*axis*/ = -1) const override {
    if (num == BT_CONSTRAINT_ERP || num == BT_CONSTRAINT_STOP_ERP) {
      return m_rule.erp;
    }
    btAssertConstrParams(num == BT_CONSTRAINT_CFM || num == BT_CONSTRAINT_STOP_CFM);
    return btMax(m_cfm, btScalar(0));
  }

  /// The next three are the solver's. It calls the first of all constraints, then the second of
  /// all, then the third.
  void buildJacobian() override {
    if (m_rows > 0) {
      m_rule.pulled(m_appliedImpulse);  // the impulse of the last step, which is lost after this
    }
    const btScalar gap = getGap();
    const bool near = m_byEvents ? m_rule.held() : m_rule.touches(gap);
    if (!near) {
      m_rule.release();
    }
    // pivots that coincide have no direction to be pulled in
    m_rows = near && gap < m_rule.length ? 1 : 0;
    if (m_rows > 0 && isEnabled()) {
      const bool bounces = !m_byEvents && m_rule.may_bounce(getGapRate());
      btCablesInStep::ofThisThread().add(m_rbA, m_rbB, bounces);
    }
  }
  void getInfo1(btConstraintInfo1* info) override {
    int iterations = -1;  // the world's
    if (m_rows > 0 && btCablesInStep::ofThisThread().share(m_rbA, m_rbB)) {
      const bool bounces = btCablesInStep::ofThisThread().bounces(m_rbA, m_rbB);
      iterations = bounces ? m_iterationsIfBouncing : m_iterationsAtRest;
    }
    setOverrideNumSolverIterations(iterations);
    info->m_numConstraintRows = m_rows;
    info->nub = 0;
  }
  void getInfo2(btConstraintInfo2* info) override {
    const btCableLine line = getLine();
    for (int axis = 0; axis < 3; ++axis) {
      info->m_J1linearAxis[axis] = line.m_towards[axis];
      info->m_J1angularAxis[axis] = line.m_momentA[axis];
      info->m_J2linearAxis[axis] = -line.m_towards[axis];
      info->m_J2angularAxis[axis] = -line.m_momentB[axis];
    }
    const tautline::CableRule<btScalar>::Row row = askedRow(line, 1 / info->fps);
    info->m_constraintError[0] = row.rate;
    info->m_lowerLimit[0] = 0;
    info->m_upperLimit[0] = row.acts ? SIMD_INFINITY : btScalar(0);
    if (m_cfm >= 0) {
      info->cfm[0] = m_cfm;
    }
  }

 private:
  friend class btCableStepper;

  btCableLine getLine() const {
    return btCableLine(m_rbA.getCenterOfMassTransform(), m_pivotInA,
                       m_rbB.getCenterOfMassTransform(), m_pivotInB);
  }

  tautline::CableRule<btScalar>::Row askedRow(const btCableLine& line, btScalar timeStep) {
    tautline::CableRule<btScalar>::Start start;
    start.gap = m_rule.length - line.m_distance;
    start.rate = line.rate(m_rbA, m_rbB);
    start.fall = -timeStep * line.acceleration(m_rbA, m_rbB);
    start.dt = timeStep;
    if (m_byEvents) {
      start.dt = btMax(timeStep, m_eventStep);  // no faster in a short part
      return m_rule.rest(start);
    }
    const tautline::CableRule<btScalar>::Row row = m_rule.step(start);
    if (row.acts && !m_rule.held()) {
      // a load that bounces slower than Bullet's sleeping threshold does not sleep
      m_rbA.activate();
      m_rbB.activate();
    }
    return row;
  }

  btVector3 m_pivotInA;
  btVector3 m_pivotInB;
  tautline::CableRule<btScalar> m_rule;
  btScalar m_cfm = -1;  // negative: the world's
  int m_iterationsAtRest = 50;
  int m_iterationsIfBouncing = 1000;
  int m_rows = 0;            // of the last step
  bool m_byEvents = false;   // while btCableStepper steps, which sees to the impacts itself
  btScalar m_eventStep = 0;  // its whole step [s]
};

// NOLINTEND(modernize-use-nodiscard)

#endif
