// A cable for ODE: massless and inextensible, with restitution, between two bodies or a body and
// the world. ODE has no joint types of a user's own, so a cable is a contact joint without friction
// in each step that it may pull in: it only pulls, and bounces as ODE's contacts do with bounce_vel
// 0: gap rate after the step = -bounce * gap rate before it, measured at the anchors. Header only,
// for C++; double or single precision, as ODE is.
//
//   dCableID cable = dCableCreate();
//   dCableAttach(cable, load, 0);
//   dCableSetAnchor1(cable, x, y, z);  // on the load, and
//   dCableSetAnchor2(cable, x, y, z);  // on the world: where they are now
//   dCableSetLength(cable, length);
//   dCableSetBounce(cable, 0.7);
//   ...
//   dSpaceCollide(space, 0, &nearCallback);                          // in each step, as ever
//   dCableAddContacts(world, contactGroup, &cable, 1, stepsize);
//   dWorldStep(world, stepsize);  // or dWorldQuickStep
//   dJointGroupEmpty(contactGroup);

#ifndef TAUTLINE_ODE_CABLE_H
#define TAUTLINE_ODE_CABLE_H

#include <ode/ode.h>

#include "tautline/cable_rule.h"
#include "tautline/ode/dCableLine.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// Use the functions below. Destroy a cable before its bodies, and not between dCableAddContacts
/// and the end of the step: ODE writes to it there.
struct dxCable {
  dxCableEnd end[2];
  tautline::CableRule<dReal> rule;
  dReal cfm = -1;            // negative: the world's
  dJointFeedback feedback;   // ODE writes to it in a step
  dxCableLine line;          // when its contact was made
  dReal stepsize = 0;        // [s] of a step whose impulse is not read yet; 0: none
  dReal impulse = 0;         // of the last step [N s]
  bool by_events = false;    // while dStepWithCables steps, which sees to the impacts itself
  dReal event_stepsize = 0;  // its whole step [s]
};
typedef dxCable* dCableID;

/// A cable of length 0 between nothing and nothing, without bounce.
inline dCableID dCableCreate() { return new dxCable(); }
inline void dCableDestroy(dCableID cable) { delete cable; }

/// From `body1` to `body2`; 0 is the world. Sets both anchors to the bodies' centres, or the
/// origin.
inline void dCableAttach(dCableID cable, dBodyID body1, dBodyID body2) {
  cable->end[0] = dxCableEnd{body1, {0, 0, 0, 0}};
  cable->end[1] = dxCableEnd{body2, {0, 0, 0, 0}};
}
inline dBodyID dCableGetBody(dCableID cable, int index) { return cable->end[index].body; }

/// Where an end is fastened to its body: a point in world coordinates, as it is now [m].
inline void dCableSetAnchor1(dCableID cable, dReal x, dReal y, dReal z) {
  cable->end[0].fasten(x, y, z);
}
inline void dCableSetAnchor2(dCableID cable, dReal x, dReal y, dReal z) {
  cable->end[1].fasten(x, y, z);
}
/// The anchors in world coordinates, now [m].
inline void dCableGetAnchor1(dCableID cable, dVector3 result) { cable->end[0].position(result); }
inline void dCableGetAnchor2(dCableID cable, dVector3 result) { cable->end[1].position(result); }

/// Longest distance of the anchors [m], >= 0.
inline void dCableSetLength(dCableID cable, dReal length) { cable->rule.length = length; }
inline dReal dCableGetLength(dCableID cable) { return cable->rule.length; }

/// Newton's coefficient of restitution [-], in [0, 1]; 0 unless set.
inline void dCableSetBounce(dCableID cable, dReal bounce) { cable->rule.restitution = bounce; }
inline dReal dCableGetBounce(dCableID cable) { return cable->rule.restitution; }

/// Impacts slower than this do not bounce [m/s]; 0 unless set.
inline void dCableSetBounceVel(dCableID cable, dReal bounce_vel) {
  cable->rule.threshold = bounce_vel;
}
inline dReal dCableGetBounceVel(dCableID cable) { return cable->rule.threshold; }

/// 1: bounce with bounce^2 of the energy of the arrival at zero gap, so that a falling load rises
/// to bounce^2 of its height; the rates before and after the step then differ from `bounce` by
/// gravity's part of them. 0 unless set.
inline void dCableSetBounceByEnergy(dCableID cable, int by_energy) {
  cable->rule.by_energy = by_energy != 0;
}

/// Part of the overstretch that a step takes out while the cable rests taut [-]; 0.2 unless set.
inline void dCableSetERP(dCableID cable, dReal erp) { cable->rule.erp = erp; }
inline dReal dCableGetERP(dCableID cable) { return cable->rule.erp; }

