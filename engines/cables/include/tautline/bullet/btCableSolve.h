// How Bullet's solver solves the cables of btCableConstraint.h.
//
// Bullet solves rows one after the other, 10 times, from nothing in every step. That is far from
// enough for cables in series: 1 kg over 1000 kg takes thousands of times. So a cable has no row of
// Bullet's. All cables that hang together are solved as one, exactly, in the place that Bullet's
// solver has for constraints that solve themselves, solveConstraintObsolete: once in each of its
// iterations, between its joints and its contacts, which in turn answer to the cables. The first of
// them that Bullet calls, their leader, does it for all.
//
// A solver that never calls there, such as btMLCPSolver, is given rows from the second step on.

#ifndef TAUTLINE_BT_CABLE_SOLVE_H
#define TAUTLINE_BT_CABLE_SOLVE_H

#include <LinearMath/btTransformUtil.h>

#include <algorithm>
#include <cmath>

#include "tautline/bullet/btCableInSolver.h"
#include "tautline/cable_overstretch.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// A body's place in the solver's pool; null if the solver does not move it.
inline btSolverBody* btSolverBodyOf(btSolverBody* pool, const btRigidBody& body) {
  return btCableMoves(body) ? pool + body.getCompanionId() : nullptr;
}

/// With the forces of the step, and with what rows have changed so far, or without.
inline btCableMotion btMotionInSolver(btSolverBody* pool, const btRigidBody& body, bool changed) {
  const btSolverBody* solved = btSolverBodyOf(pool, body);
  if (solved == nullptr) {
    return btCableMotion(body);
  }
  btCableMotion motion(solved->m_linearVelocity + solved->m_externalForceImpulse,
                       solved->m_angularVelocity + solved->m_externalTorqueImpulse);
  if (changed) {
    motion.m_velocity += solved->getDeltaLinearVelocity();
    motion.m_spin += solved->getDeltaAngularVelocity();
  }
  return motion;
}

inline btVector3 btVector3Of(const double* of) {
  return btVector3(static_cast<btScalar>(of[0]), static_cast<btScalar>(of[1]),
                   static_cast<btScalar>(of[2]));
}

/// Where a body is when a step begins. Bullet moves hooks (kinematic bodies) before it solves.
inline btTransform btPoseBefore(const btRigidBody& body, btScalar timeStep) {
  btTransform pose = body.getCenterOfMassTransform();
  if (body.isKinematicObject()) {
    const btTransform after = pose;
    btTransformUtil::integrateTransform(after, -body.getLinearVelocity(),
                                        -body.getAngularVelocity(), timeStep, pose);
  }
  return pose;
}

inline btCableLine btCableInSolver::getLineBefore(btScalar timeStep) const {
  return btCableLine(btPoseBefore(m_rbA, timeStep), m_pivotInA, btPoseBefore(m_rbB, timeStep),
                     m_pivotInB);
}

inline void btCableInSolver::buildJacobian() {
  if (m_near && !m_solved && !m_asRow) {
    m_asRow = true;  // this solver calls no constraint by itself
  }
  if (m_byEvents) {
    m_pushesOnA.m_seen = btPush(m_rbA);
    m_pushesOnB.m_seen = btPush(m_rbB);
    m_pushesOnA.m_isSeen = m_pushesOnB.m_isSeen = true;
  }
  if (m_row.acts) {
    tookImpulse();  // which is lost after this
  }
  if (hasBroken()) {
    setEnabled(false);
  }
  if (!btTypedConstraint::isEnabled()) {
    m_spring.forget();
  }
  m_drivenIsKnown &= m_byEvents;
  m_line = getLine();
  const btScalar gap = m_rule.length - m_line.m_distance;
  // a hook is where it is to be after the step already: how far it has come is seen in `begin`
  const bool hook = m_rbA.isKinematicObject() || m_rbB.isKinematicObject();
  if (!hook && !m_rule.touches(gap)) {
    m_rule.release();
  }
  const bool pulls =
      hook || m_spring.is_elastic() || (m_rule.touches(gap) && (!m_byEvents || m_rule.held()));
  const bool moves = btCableMoves(m_rbA) || btCableMoves(m_rbB);
  const bool enabled = btTypedConstraint::isEnabled();
  if (hook && enabled) {
    // Bullet does not wake what hangs on a kinematic body that starts to move, nor asks the cable
    m_rbA.activate();
    m_rbB.activate();
  }
  m_near = enabled && moves && (pulls || m_rule.length_rate != 0);
  m_ofImpacts = m_tautTime = 0;
  m_fresh = m_near;
  m_solved = false;
}

inline void btCableInSolver::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = m_near && m_asRow ? 1 : 0;
  info->nub = 0;
  if (m_fresh && !m_asRow) {
    gather();
  }
}

