// Opt-in: a step of a Bullet world split at the instants at which cables go taut, so that an impact
// is solved at zero gap and in no time, and its restitution is exact to rounding.
//
//   btStepWithCables(world, &cables[0], cables.size(), btScalar(1) / 60);  // not stepSimulation
//
// The world's ERP and warm starting are less in a short part, in proportion; a joint with an ERP of
// its own is corrected faster there. The whole world takes the shorter steps, collision detection,
// tick callbacks and all; a step in which no cable goes taut costs a prediction per slack cable. In
// an impact the cables' own bodies alone change their velocities; contacts and other joints of
// theirs answer in the part after it. A body at a cable's end that nothing but cables touched in a
// part is put where its forces take it, half of a h^2 from where Bullet does: else every bounce
// would lose energy to the split. A kinematic body at a cable's end goes its way evenly over the
// parts; one that is at no cable's end jumps in the first, as Bullet has it. A callback must not
// remove a cable or a body at its ends. A linear or angular factor that is neither 0 nor 1 is
// applied to the user's forces once in each part.
//
// Forces and torques act over the whole step: those given before it are the same in all parts;
// those that a tick callback gives may change from part to part, and an impact is looked for with
// those of the part before.

#ifndef TAUTLINE_BT_STEP_WITH_CABLES_H
#define TAUTLINE_BT_STEP_WITH_CABLES_H

#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>
#include <LinearMath/btTransformUtil.h>

#include <memory>

#include "tautline/bullet/btCableConstraint.h"
#include "tautline/bullet/btFlight.h"
#include "tautline/bullet/btForcesOfStep.h"
#include "tautline/bullet/btMovingEnd.h"
#include "tautline/cable_events.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// The world and its cables as `tautline::step_by_events` needs them. Use `btStepWithCables`.
class btCableStepper : private btFlight {
 public:
  class Cable;

  btCableStepper(btDiscreteDynamicsWorld* world, btCableConstraint* const* cables, int numCables,
                 btScalar timeStep);

  int step(int maxParts);
  void fly(btScalar timeStep);

 private:
  static std::vector<btCableInSolver*> asInSolver(btCableConstraint* const* cables, int numCables) {
    return std::vector<btCableInSolver*>(cables, cables + numCables);
  }
  void stepPart(btScalar timeStep);

  btDiscreteDynamicsWorld* m_world;
  std::vector<Cable> m_cables;
  btForcesOfStep m_forces;
  std::vector<btRigidBody*> m_ends;  // that forces move, each once
  std::vector<std::unique_ptr<btMovingEnd>> m_moving;
  btScalar m_timeStep;
  btScalar m_lastPart;  // [s]
};

class btCableStepper::Cable {
 public:
  explicit Cable(btCableConstraint* constraint) : m_cable(constraint) {}

  /// `end` moves one of its bodies, if it is its.
  void movedBy(const btMovingEnd* end) {
    m_movingA = end->body() == &m_cable->m_rbA ? end : m_movingA;
    m_movingB = end->body() == &m_cable->m_rbB ? end : m_movingB;
  }