/// CFM of the contact joint; the world's unless set.
inline void dCableSetCFM(dCableID cable, dReal cfm) { cable->cfm = cfm; }

/// The length minus the distance of the anchors, now [m]; negative is overstretch.
inline dReal dCableGetGap(dCableID cable) {
  return cable->rule.length - dxCableLine(cable->end).distance;
}
/// The gap's rate, now [m/s]; negative while the anchors move apart.
inline dReal dCableGetGapRate(dCableID cable) { return dxCableLine(cable->end).rate(cable->end); }

/// Takes over the impulse of a step that is done. The functions below do it by themselves.
inline void dxCableReadImpulse(dCableID cable) {
  // ODE does not step a body that sleeps: its cable pulls as it did
  if (cable->stepsize > 0 && (cable->end[0].is_awake() || cable->end[1].is_awake())) {
    const dReal pull = dCalcVectorDot3(cable->feedback.f1, cable->line.towards);
    const dReal impulse = cable->stepsize * (cable->end[0].body != nullptr ? pull : -pull);
    cable->impulse = impulse > 0 ? impulse : 0;  // the projection may round below zero
    cable->rule.pulled(cable->impulse);
  }
  cable->stepsize = 0;
}

/// The impulse of the last step [N s], >= 0.
inline dReal dCableGetImpulse(dCableID cable) {
  dxCableReadImpulse(cable);
  return cable->impulse;
}
/// 1 if the cable pulled in the last step; else it was slack.
inline int dCableIsTaut(dCableID cable) { return dCableGetImpulse(cable) > 0 ? 1 : 0; }

/// What the cable asks of the step to come, from where its ends are now.
inline tautline::CableRule<dReal>::Row dxCableRow(dCableID cable, const dReal* gravity,
                                                  dReal stepsize) {
  const dxCableLine& line = cable->line;
  if (!(line.distance > 0) || (cable->by_events && !cable->rule.held())) {
    return {false, 0};  // anchors that coincide have no direction to be pulled in
  }
  tautline::CableRule<dReal>::Start start;
  start.gap = cable->rule.length - line.distance;
  start.rate = line.rate(cable->end);
  start.fall = -stepsize * line.acceleration(cable->end, gravity);
  start.dt = stepsize;
  if (cable->by_events) {
    start.dt = stepsize > cable->event_stepsize ? stepsize : cable->event_stepsize;
    return cable->rule.rest(start);  // no faster in a short part
  }
  return cable->rule.step(start);
}

/// Adds a contact joint to `group` for each of `count` cables that may pull in the next step of
/// `stepsize` [s]. Call it once before that step; empty the group after it.
inline void dCableAddContacts(dWorldID world, dJointGroupID group, const dCableID* cables,
                              int count, dReal stepsize) {
  dVector3 gravity;
  dWorldGetGravity(world, gravity);
  dContact contact = dContact();
  for (int index = 0; index < count; ++index) {
    const dCableID cable = cables[index];
    dxCableReadImpulse(cable);
    cable->line.find(cable->end);
    const tautline::CableRule<dReal>::Row row = dxCableRow(cable, gravity, stepsize);
    if (!row.acts) {
      cable->impulse = 0;
      continue;
    }
    // the row is asked for the rate and nothing else; ODE adds its ERP to nothing. A rebound asks
    // as a bounce, which dWorldSetContactMaxCorrectingVel does not limit
    const dReal closing = -cable->line.rate(cable->end);
    const bool rebounds = row.rate > 0 && closing > 0 && !cable->rule.held();
    contact.surface.mode = dContactSoftERP | (rebounds ? dContactBounce : dContactMotionN);
    contact.surface.bounce = rebounds ? row.rate / closing : 0;
    contact.surface.bounce_vel = 0;
    contact.surface.motionN = rebounds ? 0 : row.rate;
    if (cable->cfm >= 0) {
      contact.surface.mode |= dContactSoftCFM;
      contact.surface.soft_cfm = cable->cfm;
    }
    // the normal pushes the joint's first body, which must be one; any point of the line gives
    // both the right torque
    const int first = cable->end[0].body != nullptr ? 0 : 1;
    for (int axis = 0; axis < 3; ++axis) {
      contact.geom.pos[axis] = cable->line.point[first][axis];
      contact.geom.normal[axis] =
          first == 0 ? cable->line.towards[axis] : -cable->line.towards[axis];
    }
    const dJointID joint = dJointCreateContact(world, group, &contact);
    dJointAttach(joint, cable->end[first].body, cable->end[1 - first].body);
    dJointSetFeedback(joint, &cable->feedback);
    cable->stepsize = stepsize;
  }
}

// NOLINTEND(modernize-use-nodiscard)

#endif