inline void btCableInSolver::gather() {
  m_together.clear();
  m_together.push_back(this);
  m_fresh = false;
  for (std::size_t next = 0; next < m_together.size(); ++next) {
    const btCableInSolver& one = *m_together[next];
    // what does not move couples nothing
    if (btCableMoves(one.m_rbA)) {
      gatherFrom(*one.m_onA);
    }
    if (btCableMoves(one.m_rbB)) {
      gatherFrom(*one.m_onB);
    }
  }
  for (btCableInSolver* cable : m_together) {
    cable->m_leader = this;
  }
  m_begun = false;
}

inline void btCableInSolver::gatherFrom(const btCablesOnBody& list) {
  for (btCableInSolver* cable : list.cables()) {
    if (cable->m_fresh && !cable->m_asRow) {
      cable->m_fresh = false;
      m_together.push_back(cable);
    }
  }
}

inline void btCableInSolver::solveConstraintObsolete(btSolverBody& bodyA, btSolverBody& bodyB,
                                                     btScalar timeStep) {
  if (m_near && !m_asRow && m_leader == this) {
    // one of them moves, and says where the solver has its bodies
    const bool byA = btCableMoves(m_rbA);
    btSolverBody* pool = byA ? &bodyA - m_rbA.getCompanionId() : &bodyB - m_rbB.getCompanionId();
    const bool first = !m_begun;
    if (first) {
      begin(pool, timeStep);
      m_begun = true;
    }
    find(pool, timeStep, first);
  }
}

inline void btCableInSolver::fillBlock(btSolverBody* pool) {
  m_block.begin(m_pulling.size());
  for (std::size_t index = 0; index < m_pulling.size(); ++index) {
    tautline::CableBlock::Row& row = m_block.row(index);
    m_pulling[index]->fill(row);
    const btRigidBody* bodies[] = {&m_pulling[index]->m_rbA, &m_pulling[index]->m_rbB};
    for (int side = 0; side < 2; ++side) {
      const btVector3 spin = btMotionInSolver(pool, *bodies[side], false).m_spin;
      for (int axis = 0; axis < 3; ++axis) {
        row.end[side].spin[axis] = spin[axis];
      }
    }
  }
  m_block.assemble();
}

/// The cables that pull, as tautline::move_out_of_overstretch needs them.
class btCableInSolver::Overstretch {
 public:
  Overstretch(btCableInSolver& leader, btSolverBody* pool, btScalar timeStep)
      : m_leader(leader), m_pool(pool), m_timeStep(timeStep) {}

  btScalar distance(std::size_t index) const { return at(index).m_line.m_distance; }
  btScalar distance_now(std::size_t index) const {
    return at(index).getLineBefore(m_timeStep).m_distance;
  }
  btScalar correction(std::size_t index) const { return at(index).m_correction; }
  btScalar length(std::size_t index) const { return at(index).m_rule.length; }
  btScalar& aimed(std::size_t index) { return at(index).m_aimedDistance; }
  void move(std::size_t index, double push) {
    at(index).move(m_pool, m_leader.m_block.row(index), push);
  }
  void slow_turning() { m_leader.slowTurning(m_pool, m_timeStep); }
  void look_again() {
    for (btCableInSolver* cable : m_leader.m_pulling) {
      const btScalar before = cable->m_line.m_distance;
      cable->m_line = cable->getLineBefore(m_timeStep);
      if (cable->m_spring.is_elastic()) {
        cable->setRow(cable->m_spring.moved(cable->m_line.m_distance - before));
        continue;
      }
      const btScalar rate = cable->m_line.rate(cable->m_rbA, cable->m_rbB);
      cable->m_row.rate = btMin(cable->m_row.rate, -rate - cable->m_rule.length_rate);
    }
    m_leader.fillBlock(m_pool);
  }

 private:
  btCableInSolver& at(std::size_t index) const { return *m_leader.m_pulling[index]; }

  btCableInSolver& m_leader;
  btSolverBody* m_pool;
  btScalar m_timeStep;  // [s]
};

/// What every cable asks for, and their Delassus matrix.
inline void btCableInSolver::begin(btSolverBody* pool, btScalar timeStep) {
  m_pulling.clear();
  bool impact = false;
  for (btCableInSolver* cable : m_together) {
    cable->m_line = cable->getLineBefore(timeStep);
    cable->ask(cable->startOf(pool, timeStep));
    cable->m_solved = true;
    if (cable->m_row.acts) {
      m_pulling.push_back(cable);
      impact = impact || cable->m_ofImpacts > 0;
    }
  }
  for (btCableInSolver* cable : m_pulling) {
    // one cable's strikes all, but those that stretch
    cable->m_ofImpacts = impact && !cable->m_spring.is_elastic() ? SIMD_INFINITY : btScalar(0);
    if (m_pulling.size() > 1 && !cable->m_spring.is_elastic()) {
      cable->m_row = cable->m_rule.beside_others(cable->m_row);
    }
  }
  fillBlock(pool);
  Overstretch overstretch(*this, pool, timeStep);
  tautline::move_out_of_overstretch<btScalar>(overstretch, m_block, m_pulling.size());
  m_block.forget();
  for (std::size_t index = 0; index < m_pulling.size(); ++index) {
    m_pulling[index]->m_inverseMass = static_cast<btScalar>(m_block.inverse_mass(index));
  }
}

