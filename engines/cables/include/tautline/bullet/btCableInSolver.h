// What a cable of btCableConstraint.h is to Bullet's solver: where it hangs, its rule, and its part
// in the solve. How that goes is in btCableSolve.h.

#ifndef TAUTLINE_BT_CABLE_IN_SOLVER_H
#define TAUTLINE_BT_CABLE_IN_SOLVER_H

#include <BulletDynamics/ConstraintSolver/btSolverBody.h>
#include <BulletDynamics/ConstraintSolver/btTypedConstraint.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "tautline/bullet/btCableLine.h"
#include "tautline/bullet/btCablesOnBody.h"
#include "tautline/cable_block.h"
#include "tautline/cable_rule.h"
#include "tautline/cable_spring.h"
#include "tautline/force_trend.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// A force [N] and a torque [N m] on a body, in the world; none unless set.
struct btPush {
  btVector3 m_force = btVector3(0, 0, 0);
  btVector3 m_torque = btVector3(0, 0, 0);

  btPush() = default;
  explicit btPush(const btRigidBody& body)
      : m_force(body.getTotalForce()), m_torque(body.getTotalTorque()) {}
};

/// What btStepWithCables remembers of the user's forces on a body.
struct btPushes {
  struct Trend {
    tautline::ForceTrend<btScalar> m_force;
    tautline::ForceTrend<btScalar> m_torque;

    void next(btPush& push, btScalar timeStep) {
      m_force.next(push.m_force.m_floats, timeStep);
      m_torque.next(push.m_torque.m_floats, timeStep);
    }
  };

  void forget() { m_given = m_added = Trend(); }

  Trend m_given;            // before the steps
  Trend m_added;            // by tick callbacks, in the parts
  btPush m_last;            // that tick callbacks added in the last part
  btPush m_seen;            // all that acted in the last part, with gravity
  bool m_isSeen = false;    // in this part
  bool m_isStruck = false;  // by an impact since
};

/// Make a btCableConstraint.
class btCableInSolver : public btTypedConstraint {
 public:
  BT_DECLARE_ALIGNED_ALLOCATOR();

  ~btCableInSolver() override {
    btCablesOnBody::leave(m_rbA, m_onA, this);
    btCablesOnBody::leave(m_rbB, m_onB, this);
  }
  btCableInSolver(const btCableInSolver&) = delete;
  btCableInSolver& operator=(const btCableInSolver&) = delete;

  /// The next four are the solver's: it calls the first of all constraints, then the second of all,
  /// then the third of those with rows, and the last of all in each iteration.
  void buildJacobian() override;
  void getInfo1(btConstraintInfo1* info) override;  // called by the solver: how many rows
  void getInfo2(btConstraintInfo2* info) override;  // called by the solver: the rows
  /// Called by the solver in each iteration.
  void solveConstraintObsolete(btSolverBody& bodyA, btSolverBody& bodyB,
                               btScalar timeStep) override;

 protected:
  friend class btCableStepper;
  friend class btForcesOfStep;
  typedef tautline::CableRule<btScalar> Rule;

  btCableInSolver(btRigidBody& rbA, btRigidBody& rbB, const btVector3& pivotInA,
                  const btVector3& pivotInB, btScalar maxLength)
      // no type of Bullet's own: its debug drawer casts those to its own classes
      : btTypedConstraint(MAX_CONSTRAINT_TYPE, rbA, rbB),
        m_pivotInA(pivotInA),
        m_pivotInB(pivotInB),
        m_onA(btCablesOnBody::enter(rbA, this)),
        m_onB(btCablesOnBody::enter(rbB, this)) {
    m_rule.length = maxLength;
    enableFeedback(true);  // or getAppliedImpulse asserts
  }

  void wake() {
    m_rbA.activate(true);
    m_rbB.activate(true);
  }
  bool hasBroken() const {
    return btFabs(m_appliedImpulse) >= getBreakingImpulseThreshold() ||
           tautTension() >= m_breakingTension;
  }
  /// The part of the last step's impulse that impacts had [N s].
  btScalar impactImpulse() const { return btMin(m_ofImpacts, m_appliedImpulse); }
  /// Tension outside of impacts, in the last step [N]; 0 if the cable was not taut there.
  btScalar tautTension() const {
    return m_tautTime > 0 ? (m_appliedImpulse - impactImpulse()) / m_tautTime : btScalar(0);
  }
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
  void askElastic(const Rule::Start& at);
  void askInextensible(const Rule::Start& at);
  void setRow(const tautline::CableSpring::Row& row);
  void tookImpulse();  // of the last step
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
  tautline::CableSpring m_spring;  // of an elastic cable; the rule has its length alone
  btScalar m_cfm = 0;
  btScalar m_breakingTension = SIMD_INFINITY;  // [N]

  // of the step
  btCableLine m_line = getLine();
  Rule::Row m_row = {false, 0};
  double m_compliance = 0;       // of the row [1/kg]
  btScalar m_correction = 0;     // [m]
  btScalar m_aimedDistance = 0;  // of the pivots, by it [m]
  btScalar m_inverseMass = 0;    // [1/kg]
  btScalar m_ofImpacts = 0;      // so much of its impulse, or all of it if that is less [N s]
  btScalar m_tautTime = 0;       // that its other impulse acted for [s]
  double m_change = 0;           // of its impulse, in an iteration [N s]
  bool m_near = false;           // its gap may need a row, or its length changes
  bool m_fresh = false;          // near, and not gathered yet
  bool m_solved = false;         // its leader was called
  bool m_asRow = false;          // for a solver that knows rows alone
  btCableInSolver* m_leader = nullptr;

  // of the leader
  std::vector<btCableInSolver*> m_together;
  std::vector<btCableInSolver*> m_pulling;   // those of them that have a row
  std::vector<const btRigidBody*> m_slowed;  // by slowTurning
  tautline::CableBlock m_block{SIMD_EPSILON};
  bool m_begun = false;

  // while btCableStepper steps, which sees to the impacts itself
  bool m_byEvents = false;
  btScalar m_eventStep = 0;  // its whole step [s]
  btPushes m_pushesOnA;
  btPushes m_pushesOnB;
  int m_stepsOutOfParts = 0;
  bool m_drivenIsKnown = false;     // the next two, of its last step
  btScalar m_drivenLengthRate = 0;  // [m/s]
  btVector3 m_driven = {0, 0, 0};   // of the pivots by hooks, A's relative to B's [m/s]
};

// NOLINTEND(modernize-use-nodiscard)

#endif
