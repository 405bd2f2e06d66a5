// What ODE's users expect of something beside its joints.

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <array>
#include <cmath>

#include "scene.hpp"
#include "tautline/ode/dCable.h"

namespace tautline::test {
namespace {

const dReal stepsize = 1.0 / 60.0;
const dReal weight = 20.0;  // [N]

/// A load of 2 kg that hangs from the origin, overstretched by 0.1 m.
struct Hanging {
  Scene library{0.0};  // ODE is started
  dWorldID world = dWorldCreate();
  dJointGroupID group = dJointGroupCreate(0);
  dBodyID load = dBodyCreate(world);
  dCableID cable = dCableCreate();

  Hanging() {
    dWorldSetGravity(world, 0, -10, 0);
    dMass mass;
    dMassSetSphereTotal(&mass, 2, 0.5);
    dBodySetMass(load, &mass);
    dBodySetPosition(load, 0, -1.1, 0);
  }
  Hanging(const Hanging&) = delete;
  Hanging& operator=(const Hanging&) = delete;
  ~Hanging() {
    dCableDestroy(cable);
    dJointGroupDestroy(group);
    dWorldDestroy(world);
  }
  void step(bool quick = false) const {
    dCableAddContacts(world, group, &cable, 1, stepsize);
    quick ? dWorldQuickStep(world, stepsize) : dWorldStep(world, stepsize);
    dJointGroupEmpty(group);
  }
};

TEST(DCable, PullsWhicheverEndTheBodyIs) {
  for (const bool first : {true, false}) {
    for (const bool quick : {false, true}) {
      const Hanging hanging;
      dCableAttach(hanging.cable, first ? hanging.load : nullptr, first ? nullptr : hanging.load);
      dCableSetLength(hanging.cable, 1);
      hanging.step(quick);
      EXPECT_NEAR(dCableGetGap(hanging.cable), -0.08, 1e-6);  // ERP 0.2
      // stopping the fall, and setting it going at 0.02 m in a step
      EXPECT_NEAR(dCableGetImpulse(hanging.cable), weight * stepsize + 2.0 * 0.02 / stepsize, 1e-5);
    }
  }
}

TEST(DCable, TakesItsErpOutOfTheOverstretch) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dCableSetLength(hanging.cable, 1);
  dCableSetERP(hanging.cable, 0.5);
  hanging.step();
  EXPECT_NEAR(dCableGetGap(hanging.cable), -0.05, 1e-6);
}

TEST(DCable, GivesWithItsCfm) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dCableSetLength(hanging.cable, 1);
  dCableSetERP(hanging.cable, 0);
  const double cfm = 0.1;
  dCableSetCFM(hanging.cable, cfm);
  hanging.step();
  // ODE's row: rate + cfm * force = asked rate
  const double force = dCableGetImpulse(hanging.cable) / stepsize;
  EXPECT_NEAR(dCableGetGapRate(hanging.cable), -cfm * force, 1e-9);
  EXPECT_GT(force, 0.0);
}

TEST(DCable, DoesNotBounceBelowItsBounceVel) {
  for (const double bounce_vel : {1.0, 3.0}) {
    const Hanging hanging;
    dCableAttach(hanging.cable, hanging.load, nullptr);
    dCableSetLength(hanging.cable, 1);
    dCableSetBounce(hanging.cable, 0.5);
    dCableSetBounceVel(hanging.cable, bounce_vel);
    dBodySetLinearVel(hanging.load, 0, -2, 0);
    hanging.step();
    EXPECT_NEAR(dCableGetGapRate(hanging.cable), bounce_vel < 2.0 ? 1.0 : 0.0, 1e-5);
  }
}

TEST(DCable, BouncesAsFastAsItAskedWhateverContactsMayCorrect) {
  for (const int by_energy : {0, 1}) {
    for (const bool quick : {false, true}) {
      std::array<double, 2> after{};
      for (const bool limited : {false, true}) {
        const Hanging hanging;
        if (limited) {
          dWorldSetContactMaxCorrectingVel(hanging.world, 0.1);  // as ODE's demos
        }
        dCableAttach(hanging.cable, hanging.load, nullptr);
        dCableSetAnchor1(hanging.cable, 0.3, -1.1, 0);  // off its centre, in either order
        dCableSetAnchor2(hanging.cable, 0.3, 0, 0);
        dCableSetLength(hanging.cable, 1.09);
        dCableSetBounce(hanging.cable, 0.8);
        dCableSetBounceByEnergy(hanging.cable, by_energy);
        dBodySetLinearVel(hanging.load, 0, -3.289, 0);
        hanging.step(quick);
        after[limited ? 1 : 0] = dCableGetGapRate(hanging.cable);
        if (by_energy == 0) {
          // on the line after the step, which has turned by some hundredths
          EXPECT_NEAR(
              dBodyGetLinearVel(hanging.load)[1] + 0.3 * dBodyGetAngularVel(hanging.load)[2],
              0.8 * 3.289, 1e-5);
        }
      }
      EXPECT_GT(after[0], 2.0);
      EXPECT_NEAR(after[1], after[0], 1e-9);
    }
  }
}

TEST(DCable, KeepsItsAnchorsOnTheirBodies) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dCableSetAnchor1(hanging.cable, 0.5, -1.1, 0);
  dCableSetAnchor2(hanging.cable, 0, 0, 1);
  dBodySetPosition(hanging.load, 1, 0, 0);
  dVector3 at;
  dCableGetAnchor1(hanging.cable, at);
  EXPECT_NEAR(at[0], 1.5, 1e-12);
  EXPECT_NEAR(at[1], 0.0, 1e-12);
  dCableGetAnchor2(hanging.cable, at);
  EXPECT_NEAR(at[2], 1.0, 1e-12);
}

}  // namespace
}  // namespace tautline::test