/// Takes half of the spin of a body that turns too far in a step for it to follow.
inline void btCableInSolver::slowTurning(btSolverBody* pool, btScalar timeStep) {
  m_slowed.clear();
  for (const btCableInSolver* cable : m_pulling) {
    for (const btRigidBody* one : {&cable->m_rbA, &cable->m_rbB}) {
      btSolverBody* body = btSolverBodyOf(pool, *one);
      const btVector3 spin = btMotionInSolver(pool, *one, true).m_spin;
      if (body != nullptr && spin.length() * timeStep > Rule::followed() &&
          std::find(m_slowed.begin(), m_slowed.end(), one) == m_slowed.end()) {
        body->internalGetDeltaAngularVelocity() -= spin / 2;
        m_slowed.push_back(one);
      }
    }
  }
}

inline void btCableInSolver::move(btSolverBody* pool, const tautline::CableBlock::Row& row,
                                  double push) {
  const btRigidBody* bodies[] = {&m_rbA, &m_rbB};
  for (int side = 0; side < 2; ++side) {
    btSolverBody* body = btSolverBodyOf(pool, *bodies[side]);
    if (body != nullptr) {
      const btScalar by = static_cast<btScalar>(push);  // [kg m]
      btTransform moved;
      btTransformUtil::integrateTransform(body->m_worldTransform,
                                          by * btVector3Of(row.end[side].move),
                                          by * btVector3Of(row.end[side].turn), 1, moved);
      // the solver writes its own back, or none
      body->m_worldTransform = moved;
      body->m_originalBody->setWorldTransform(moved);
    }
  }
}

/// The impulses that go with what joints and contacts have changed so far.
inline void btCableInSolver::find(btSolverBody* pool, btScalar timeStep, bool first) {
  bool off = false;
  for (std::size_t index = 0; index < m_pulling.size(); ++index) {
    const btCableInSolver& cable = *m_pulling[index];
    const btScalar rate = cable.rateNow(pool);
    const double missing = cable.m_row.rate - rate - m_block.give(index);
    m_block.lacking(index) = missing + m_block.reaction(index);
    const double rounding = 8 * SIMD_EPSILON * (btFabs(rate) + btFabs(cable.m_row.rate));
    const double short_of = m_block.impulse(index) > 0 ? std::abs(missing) : missing;
    off = off || short_of > rounding;
  }
  if (!off) {
    return;
  }
  for (std::size_t index = 0; index < m_pulling.size(); ++index) {
    m_pulling[index]->m_change = -m_block.impulse(index);
  }
  if (first) {
    m_block.solve_stiffly(timeStep);
  } else {
    m_block.solve(tautline::CableBlock::velocities);
  }
  for (std::size_t index = 0; index < m_pulling.size(); ++index) {
    m_pulling[index]->m_change += m_block.impulse(index);
    m_pulling[index]->apply(pool, m_block.row(index), m_block.impulse(index), timeStep);
  }
}

inline void btCableInSolver::setRow(const tautline::CableSpring::Row& row) {
  m_row = Rule::Row{row.acts && m_line.m_distance > SIMD_EPSILON, static_cast<btScalar>(row.rate)};
  m_compliance = row.compliance;
}

inline void btCableInSolver::askElastic(const Rule::Start& at) {
  tautline::CableBlock::Row row;
  fill(row);
  setRow(m_spring.step(tautline::CableSpring::Start(at, row.inverse_mass(), m_byEvents)));
  m_ofImpacts = 0;
  m_tautTime = m_row.acts ? at.dt : btScalar(0);
  m_correction = -m_line.m_distance;  // the others' may stretch it
}

inline void btCableInSolver::tookImpulse() {
  m_row.acts = false;
  if (m_spring.is_elastic()) {
    m_spring.pulled(m_appliedImpulse);
  } else {
    m_rule.pulled(m_appliedImpulse, m_inverseMass);
  }
}

inline void btCableInSolver::ask(const Rule::Start& at) {
  if (m_spring.is_elastic()) {
    askElastic(at);
  } else {
    askInextensible(at);
  }
  if (m_rule.length_rate != 0) {
    m_rule.pay_out(at.dt);
    wake();
  }
}

