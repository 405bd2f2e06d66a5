// Opt-in: a step of an ODE world split at the instants at which cables go taut, so that an impact
// is solved at zero gap and in no time, and its restitution is exact to rounding.
//
//   void step(void* data, dReal stepsize) {  // what stood in the loop before
//     dBodyAddForce(load, 0, thrust, 0);       // here, or before dStepWithCables
//     dSpaceCollide(space, data, &nearCallback);
//     dWorldStep(world, stepsize);
//     dJointGroupEmpty(contactGroup);
//   }
//   ...
//   dStepWithCables(world, group, cables, count, 1.0 / 60, &step, data);
//
// The whole world takes the shorter steps; a step in which no cable goes taut costs a prediction
// per slack cable. In an impact the cables' own bodies alone change their velocities; contacts and
// other joints of theirs answer in the part after it. A body at a cable's end that nothing but
// cables touched in a part is put where its forces take it, half of a h^2 from where ODE does: else
// every bounce would lose energy to the split.
//
// Forces and torques act over the whole step. Those that `step` adds may change from part to part,
// in each of which they are constant; an impact is looked for with those of the part before. Those
// given before dStepWithCables are the same in all parts; on a body at no cable's end, and not
// jointed to one that is, they act in the first part alone: add those in `step`. While the world is
// stepped so, it has a body more, and one thread steps its islands.

#ifndef TAUTLINE_ODE_STEP_WITH_CABLES_H
#define TAUTLINE_ODE_STEP_WITH_CABLES_H

#include "tautline/cable_events.h"
#include "tautline/ode/dCable.h"
#include "tautline/ode/dxForcesOfStep.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// Steps the user's world by `stepsize` [s].
typedef void dStepFunction(void* data, dReal stepsize);

/// A cable as `tautline::step_by_events` needs it. Use `dStepWithCables`.
class dxEventCable {
 public:
  explicit dxEventCable(dCableID cable) : m_cable(cable) {}

  dCableID id() const { return m_cable; }
  bool held() const { return m_cable->rule.held(); }
  bool slack() const { return m_cable->rule.slack(); }
  /// An elastic cable has no impacts: it pulls in each part.
  bool may_strike() const { return !m_cable->broken && !m_cable->spring.is_elastic(); }
  bool flies() const { return may_strike() && !held() && gap() >= -tolerance(); }
  bool touches() const { return may_strike() && (gap() <= tolerance() || (held() && m_pulled)); }
  dReal gap() const { return dCableGetGap(m_cable); }
  dReal rate() const { return dCableGetGapRate(m_cable); }
  dReal tolerance() const {
    return 100 * std::numeric_limits<dReal>::epsilon() * m_cable->rule.length;
  }
  dReal rate_rounding() const;
  dReal explained() const;
  dReal braking() const { return m_braking; }
  /// Of a cable that rests, between two steps: the user, or a hook, has pulled at it.
  bool is_tugged() const { return held() && -rate() > explained(); }
  dReal rebound() const { return m_cable->rule.rebound(-rate()); }
  void fill(tautline::CableBlock::Row& row) {
    m_cable->line.find(m_cable->end);
    m_cable->fill(row);
  }
  void hold() { m_cable->rule.hold(); }
  void rebounds() {
    m_cable->rule.rebounds();
    leaves();
  }
  /// Out of its overstretch, it is slack.
  void leaves() {
    if (!held() && gap() >= -tolerance()) {
      m_cable->rule.release();
    }
  }
  void apply(dReal impulse);
  void struck(dReal impulse, dReal impact);
  void ran_out() { ++m_cable->out_of_parts; }
  dReal gap_after(dReal stepsize) const;

  /// Between these two, the cable acts while it rests taut, and not in flight.
  void begin(dReal stepsize) {
    dxCableReadImpulse(m_cable);
    m_sleeps = !m_cable->end[0].is_awake() && !m_cable->end[1].is_awake();
    m_cable->by_events = true;
    m_cable->event_stepsize = stepsize;
    if (!m_cable->rule.touches(gap())) {
      m_cable->rule.release();
    }
    leaves();
    m_braking = held() ? find_braking() : dReal(0);
    m_cable->driven_length_rate = m_cable->rule.length_rate;
    driven(m_cable->driven);
    m_cable->driven_is_known = true;
  }
  void end() {
    m_cable->by_events = false;
    if (!m_sleeps || m_impulse > 0) {  // else it pulls as it did
      m_cable->impulse = m_impulse;
      m_cable->of_impacts = m_of_impacts;
      m_cable->taut_time = m_taut_time;
      m_cable->broken = m_cable->broken || m_cable->taut_tension() >= m_cable->breaking_tension;
    }
  }
  /// What the cable changed the velocity of `body` by in the part that is over [m/s].
  void pull_at(dBodyID body, dReal* result) const {
    const dReal side =
        dReal(m_cable->end[0].body == body ? 1 : 0) - dReal(m_cable->end[1].body == body ? 1 : 0);
    dMass mass;
    dBodyGetMass(body, &mass);
    const dReal impulse = m_cable->row.acts ? m_cable->impulse : dReal(0);
    dCopyScaledVector3(result, m_cable->line.towards, side * impulse / mass.mass);
  }
  /// After a part: its impulse is in.
  void flew() {
    m_pulled = false;
    if (m_cable->row.acts) {
      m_cable->row.acts = false;
      m_pulled = m_cable->impulse > 0;
      add(m_cable->impulse);
      m_taut_time += m_cable->impulse > 0 ? m_cable->taut_time : dReal(0);
      if (!m_pulled && gap() > tolerance() + m_braking * m_cable->event_stepsize) {
        m_cable->rule.release();
      }
    }
    leaves();
  }

