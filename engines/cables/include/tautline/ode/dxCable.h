// What a cable of dCable.h is, and what it asks of a step.

#ifndef TAUTLINE_ODE_DX_CABLE_H
#define TAUTLINE_ODE_DX_CABLE_H

#include <ode/ode.h>

#include <algorithm>
#include <memory>

#include "tautline/cable_block.h"
#include "tautline/cable_rule.h"
#include "tautline/cable_spring.h"
#include "tautline/ode/dCableLine.h"

class dxCableSolve;

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// Use the functions of dCable.h. Destroy a cable before its bodies, and not between
/// dCableAddContacts and the end of the step: ODE writes to it there.
struct dxCable {
  typedef tautline::CableRule<dReal> Rule;

  dxCableEnd end[2];
  Rule rule;
  tautline::CableSpring spring;        // of an elastic cable; the rule has its length alone
  dReal cfm = -1;                      // negative: the world's
  dReal breaking = dInfinity;          // impulse [N s]
  dReal breaking_tension = dInfinity;  // outside of impacts [N]
  bool broken = false;
  bool as_contact = false;  // never by force
  int out_of_parts = 0;     // steps

  // of the step
  dxCableLine line;  // before it
  dxMotion free[2];  // of its ends, if no cable pulls
  Rule::Row row = {false, 0};
  double compliance = 0;           // of an elastic cable's row [1/kg]
  dReal length_rate = 0;           // [m/s]
  dReal aimed_distance = 0;        // of the anchors, by the correction [m]
  dReal correction = 0;            // [m]
  dReal inverse_mass = 0;          // [1/kg]
  dReal impulse = 0;               // [N s]
  dReal of_impacts = 0;            // so much of it, or all if it is less [N s]
  dReal taut_time = 0;             // that the rest of it acted for [s]
  dReal stepsize = 0;              // [s] of a step whose contact is not read yet; 0: none
  dJointFeedback feedback;         // ODE writes to it in a step
  bool by_events = false;          // while dStepWithCables steps, which sees to the impacts itself
  dReal event_stepsize = 0;        // its whole step [s]
  bool driven_is_known = false;    // the next two, of its last step
  dReal driven_length_rate = 0;    // [m/s]
  dVector3 driven = {0, 0, 0, 0};  // of the anchors by hooks, that of 1 relative to 2 [m/s]
  std::shared_ptr<dxCableSolve> solve;  // of the calls in which it is the first

  void wake() const {
    for (const dxCableEnd& one : end) {
      if (one.is_moved()) {
        dBodyEnable(one.body);
      }
    }
  }
  /// A hook that was moved by its place has no velocity to see.
  void wake_if_led() const {
    for (int side = 0; side < 2; ++side) {
      if (end[side].body != nullptr && !end[side].is_moved()) {
        dVector3 now;
        end[side].position(now);
        dSubtractVectors3(now, now, line.point[side]);
        if (dCalcVectorLengthSquare3(now) > 0) {
          wake();
        }
      }
    }
  }
  void wake_if_wound() const {
    if (rule.length_rate != 0) {
      wake();
    }
  }

  /// Sets the row of the step that begins as `at` says, and winds the winch on.
  void ask(const Rule::Start& at) {
    length_rate = rule.length_rate;
    driven_is_known = driven_is_known && by_events;
    if (spring.is_elastic()) {
      ask_elastic(at);
    } else {
      ask_inextensible(at);
    }
    rule.pay_out(at.dt);
  }

  /// Anchors that coincide have no direction to be pulled in.
  bool has_line() const { return line.distance > 0 && end[0].body != end[1].body; }

  void set_row(const tautline::CableSpring::Row& of) {
    row = Rule::Row{of.acts && has_line() && !broken, static_cast<dReal>(of.rate)};
    compliance = of.compliance;
  }
  void ask_elastic(const Rule::Start& at) {
    tautline::CableBlock::Row ends;
    fill(ends);
    set_row(spring.step(tautline::CableSpring::Start(at, ends.inverse_mass(), by_events)));
    if (broken) {
      spring.forget();
    }
    of_impacts = 0;
    taut_time = row.acts ? at.dt : dReal(0);
    correction = -line.distance;  // the others' may stretch it
  }

  void ask_inextensible(const Rule::Start& at) {
    const bool impact = !by_events && rule.is_impact(at);
    if (broken) {
      rule.release();
      row = Rule::Row{false, 0};
    } else if (!has_line()) {
      row = Rule::Row{false, 0};
    } else if (by_events) {
      if (!rule.touches(at.gap)) {
        rule.release();
      }
      row = rule.held() ? rule.step_by_events(at) : Rule::Row{false, 0};
    } else {
      row = rule.step(at);
    }
    // in a fixed step, all of the impulse or nothing
    of_impacts = row.acts && (impact || !rule.held()) ? dInfinity : dReal(0);
    taut_time = row.acts ? at.dt : dReal(0);
    // a short part takes out no more than its share
    const dReal share = by_events ? std::min(at.dt / event_stepsize, dReal(1)) : dReal(1);
    correction = share * rule.correction(at);
    if (correction > Rule::slack_rounding() * rule.length) {
      wake();  // it is moved without velocity
    }
  }

  void fill(tautline::CableBlock::Row& to) const {
    for (int side = 0; side < 2; ++side) {
      tautline::CableBlockEnd& one = to.end[side];
      one.body = end[side].is_moved() ? end[side].body : nullptr;
      if (one.body != nullptr) {
        dMass mass;
        dBodyGetMass(end[side].body, &mass);
        one.arm = dCalcVectorLength3(line.arm[side]);
        dVector3 turn;
        dxBodySolveInertia(end[side].body, mass, line.moment[side], turn);
        const dReal sign = side == 0 ? dReal(1) : dReal(-1);
        for (int axis = 0; axis < 3; ++axis) {
          one.pull[axis] = sign * line.towards[axis];
          one.moment[axis] = sign * line.moment[side][axis];
          one.move[axis] = sign * line.towards[axis] / mass.mass;
          one.turn[axis] = sign * turn[axis];
        }
      }
    }
    to.softness = 0;
    to.compliance = 0;
  }

  void pulled(dReal by) {
    impulse = by;
    if (spring.is_elastic()) {
      spring.pulled(by);
    } else {
      rule.pulled(by, inverse_mass);
    }
    broken = broken || by >= breaking || (!by_events && taut_tension() >= breaking_tension);
  }

  dReal impact_impulse() const { return std::min(of_impacts, impulse); }  // [N s]
  /// [N]; 0 if it was not taut.
  dReal taut_tension() const {
    return taut_time > 0 ? (impulse - impact_impulse()) / taut_time : dReal(0);
  }
};
typedef dxCable* dCableID;  // as ODE's own handles

/// Takes over the impulse of a contact in a step that is done. All that read it do so
/// first.
inline void dxCableReadImpulse(dCableID cable) {
  // ODE does not step a body that sleeps: its cable pulls as it did
  if (cable->stepsize > 0 && (cable->end[0].is_awake() || cable->end[1].is_awake())) {
    const dReal pull = dCalcVectorDot3(cable->feedback.f1, cable->line.towards);
    const dReal impulse = cable->stepsize * (cable->end[0].body != nullptr ? pull : -pull);
    cable->pulled(impulse > 0 ? impulse : 0);  // the projection may round below zero
  }
  cable->stepsize = 0;
}

// NOLINTEND(modernize-use-nodiscard)

#endif