inline void btCableInSolver::askInextensible(const Rule::Start& at) {
  const bool impact = !m_byEvents && m_rule.is_impact(at);
  if (!(m_line.m_distance > SIMD_EPSILON)) {
    m_row = Rule::Row{false, 0};  // pivots that coincide have no direction to be pulled in
  } else if (m_byEvents) {
    if (!m_rule.touches(at.gap)) {
      m_rule.release();
    }
    m_row = m_rule.held() ? m_rule.step_by_events(at) : Rule::Row{false, 0};
  } else {
    m_row = m_rule.step(at);
  }
  // in a fixed step, all of the impulse or nothing
  m_ofImpacts = m_row.acts && (impact || !m_rule.held()) ? SIMD_INFINITY : btScalar(0);
  m_tautTime = m_row.acts ? at.dt : btScalar(0);
  // a short part takes out no more than its share
  const btScalar share = m_byEvents ? btMin(at.dt / m_eventStep, btScalar(1)) : btScalar(1);
  m_correction = share * m_rule.correction(at);
  if (m_row.acts && (!m_rule.held() || m_correction > Rule::slack_rounding() * m_rule.length)) {
    // a load that bounces, or is moved, slower than Bullet's sleeping threshold does not sleep
    m_rbA.activate();
    m_rbB.activate();
  }
}

inline btCableInSolver::Rule::Start btCableInSolver::startOf(btSolverBody* pool,
                                                             btScalar timeStep) const {
  const btCableMotion a = btMotionInSolver(pool, m_rbA, false);
  const btCableMotion b = btMotionInSolver(pool, m_rbB, false);
  Rule::Start start;
  start.gap = m_rule.length - m_line.m_distance;
  start.rate = m_line.rate(m_rbA, m_rbB) + m_rule.length_rate;
  start.fall = start.rate - m_line.rate(a, b) - m_rule.length_rate;
  start.dt = timeStep;
  tautline::cable_turn(start, m_line.swing(a, b), m_line.m_distance);
  return start;
}

inline btScalar btCableInSolver::rateNow(btSolverBody* pool) const {
  return m_line.rate(btMotionInSolver(pool, m_rbA, true), btMotionInSolver(pool, m_rbB, true)) +
         m_rule.length_rate;
}

inline void btFillCableEnd(tautline::CableBlockEnd& end, const btRigidBody& body,
                           const btVector3& pull, const btVector3& moment) {
  const bool moves = btCableMoves(body);
  end.body = moves ? &body : nullptr;
  if (moves) {
    const btVector3 move = pull * body.getInvMass() * body.getLinearFactor();
    const btVector3 turn = (body.getInvInertiaTensorWorld() * moment) * body.getAngularFactor();
    for (int axis = 0; axis < 3; ++axis) {
      end.pull[axis] = pull[axis];
      end.moment[axis] = moment[axis];
      end.move[axis] = move[axis];
      end.turn[axis] = turn[axis];
    }
  }
}

inline void btCableInSolver::fill(tautline::CableBlock::Row& row) const {
  btFillCableEnd(row.end[0], m_rbA, m_line.m_towards, m_line.m_momentA);
  btFillCableEnd(row.end[1], m_rbB, -m_line.m_towards, -m_line.m_momentB);
  row.end[0].arm = m_line.m_armA.length();
  row.end[1].arm = m_line.m_armB.length();
  // in parts of its own inverse mass, as Bullet has it
  row.softness = m_spring.is_elastic() ? 0 : m_cfm;
  row.compliance = m_compliance;
}

inline void btCableInSolver::apply(btSolverBody* pool, const tautline::CableBlock::Row& row,
                                   double impulse, btScalar timeStep) {
  const btScalar change = static_cast<btScalar>(m_change);
  const btRigidBody* bodies[] = {&m_rbA, &m_rbB};
  for (int side = 0; side < 2; ++side) {
    btSolverBody* body = btSolverBodyOf(pool, *bodies[side]);
    if (body != nullptr) {
      body->internalGetDeltaLinearVelocity() += change * btVector3Of(row.end[side].move);
      body->internalGetDeltaAngularVelocity() += change * btVector3Of(row.end[side].turn);
    }
  }
  m_appliedImpulse = static_cast<btScalar>(impulse);
  if (m_jointFeedback != nullptr) {
    const btScalar tension = m_appliedImpulse / timeStep;
    m_jointFeedback->m_appliedForceBodyA = tension * m_line.m_towards;
    m_jointFeedback->m_appliedTorqueBodyA = tension * m_line.m_momentA;
    m_jointFeedback->m_appliedForceBodyB = -tension * m_line.m_towards;
    m_jointFeedback->m_appliedTorqueBodyB = -tension * m_line.m_momentB;
  }
}

// NOLINTEND(modernize-use-nodiscard)

#endif