  bool held() const { return m_cable->m_rule.held(); }
  /// An elastic cable has no impacts: its row acts in each part.
  bool mayStrike() const { return m_cable->isEnabled() && !m_cable->m_spring.is_elastic(); }
  bool flies() const { return mayStrike() && !held() && gap() >= -tolerance(); }
  btScalar gap() const { return m_cable->getGap(); }
  btScalar rate() const { return m_cable->getGapRate(); }
  btScalar gap_after(btScalar timeStep) const {
    const btCableLine line(poseAfter(m_cable->m_rbA, m_movingA, timeStep), m_cable->m_pivotInA,
                           poseAfter(m_cable->m_rbB, m_movingB, timeStep), m_cable->m_pivotInB);
    return m_cable->getMaxLength() + timeStep * m_cable->getMaxLengthRate() - line.m_distance;
  }
  btScalar tolerance() const { return 100 * SIMD_EPSILON * m_cable->getMaxLength(); }
  btScalar rate_rounding() const {
    return 100 * SIMD_EPSILON *
           (m_cable->m_rbA.getLinearVelocity().length() +
            m_cable->m_rbB.getLinearVelocity().length() +
            (m_cable->m_rbA.getAngularVelocity().length() +
             m_cable->m_rbB.getAngularVelocity().length()) *
                m_cable->getMaxLength());
  }
  bool touches() const { return mayStrike() && (gap() <= tolerance() || (held() && m_pulled)); }
  /// What a whole step explains of the closing rate [m/s].
  btScalar explained() const {
    const btCableLine line = m_cable->getLine();
    btCableConstraint::Rule::Start start;
    start.dt = m_cable->m_eventStep;
    start.fall = fall(line);
    tautline::cable_turn(start,
                         line.swing(btCableMotion(m_cable->m_rbA), btCableMotion(m_cable->m_rbB)),
                         line.m_distance);
    return m_cable->m_rule.explained(start);
  }
  btScalar braking() const { return m_braking; }
  bool slack() const { return m_cable->m_rule.slack(); }
  /// Of a cable that rests, between two steps: the user, or a hook, has pulled at it.
  bool is_tugged() const { return held() && -rate() > explained(); }
  btScalar rebound() const { return m_cable->m_rule.rebound(-rate()); }
  void fill(tautline::CableBlock::Row& row) {
    m_cable->m_line = m_cable->getLine();
    m_cable->fill(row);
    row.softness = 0;
  }
  void hold() { m_cable->m_rule.hold(); }
  void rebounds() {
    m_cable->m_rule.rebounds();
    leaves();
  }
  /// Out of its overstretch, it is slack.
  void leaves() {
    if (!held() && gap() >= -tolerance()) {
      m_cable->m_rule.release();
    }
  }

  void apply(btScalar impulse) {
    const btCableLine line = m_cable->getLine();
    btRigidBody& a = m_cable->m_rbA;
    btRigidBody& b = m_cable->m_rbB;
    a.applyCentralImpulse(impulse * line.m_towards);
    a.applyTorqueImpulse(impulse * line.m_momentA);
    b.applyCentralImpulse(-impulse * line.m_towards);
    b.applyTorqueImpulse(-impulse * line.m_momentB);
  }
  void struck(btScalar impulse, btScalar impact) {
    add(impulse);
    m_ofImpacts += impact;
    for (btPushes* pushes : {&m_cable->m_pushesOnA, &m_cable->m_pushesOnB}) {
      pushes->m_isStruck = pushes->m_isStruck || impact > 0;
    }
    m_cable->m_rbA.activate();
    m_cable->m_rbB.activate();
  }
  void ran_out() { ++m_cable->m_stepsOutOfParts; }

  /// Between these two, the cable has a row while it rests taut, and none in flight.
  void begin(btScalar timeStep) {
    m_sleeps = !isMoved(m_cable->m_rbA) && !isMoved(m_cable->m_rbB) && m_movingA == nullptr &&
               m_movingB == nullptr;
    m_cable->m_byEvents = true;
    m_cable->m_eventStep = timeStep;
    if (!m_cable->m_rule.touches(gap())) {
      m_cable->m_rule.release();
    }
    leaves();
    m_braking = held() ? findBraking() : btScalar(0);
    m_cable->m_drivenLengthRate = m_cable->getMaxLengthRate();
    m_cable->m_driven = driven();
    m_cable->m_drivenIsKnown = true;
  }
  void end() {
    m_cable->m_byEvents = false;
    if (!m_sleeps || m_impulse > 0) {  // else it pulls as it did
      m_cable->m_appliedImpulse = m_impulse;
      m_cable->m_ofImpacts = m_ofImpacts;
      m_cable->m_tautTime = m_tautTime;
    }
  }
  /// What the cable changed the velocity of `body` by in the part that is over [m/s].
  btVector3 pullAt(const btRigidBody& body) const {
    const btVector3 pull = m_cable->m_row.acts
                               ? m_cable->m_appliedImpulse * m_cable->m_line.m_towards
                               : btVector3(0, 0, 0);
    const btScalar side =
        btScalar(&body == &m_cable->m_rbA ? 1 : 0) - btScalar(&body == &m_cable->m_rbB ? 1 : 0);
    return side * body.getInvMass() * pull * body.getLinearFactor();
  }
  /// After a part: its impulse is in.
  void flew() {
    m_pulled = false;
    if (m_cable->m_row.acts) {
      m_cable->tookImpulse();
      m_pulled = m_cable->m_appliedImpulse > 0;
      add(m_cable->m_appliedImpulse);
      m_tautTime += m_cable->m_appliedImpulse > 0 ? m_cable->m_tautTime : btScalar(0);
      if (!m_pulled && gap() > tolerance() + m_braking * m_cable->m_eventStep) {
        m_cable->m_rule.release();
      }
    }
    leaves();
  }

