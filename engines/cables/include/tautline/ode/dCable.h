// A cable for ODE: massless, inextensible with restitution or elastic, between two bodies or a body
// and the world. ODE has no joint types of a user's own, so a cable acts by forces, or by a contact
// joint without friction, in each step that it may pull in: it only pulls, and bounces as ODE's
// contacts do with bounce_vel 0: gap rate after the step = -bounce * gap rate before it, measured
// at the anchors. Header only, for C++; double or single precision, as ODE is.
// docs/guides/cables.md says what it guarantees.
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

#include <algorithm>
#include <cassert>
#include <memory>

#include "tautline/ode/dCableLine.h"
#include "tautline/ode/dCableSolve.h"
#include "tautline/ode/dxCable.h"

// NOLINTBEGIN(modernize-use-nodiscard): C++11 does not know it

/// What a setter does with a value that makes no sense: the debug build of a program stops.
inline dReal dxCableAtLeast0(dReal value) {
  assert(value >= 0);  // nor NaN
  return value >= 0 ? value : dReal(0);
}
inline dReal dxCablePart(dReal value) {
  assert(value >= 0 && value <= 1);
  return value >= 0 ? std::min(value, dReal(1)) : dReal(0);
}

/// A cable of length 0 between nothing and nothing, without bounce.
inline dCableID dCableCreate() { return new dxCable(); }
inline void dCableDestroy(dCableID cable) { delete cable; }  // its bodies stay

/// From `body1` to `body2`; 0 is the world. Sets both anchors to the bodies' centres, or the
/// origin.
inline void dCableAttach(dCableID cable, dBodyID body1, dBodyID body2) {
  assert(body1 == nullptr || body1 != body2);
  cable->end[0] = dxCableEnd(body1);
  cable->end[1] = dxCableEnd(body2);
}
/// The body at end 0 or 1; null is the world.
inline dBodyID dCableGetBody(dCableID cable, int index) { return cable->end[index].body; }

/// Where an end is fastened to its body: a point in world coordinates, as it is now [m]. Wakes the
/// bodies.
inline void dCableSetAnchor1(dCableID cable, dReal x, dReal y, dReal z) {
  cable->end[0].fasten(x, y, z);
  cable->spring.forget();
  cable->wake();
}
/// The same for the other end.
inline void dCableSetAnchor2(dCableID cable, dReal x, dReal y, dReal z) {
  cable->end[1].fasten(x, y, z);
  cable->spring.forget();
  cable->wake();
}
/// The anchors in world coordinates, now [m].
inline void dCableGetAnchor1(dCableID cable, dVector3 result) { cable->end[0].position(result); }
/// The same for the other end.
inline void dCableGetAnchor2(dCableID cable, dVector3 result) { cable->end[1].position(result); }

/// Longest distance of the anchors [m], >= 0. Another length wakes the bodies.
inline void dCableSetLength(dCableID cable, dReal length) {
  length = dxCableAtLeast0(length);
  cable->spring.set_length(cable->rule.length, length);
  cable->rule.length = length;
  cable->wake();
}
inline dReal dCableGetLength(dCableID cable) { return cable->rule.length; }  // [m]

/// A winch: the rate at which steps from now on pay the cable out, or, if negative, haul it in,
/// down to a length of 0 [m/s]; 0 unless set. An impact counts the speed relative to the length.
/// While it runs its bodies do not fall asleep.
inline void dCableSetLengthRate(dCableID cable, dReal rate) {
  assert(rate - rate == 0);  // finite
  cable->rule.length_rate = rate - rate == 0 ? rate : dReal(0);
  cable->wake();
}
inline dReal dCableGetLengthRate(dCableID cable) { return cable->rule.length_rate; }  // [m/s]

/// Newton's coefficient of restitution [-]; 0 unless set. What is outside [0, 1] asserts, and is
/// clamped.
inline void dCableSetBounce(dCableID cable, dReal bounce) {
  cable->rule.restitution = dxCablePart(bounce);
}
inline dReal dCableGetBounce(dCableID cable) { return cable->rule.restitution; }  // [-]

/// Impacts slower than this do not bounce [m/s], >= 0; 0 unless set.
inline void dCableSetBounceVel(dCableID cable, dReal bounce_vel) {
  cable->rule.threshold = dxCableAtLeast0(bounce_vel);
}
inline dReal dCableGetBounceVel(dCableID cable) { return cable->rule.threshold; }  // [m/s]

/// Lets the cable stretch beyond its length, by the law and the scheme of tautline/cable_spring.h;
/// inextensible unless set, or without stiffness. Bounce, its bounce_vel, bounce by energy, ERP and
/// CFM say nothing to an elastic cable: it has no impacts, and its snap is in dCableGetTautTension
/// and dCableSetBreakingTension. A law with a `problem` asserts, and changes nothing. Wakes the
/// bodies.
inline void dCableSetElasticity(dCableID cable, const tautline::CableElasticity& elasticity) {
  assert(elasticity.problem() == nullptr);
  if (elasticity.problem() == nullptr) {
    cable->spring.set(elasticity);
    cable->wake();
  }
}
/// As it was set.
inline const tautline::CableElasticity& dCableGetElasticity(dCableID cable) {
  return cable->spring.law();
}