 private:
  dReal fall(const dxCableLine& line) const;
  void driven(dReal* result) const;
  dReal find_braking() const;
  void add(dReal impulse) {
    m_impulse += impulse;
    m_cable->broken = m_cable->broken || m_impulse >= m_cable->breaking;
  }

  dCableID m_cable;
  dReal m_impulse = 0;     // of the step so far [N s]
  dReal m_of_impacts = 0;  // of these [N s]
  dReal m_taut_time = 0;   // [s]
  dReal m_braking = 0;     // see cable_braking [m/s]
  bool m_pulled = false;   // in the part that is over
  bool m_sleeps = false;
};

inline dReal dxEventCable::rate_rounding() const {
  dReal fastest = 0;
  for (const dxCableEnd& end : m_cable->end) {
    if (end.body != nullptr) {
      fastest += dCalcVectorLength3(dBodyGetLinearVel(end.body)) +
                 dCalcVectorLength3(dBodyGetAngularVel(end.body)) * m_cable->rule.length;
    }
  }
  return 100 * std::numeric_limits<dReal>::epsilon() * fastest;
}

/// Closing that forces add in a whole step [m/s].
inline dReal dxEventCable::fall(const dxCableLine& line) const {
  dVector3 one, two;
  dxEndAcceleration(m_cable->end[0], one);
  dxEndAcceleration(m_cable->end[1], two);
  dSubtractVectors3(one, one, two);
  return -m_cable->event_stepsize * dCalcVectorDot3(line.towards, one);
}

/// What a whole step explains of the closing rate [m/s].
inline dReal dxEventCable::explained() const {
  const dxCableLine line(m_cable->end);
  dxCable::Rule::Start start;
  start.dt = m_cable->event_stepsize;
  start.fall = fall(line);
  tautline::cable_turn(start,
                       line.swing(dxMotion(m_cable->end[0].body), dxMotion(m_cable->end[1].body)),
                       line.distance);
  return m_cable->rule.explained(start);
}

/// At which hooks move the anchors relative to each other [m/s].
inline void dxEventCable::driven(dReal* result) const {
  dSetZero(result, 3);
  for (int index = 0; index < 2; ++index) {
    const dxCableEnd& end = m_cable->end[index];
    if (end.body != nullptr && !end.is_moved()) {
      dVector3 velocity;
      dBodyGetRelPointVel(end.body, end.anchor[0], end.anchor[1], end.anchor[2], velocity);
      dAddScaledVectors3(result, result, velocity, 1, index == 0 ? dReal(1) : dReal(-1));
    }
  }
}

inline dReal dxEventCable::find_braking() const {
  const dxCableLine line(m_cable->end);
  dVector3 change;
  driven(change);
  dSubtractVectors3(change, change, m_cable->driven);
  return tautline::cable_braking(m_cable->driven_is_known,
                                 m_cable->rule.length_rate - m_cable->driven_length_rate +
                                     dCalcVectorDot3(line.towards, change),
                                 rate(), fall(line));
}

inline void dxEventCable::apply(dReal impulse) {
  const dxCableLine line(m_cable->end);
  for (int index = 0; index < 2; ++index) {
    if (!m_cable->end[index].is_moved()) {
      continue;
    }
    const dBodyID body = m_cable->end[index].body;
    const dReal along = index == 0 ? impulse : -impulse;
    dMass mass;
    dBodyGetMass(body, &mass);
    dVector3 turn;
    dxBodySolveInertia(body, line.moment[index], turn);
    dVector3 linear, angular;
    dAddScaledVectors3(linear, dBodyGetLinearVel(body), line.towards, 1, along / mass.mass);
    dAddScaledVectors3(angular, dBodyGetAngularVel(body), turn, 1, along);
    dBodySetLinearVel(body, linear[0], linear[1], linear[2]);
    dBodySetAngularVel(body, angular[0], angular[1], angular[2]);
  }
}

inline void dxEventCable::struck(dReal impulse, dReal impact) {
  add(impulse);
  m_of_impacts += impact;
  for (dxCableEnd& end : m_cable->end) {
    end.pushes.is_struck = end.pushes.is_struck || impact > 0;
    if (end.is_moved()) {
      dBodyEnable(end.body);
    }
  }
}

inline dReal dxEventCable::gap_after(dReal stepsize) const {
  dVector3 at[2], between;
  dxEndAfter(m_cable->end[0], stepsize, at[0]);
  dxEndAfter(m_cable->end[1], stepsize, at[1]);
  dSubtractVectors3(between, at[1], at[0]);
  return m_cable->rule.length + stepsize * m_cable->rule.length_rate - dCalcVectorLength3(between);
}