 private:
  /// Closing that forces add in a whole step [m/s].
  btScalar fall(const btCableLine& line) const {
    return -m_cable->m_eventStep *
           line.m_towards.dot(acceleration(m_cable->m_rbA) - acceleration(m_cable->m_rbB));
  }
  /// At which hooks move the pivots relative to each other [m/s].
  btVector3 driven() const {
    btVector3 velocity(0, 0, 0);
    if (m_movingA != nullptr) {
      velocity += m_cable->m_rbA.getVelocityInLocalPoint(m_cable->getLine().m_armA);
    }
    if (m_movingB != nullptr) {
      velocity -= m_cable->m_rbB.getVelocityInLocalPoint(m_cable->getLine().m_armB);
    }
    return velocity;
  }
  btScalar findBraking() const {
    const btCableLine line = m_cable->getLine();
    const btScalar change = m_cable->getMaxLengthRate() - m_cable->m_drivenLengthRate +
                            line.m_towards.dot(driven() - m_cable->m_driven);
    return tautline::cable_braking(m_cable->m_drivenIsKnown, change, rate(), fall(line));
  }
  void add(btScalar impulse) {
    m_impulse += impulse;
    if (m_impulse >= m_cable->getBreakingImpulseThreshold()) {
      m_cable->setEnabled(false);
    }
  }

  btCableConstraint* m_cable;
  const btMovingEnd* m_movingA = nullptr;
  const btMovingEnd* m_movingB = nullptr;
  btScalar m_impulse = 0;    // of the step so far [N s]
  btScalar m_ofImpacts = 0;  // of these [N s]
  btScalar m_tautTime = 0;   // [s]
  btScalar m_braking = 0;    // see cable_braking [m/s]
  bool m_pulled = false;     // in the part that is over
  bool m_sleeps = false;
};

inline btCableStepper::btCableStepper(btDiscreteDynamicsWorld* world,
                                      btCableConstraint* const* cables, int numCables,
                                      btScalar timeStep)
    : m_world(world),
      m_forces(world, asInSolver(cables, numCables).data(), numCables, timeStep),
      m_timeStep(timeStep),
      m_lastPart(timeStep) {
  for (int index = 0; index < numCables; ++index) {
    m_cables.push_back(Cable(cables[index]));
    for (btRigidBody* body : {&cables[index]->getRigidBodyA(), &cables[index]->getRigidBodyB()}) {
      if (std::find(m_ends.begin(), m_ends.end(), body) == m_ends.end()) {
        m_ends.push_back(body);
      }
    }
  }
  for (btRigidBody* body : m_ends) {
    if (btMovingEnd::drives(*body)) {
      m_moving.emplace_back(new btMovingEnd(body, timeStep));
      for (Cable& cable : m_cables) {
        cable.movedBy(m_moving.back().get());
      }
    }
  }
  m_ends.erase(
      std::remove_if(m_ends.begin(), m_ends.end(),
                     [](const btRigidBody* body) { return body->isStaticOrKinematicObject(); }),
      m_ends.end());
}