/// An impulse of a step as large as this breaks the cable [N s], >= 0; none unless set. It then
/// pulls no more, until dCableMend.
inline void dCableSetBreakingImpulse(dCableID cable, dReal impulse) {
  cable->breaking = dxCableAtLeast0(impulse);
}
/// [N s]; infinity unless set.
inline dReal dCableGetBreakingImpulse(dCableID cable) { return cable->breaking; }

/// A tension outside of impacts, dCableGetTautTension, as large as this breaks the cable [N], >= 0;
/// none unless set. It does not see impacts: where a cable that does not stretch goes taut, its
/// tension has no largest value. dCableSetBreakingImpulse sees those.
inline void dCableSetBreakingTension(dCableID cable, dReal tension) {
  cable->breaking_tension = dxCableAtLeast0(tension);
}
/// [N]; infinity unless set.
inline dReal dCableGetBreakingTension(dCableID cable) { return cable->breaking_tension; }
inline void dCableMend(dCableID cable) { cable->broken = false; }  // holds again

/// The speed at which overstretch is taken out, at most, unless the ends themselves are faster
/// [m/s], >= 0; 1 unless set.
inline void dCableSetMaxCorrectionSpeed(dCableID cable, dReal speed) {
  cable->rule.correction_speed = dxCableAtLeast0(speed);
}
/// [m/s].
inline dReal dCableGetMaxCorrectionSpeed(dCableID cable) { return cable->rule.correction_speed; }

/// 1: a contact joint in every step in which it may pull, never forces; see dCableSolve.h. For
/// programs that make contacts after dCableAddContacts. 0 unless set.
inline void dCableSetAsContact(dCableID cable, int as_contact) {
  cable->as_contact = as_contact != 0;
}

/// How many steps by events (dStepWithCables) ran out of parts and ended as a fixed step.
inline int dCableGetStepsOutOfParts(dCableID cable) { return cable->out_of_parts; }

/// 1: bounce with bounce^2 of the energy of the arrival at zero gap, so that a falling load rises
/// to bounce^2 of its height; the rates before and after the step then differ from `bounce` by
/// gravity's part of them. 0 unless set.
inline void dCableSetBounceByEnergy(dCableID cable, int by_energy) {
  cable->rule.by_energy = by_energy != 0;
}

/// Part of the overstretch that a step takes out while the cable rests taut [-]; 0.2 unless set.
inline void dCableSetERP(dCableID cable, dReal erp) { cable->rule.erp = dxCablePart(erp); }
inline dReal dCableGetERP(dCableID cable) { return cable->rule.erp; }  // [-]

/// ODE's CFM of the cable [1/kg s], >= 0; unless set the world's where it is a contact joint, and
/// none where it pulls by force.
inline void dCableSetCFM(dCableID cable, dReal cfm) { cable->cfm = dxCableAtLeast0(cfm); }

/// The length minus the distance of the anchors, now [m]; negative is overstretch.
inline dReal dCableGetGap(dCableID cable) {
  return cable->rule.length - dxCableLine(cable->end).distance;
}
/// The gap's rate, now [m/s]; negative while the anchors move apart faster than the cable is paid
/// out.
inline dReal dCableGetGapRate(dCableID cable) {
  return dxCableLine(cable->end).rate(cable->end) + cable->rule.length_rate;
}

/// The impulse of the last step [N s], >= 0.
inline dReal dCableGetImpulse(dCableID cable) {
  dxCableReadImpulse(cable);
  return cable->impulse;
}
/// 1 if the cable pulled in the last step; else it was slack.
inline int dCableIsTaut(dCableID cable) { return dCableGetImpulse(cable) > 0 ? 1 : 0; }

/// The impulse of the last step's impacts [N s]: in a fixed step all of its impulse, if it or a
/// cable that hangs together with it went taut there, or was jerked; by events that of the instants
/// in which cables went taut.
inline dReal dCableGetImpactImpulse(dCableID cable) {
  dxCableReadImpulse(cable);
  return cable->impact_impulse();
}
/// Tension of the rest of the last step [N]: its mean over the time in which the cable was held
/// taut. 0 where it was not, as in a fixed step with an impact.
inline dReal dCableGetTautTension(dCableID cable) {
  dxCableReadImpulse(cable);
  return cable->taut_tension();
}

/// The largest tension of a step since an elastic cable became stretched last [N]; 0 if
/// inextensible.
inline dReal dCableGetPeakTension(dCableID cable) {
  dxCableReadImpulse(cable);
  return static_cast<dReal>(cable->spring.peak());
}

/// 1 if an impulse or a tension has broken it.
inline int dCableIsBroken(dCableID cable) {
  dxCableReadImpulse(cable);
  return cable->broken ? 1 : 0;
}

/// Lets each of `count` cables that may pull in the next step of `stepsize` [s] do so: by forces,
/// or by a contact joint in `group`. Call it once before that step, with all cables, after the
/// collisions and after the user's forces; empty the group after the step.
inline void dCableAddContacts(dWorldID world, dJointGroupID group, const dCableID* cables,
                              int count, dReal stepsize) {
  if (count > 0) {
    if (!cables[0]->solve) {
      cables[0]->solve = std::make_shared<dxCableSolve>();
    }
    cables[0]->solve->add_contacts(world, group, cables, count, stepsize);
  }
}

// NOLINTEND(modernize-use-nodiscard)

#endif