/// The user's world as `tautline::step_by_events` needs it. Use `dStepWithCables`.
class dxEventHost {
 public:
  dxEventHost(dWorldID world, dJointGroupID group, std::vector<dxEventCable>& cables,
              dxForcesOfStep& forces, dReal stepsize, dStepFunction* step, void* data)
      : m_world(world),
        m_group(group),
        m_cables(cables),
        m_forces(forces),
        m_stepsize(stepsize),
        m_erp(dWorldGetERP(world)),
        m_step(step),
        m_data(data) {
    for (const dxEventCable& cable : cables) {
      m_ids.push_back(cable.id());
    }
  }

  void fly(dReal stepsize) {
    std::vector<Arrival> arrivals;
    for (std::size_t index = 0; index < m_forces.ends(); ++index) {
      arrivals.push_back(Arrival(m_forces.end(index)));
    }
    dCableAddContacts(m_world, m_group, m_ids.data(), static_cast<int>(m_ids.size()), stepsize);
    // a depth is pushed out at the same speed in a short part
    dWorldSetERP(m_world, m_erp * stepsize / m_stepsize);
    m_forces.withdraw(stepsize);
    m_step(m_data, stepsize);
    m_forces.expect();  // the same as in this part
    dWorldSetERP(m_world, m_erp);
    dJointGroupEmpty(m_group);
    for (dxEventCable& cable : m_cables) {
      dxCableReadImpulse(cable.id());
    }
    for (const Arrival& arrival : arrivals) {
      arrival.correct(stepsize, m_cables);
    }
    for (dxEventCable& cable : m_cables) {
      cable.flew();
    }
  }

 private:
  /// A body before a part; after it, it is put where its forces take it.
  struct Arrival {
    dBodyID body;
    dVector3 velocity;
    dVector3 torque;  // that is expected [N m]
    dVector3 turn;    // by it [rad/s^2]

    explicit Arrival(dBodyID the_body) : body(the_body) {
      dCopyVector3(velocity, dBodyGetLinearVel(body));
      dCopyVector3(torque, dBodyGetTorque(body));
      dxBodySolveInertia(body, torque, turn);
    }
    void correct(dReal stepsize, const std::vector<dxEventCable>& cables) const {
      dVector3 gravity, acceleration, touch;
      dWorldGetGravity(dBodyGetWorld(body), gravity);
      dxBodyAcceleration(body, gravity, acceleration);
      dAddScaledVectors3(touch, velocity, acceleration, 1, stepsize);
      const dReal speed = dCalcVectorLength3(touch);
      dSubtractVectors3(touch, dBodyGetLinearVel(body), touch);
      dReal pulled = 0;
      for (const dxEventCable& cable : cables) {
        dVector3 pull;
        cable.pull_at(body, pull);
        dSubtractVectors3(touch, touch, pull);
        pulled += dCalcVectorLength3(pull);
      }
      const dReal rounding = 10 * std::numeric_limits<dReal>::epsilon() *
                             (speed + stepsize * dCalcVectorLength3(acceleration) + pulled);
      if (dCalcVectorLength3(touch) <= rounding) {
        const dReal back = -stepsize * stepsize / 2;
        dVector3 position, turned;
        dAddScaledVectors3(position, dBodyGetPosition(body), acceleration, 1, back);
        dBodySetPosition(body, position[0], position[1], position[2]);
        // as expected exactly, for where the impact is has been found with it
        dSubtractVectors3(turned, dBodyGetTorque(body), torque);
        dxBodySolveInertia(body, turned, turned);
        dAddVectors3(turned, turned, turn);
        dxBodyTurn(body, turned, back * dCalcVectorLength3(turned));
      }
    }
  };

  dWorldID m_world;
  dJointGroupID m_group;
  std::vector<dxEventCable>& m_cables;
  dxForcesOfStep& m_forces;
  std::vector<dCableID> m_ids;
  dReal m_stepsize;  // [s], the whole step
  dReal m_erp;       // the world's
  dStepFunction* m_step;
  void* m_data;
};

/// Steps a world by `stepsize` [s] in at most `max_parts` + 1 calls of `step`; returns how many.
/// The cables' contacts go into `group`, which it empties. Afterwards dCableGetImpulse is the sum
/// over the step.
inline int dStepWithCables(dWorldID world, dJointGroupID group, const dCableID* cables, int count,
                           dReal stepsize, dStepFunction* step, void* data, int max_parts = 8) {
  dxForcesOfStep forces(world, cables, count, stepsize);
  std::vector<dxEventCable> events(cables, cables + count);
  for (dxEventCable& cable : events) {
    cable.begin(stepsize);
  }
  dxEventHost host(world, group, events, forces, stepsize, step, data);
  const int parts = tautline::step_by_events(host, events, stepsize, max_parts);
  for (dxEventCable& cable : events) {
    cable.end();
  }
  forces.finish();
  return parts;
}

// NOLINTEND(modernize-use-nodiscard)

#endif