inline int btCableStepper::step(int maxParts) {
  for (Cable& cable : m_cables) {
    cable.begin(m_timeStep);
  }
  const int parts = tautline::step_by_events(*this, m_cables, m_timeStep, maxParts);
  for (Cable& cable : m_cables) {
    cable.end();
  }
  return parts;
}

inline void btCableStepper::fly(btScalar timeStep) {
  struct Arrival {
    btRigidBody* m_body;
    btVector3 m_velocity;  // before the part, or what its damping leaves
    btVector3 m_torque;    // that is expected [N m]
    btVector3 m_turn;      // by it [rad/s^2]
  };
  std::vector<Arrival> arrivals;
  for (btRigidBody* body : m_ends) {
    const btVector3 kept = damped(body->getLinearVelocity(), body->getLinearDamping(), timeStep);
    arrivals.push_back(Arrival{body, kept, body->getTotalTorque(), turning(*body)});
  }
  for (const std::unique_ptr<btMovingEnd>& end : m_moving) {
    end->advance(timeStep);
  }
  m_forces.withdraw();
  stepPart(timeStep);
  m_forces.learn(timeStep);
  m_forces.expect();  // the same as in this part; btStepWithCables clears them at the end
  for (const Arrival& arrival : arrivals) {
    const btVector3 gained = acceleration(*arrival.m_body);
    const btVector3 expected = arrival.m_velocity + timeStep * gained;
    btVector3 touch = arrival.m_body->getLinearVelocity() - expected;
    btScalar pulled = 0;
    for (const Cable& cable : m_cables) {
      const btVector3 pull = cable.pullAt(*arrival.m_body);
      touch -= pull;
      pulled += pull.length();
    }
    const btScalar rounding =
        10 * SIMD_EPSILON * (expected.length() + timeStep * gained.length() + pulled);
    if (touch.length() <= rounding) {
      btTransform pose = arrival.m_body->getCenterOfMassTransform();
      pose.setOrigin(pose.getOrigin() - timeStep * timeStep / 2 * gained);
      // as expected exactly, for where the impact is has been found with it
      const btVector3 more = arrival.m_body->getInvInertiaTensorWorld() *
                             (arrival.m_body->getTotalTorque() - arrival.m_torque);
      arrival.m_body->setCenterOfMassTransform(turnedBack(pose, arrival.m_turn + more, timeStep));
      m_world->synchronizeSingleMotionState(arrival.m_body);
    }
  }
  for (Cable& cable : m_cables) {
    cable.flew();
  }
}

inline void btCableStepper::stepPart(btScalar timeStep) {
  btContactSolverInfo& info = m_world->getSolverInfo();
  const btScalar erp = info.m_erp;
  const btScalar erp2 = info.m_erp2;
  const btScalar warmstartingFactor = info.m_warmstartingFactor;
  // a penetration is pushed out at the same speed in a short part, and impulses are guessed in
  // proportion to the time; those of a very short part are of an impact, and tell nothing of a
  // longer
  info.m_erp *= timeStep / m_timeStep;
  info.m_erp2 *= timeStep / m_timeStep;
  info.m_warmstartingFactor *= btMin(timeStep / m_lastPart, btScalar(20));
  m_world->stepSimulation(timeStep, 0);
  info.m_erp = erp;
  info.m_erp2 = erp2;
  info.m_warmstartingFactor = warmstartingFactor;
  m_lastPart = timeStep;
}

/// Steps `world` by `timeStep` [s], in at most `maxParts` + 1 parts; returns how many. `cables` are
/// constraints of this world; one that is left out acts by itself in every part. Afterwards
/// getAppliedImpulse is the sum over the step.
inline int btStepWithCables(btDiscreteDynamicsWorld* world, btCableConstraint* const* cables,
                            int numCables, btScalar timeStep, int maxParts = 8) {
  btCableStepper stepper(world, cables, numCables, timeStep);
  const int parts = stepper.step(maxParts);
  world->clearForces();
  return parts;
}

// NOLINTEND(modernize-use-nodiscard)

#endif
