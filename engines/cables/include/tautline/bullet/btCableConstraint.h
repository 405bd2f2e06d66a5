// A cable for Bullet: massless and inextensible, with restitution, between two bodies or a body and
// the world. It only ever pulls, and bounces as Bullet's contacts do: gap rate after the step =
// -restitution * gap rate before it, measured at the pivots, not at the centres. Header only; for
// either precision of Bullet. docs/cables.md says what it guarantees.
//
//   btCableConstraint* cable = new btCableConstraint(*load, pivotInLoad, pointInWorld, length);
//   cable->setRestitution(btScalar(0.7));
//   world->addConstraint(cable);  // and step as ever

#ifndef TAUTLINE_BT_CABLE_CONSTRAINT_H
#define TAUTLINE_BT_CABLE_CONSTRAINT_H

#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "tautline/bullet/btCableLine.h"
#include "tautline/bullet/btCablesOnBody.h"
#include "tautline/cable_block.h"
#include "tautline/cable_rule.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

class btMultiBodyLinkCollider;

/// A cable between two bodies, or a body and the world: it pulls at its length, never pushes, and
/// rebounds.
class btCableConstraint : public btTypedConstraint {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  /// From `pivotInA` of `rbA` to `pivotInB` of `rbB`, each in its body's frame [m].
  btCableConstraint(btRigidBody& rbA, btRigidBody& rbB, const btVector3& pivotInA,
                    const btVector3& pivotInB, btScalar maxLength)
      // no type of Bullet's own: its debug drawer casts those to its own classes
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, rbA, rbB),
        m_pivotInA(pivotInA),
        m_pivotInB(pivotInB),
        m_onA(btCablesOnBody::enter(rbA, this)),
        m_onB(btCablesOnBody::enter(rbB, this)) {
    m_rule.length = positive(maxLength);
    enableFeedback(true);  // or getAppliedImpulse asserts
  }

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

  ~btCableConstraint() override {
    btCablesOnBody::leave(m_rbA, m_onA, this);
    btCablesOnBody::leave(m_rbB, m_onB, this);
  }
  btCableConstraint(const btCableConstraint&) = delete;
  btCableConstraint& operator=(const btCableConstraint&) = delete;

  /// Longest distance of the pivots [m], >= 0. Another length wakes the bodies.
  void setMaxLength(btScalar maxLength) {
    if (maxLength != m_rule.length) {
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

  void setPivotA(const btVector3& pivotA) { m_pivotInA = pivotA; }  // [m], in the frame of A
  void setPivotB(const btVector3& pivotB) { m_pivotInB = pivotB; }  // [m], in the frame of B
  const btVector3& getPivotInA() const { return m_pivotInA; }       // [m]
  const btVector3& getPivotInB() const { return m_pivotInB; }       // [m]

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

  /// False as well once the impulse of a step has reached setBreakingImpulseThreshold [N s]; asked
  /// as a btTypedConstraint, from the next step on.
  bool isEnabled() const { return btTypedConstraint::isEnabled() && !hasBroken(); }
  /// True mends it, if an impulse has broken it.
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

  /// The next four are the solver's: it calls the first of all constraints, then the second of all,
  /// then the third of those with rows, and the last of all in each iteration.
  void buildJacobian() override;
  void getInfo1(btConstraintInfo1* info) override;  // called by the solver: how many rows
  void getInfo2(btConstraintInfo2* info) override;  // called by the solver: the rows
  /// Called by the solver in each iteration.
  void solveConstraintObsolete(btSolverBody& bodyA, btSolverBody& bodyB,
                               btScalar timeStep) override;

 private:
  friend class btCableStepper;
  typedef tautline::CableRule<btScalar> Rule;

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

  void wake() {
    m_rbA.activate(true);
    m_rbB.activate(true);
  }
  bool hasBroken() const { return btFabs(m_appliedImpulse) >= getBreakingImpulseThreshold(); }
  btCableLine getLine() const {
    return btCableLine(m_rbA.getCenterOfMassTransform(), m_pivotInA,
                       m_rbB.getCenterOfMassTransform(), m_pivotInB);
  }

  btCableLine getLineBefore(btScalar timeStep) const;

  // of the leader: the cables that pull at each other's bodies, and their solve
  class Overstretch;
  void gather();
  void gatherFrom(const btCablesOnBody& list);
  void begin(btSolverBody* pool, btScalar timeStep);
  void fillBlock(btSolverBody* pool);
  void slowTurning(btSolverBody* pool, btScalar timeStep);
  void find(btSolverBody* pool, btScalar timeStep, bool first);

  // of one cable
  Rule::Start startOf(btSolverBody* pool, btScalar timeStep) const;
  void ask(const Rule::Start& at);
  void fill(tautline::CableBlock::Row& row) const;
  void move(btSolverBody* pool, const tautline::CableBlock::Row& row, double push);
  btScalar rateNow(btSolverBody* pool) const;
  void apply(btSolverBody* pool, const tautline::CableBlock::Row& row, double impulse,
             btScalar timeStep);

  btVector3 m_pivotInA;
  btVector3 m_pivotInB;
  std::shared_ptr<btCablesOnBody> m_onA;
  std::shared_ptr<btCablesOnBody> m_onB;
  Rule m_rule;
  btScalar m_cfm = 0;

  // of the step
  btCableLine m_line = getLine();
  Rule::Row m_row = {false, 0};
  btScalar m_correction = 0;     // [m]
  btScalar m_aimedDistance = 0;  // of the pivots, by it [m]
  btScalar m_inverseMass = 0;    // [1/kg]
  double m_change = 0;           // of its impulse, in an iteration [N s]
  bool m_near = false;           // its gap may need a row, or its length changes
  bool m_fresh = false;          // near, and not gathered yet
  bool m_solved = false;         // its leader was called
  bool m_asRow = false;          // for a solver that knows rows alone
  btCableConstraint* m_leader = nullptr;

  // of the leader
  std::vector<btCableConstraint*> m_together;
  std::vector<btCableConstraint*> m_pulling;  // those of them that have a row
  std::vector<const btRigidBody*> m_slowed;   // by slowTurning
  tautline::CableBlock m_block{SIMD_EPSILON};
  bool m_begun = false;

  // while btCableStepper steps, which sees to the impacts itself
  bool m_byEvents = false;
  btScalar m_eventStep = 0;  // its whole step [s]
  int m_stepsOutOfParts = 0;
};

// NOLINTEND(modernize-use-nodiscard)

#include "tautline/bullet/btCableSolve.h"

#endif
