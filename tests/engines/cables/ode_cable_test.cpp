// What ODE's users expect of something beside its joints.

#include <gtest/gtest.h>
#include <ode/ode.h>

#include <array>
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engines/cables/scene.hpp"
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
      EXPECT_NEAR(dCableGetGap(hanging.cable), -0.1 + 1.0 / 60.0, 1e-6);  // at 1 m/s
      EXPECT_NEAR(dCableGetImpulse(hanging.cable), weight * stepsize, 1e-5);
    }
  }
}

TEST(DCable, TakesItsErpOutOfTheOverstretchWithoutVelocity) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dCableSetLength(hanging.cable, 1);
  dCableSetERP(hanging.cable, 0.5);
  dCableSetMaxCorrectionSpeed(hanging.cable, 100);
  hanging.step();
  EXPECT_NEAR(dCableGetGap(hanging.cable), -0.05, 1e-6);
  EXPECT_NEAR(dBodyGetLinearVel(hanging.load)[1], 0.0, 1e-9);
}

#ifdef NDEBUG
TEST(DCable, ClampsWhatMakesNoSense) {
  const Hanging hanging;
  dCableSetBounce(hanging.cable, 1.5);
  EXPECT_EQ(dCableGetBounce(hanging.cable), 1.0);
  dCableSetBounce(hanging.cable, -0.5);
  EXPECT_EQ(dCableGetBounce(hanging.cable), 0.0);
  dCableSetLength(hanging.cable, -1.0);
  EXPECT_EQ(dCableGetLength(hanging.cable), 0.0);
  dCableSetElasticity(hanging.cable, CableElasticity(-1.0));
  EXPECT_TRUE(dCableGetElasticity(hanging.cable).stiffness.empty());
}
#else
TEST(DCableDeathTest, AssertsOnWhatMakesNoSense) {
  const Hanging hanging;
  EXPECT_DEATH(dCableSetBounce(hanging.cable, 1.5), "value <= 1");
  EXPECT_DEATH(dCableSetLength(hanging.cable, -1.0), "value >= 0");
  EXPECT_DEATH(dCableSetElasticity(hanging.cable, CableElasticity(-1.0)), "problem");
}
#endif

TEST(DCable, SaysWhatIsWrongWithAnElasticity) {
  const auto problem_of = [](std::vector<double> stiffness, double damping, double ratio) {
    CableElasticity law;
    law.stiffness = std::move(stiffness);
    law.damping = damping;
    law.damping_ratio = ratio;
    const char* problem = law.problem();
    return std::string(problem != nullptr ? problem : "");
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem_of({}, 0.0, 0.0), "");
  EXPECT_EQ(problem_of({1e4, 0.0, 2e5}, 0.0, 0.1), "");
  for (const double stiffness : {-1.0, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(problem_of({1e4, stiffness}, 0.0, 0.0),
              "each stiffness of an elastic cable must be a finite number of at least 0");
  }
  EXPECT_EQ(problem_of({0.0, 1.0}, 0.0, 0.0),
            "the first stiffness of an elastic cable must be above 0 N/m");
  for (const double damping : {-1.0, nan}) {
    EXPECT_EQ(problem_of({1e4}, damping, 0.0),
              "the damping of an elastic cable must be a finite number of at least 0");
    EXPECT_EQ(problem_of({1e4}, 0.0, damping),
              "the damping of an elastic cable must be a finite number of at least 0");
  }
  EXPECT_EQ(problem_of({1e4}, 1.0, 0.1),
            "an elastic cable must have a damping or a damping ratio, not both");
  EXPECT_EQ(problem_of({}, 1.0, 0.0), "a cable with damping must have a stiffness");
}

TEST(DCable, FindsTheDampingRatioOfARestitution) {
  // the inverse of (E6), to 20 digits
  EXPECT_NEAR(cable_damping_ratio(0.95), 0.016498230920168432463, 1e-14);
  EXPECT_NEAR(cable_damping_ratio(0.5), 0.25527563764865180659, 1e-14);
  EXPECT_NEAR(cable_damping_ratio(std::exp(-2.0)), 1.0, 1e-6);  // the root of the law is there
  EXPECT_EQ(cable_damping_ratio(1.0), 0.0);
  EXPECT_TRUE(std::isinf(cable_damping_ratio(0.0)));
}

TEST(DCable, HaulsAsAWinch) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dBodySetPosition(hanging.load, 0, -1, 0);
  dCableSetLength(hanging.cable, 1);
  dCableSetLengthRate(hanging.cable, -0.5);
  for (int step = 0; step < 60; ++step) {
    hanging.step();
  }
  EXPECT_NEAR(dCableGetLength(hanging.cable), 0.5, 1e-9);
  EXPECT_NEAR(dBodyGetPosition(hanging.load)[1], -0.5, 1e-3);
  EXPECT_NEAR(dBodyGetLinearVel(hanging.load)[1], 0.5, 1e-6);
  EXPECT_NEAR(dCableGetImpulse(hanging.cable), weight * stepsize, 1e-6);
}

TEST(DCable, BreaksAtItsImpulse) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dCableSetLength(hanging.cable, 1);
  dCableSetBreakingImpulse(hanging.cable, 0.1);  // a step's weight is 0.33 N s
  for (int step = 0; step < 10; ++step) {
    hanging.step();
  }
  EXPECT_EQ(dCableIsBroken(hanging.cable), 1);
  EXPECT_LT(dBodyGetLinearVel(hanging.load)[1], -1.0);
  EXPECT_EQ(dCableGetImpulse(hanging.cable), 0.0);
}

TEST(DCable, ReboundsAgainOnceItIsMended) {
  const Hanging hanging;
  dCableAttach(hanging.cable, hanging.load, nullptr);
  dCableSetLength(hanging.cable, 1);
  dCableSetBreakingImpulse(hanging.cable, 0.1);
  hanging.step();
  hanging.step();
  EXPECT_EQ(dCableIsBroken(hanging.cable), 1);
  dWorldSetGravity(hanging.world, 0, 0, 0);
  dBodySetPosition(hanging.load, 0, -0.999, 0);
  dBodySetLinearVel(hanging.load, 0, -0.15, 0);
  dCableSetBounce(hanging.cable, 1);
  hanging.step();  // broken, it learns that it is slack
  dCableSetBreakingImpulse(hanging.cable, 10);
  dCableMend(hanging.cable);
  hanging.step();
  EXPECT_NEAR(dBodyGetLinearVel(hanging.load)[1], 0.15, 1e-9);
}

/// Forces and contact joints are two ways to the same step, of a tumbling load on four cables.
TEST(DCable, PullsAlikeByForceAndByContact) {
  std::array<std::array<dReal, 6>, 2> after{};
  for (const bool as_contact : {false, true}) {
    const Hanging hanging;
    dMass mass;
    dMassSetParameters(&mass, 2, 0, 0, 0, 0.02, 0.05, 0.08, 0, 0, 0);
    dBodySetMass(hanging.load, &mass);
    dBodySetPosition(hanging.load, 0, -1.1, 0);
    dBodySetLinearVel(hanging.load, 0.3, -2, 0.1);
    dBodySetAngularVel(hanging.load, 3, -2, 4);
    dWorldSetCFM(hanging.world, 0);
    std::array<dCableID, 4> cables{};
    for (std::size_t index = 0; index < cables.size(); ++index) {
      const dReal x = index % 2 == 0 ? 0.2 : -0.2;
      const dReal z = index < 2 ? 0.2 : -0.2;
      cables[index] = dCableCreate();
      dCableAttach(cables[index], hanging.load, nullptr);
      dCableSetAnchor1(cables[index], x, -1, z);
      dCableSetAnchor2(cables[index], 2 * x, 0, z);
      dCableSetLength(cables[index], 1);
      dCableSetBounce(cables[index], 0.7);
      dCableSetAsContact(cables[index], as_contact ? 1 : 0);
    }
    dCableAddContacts(hanging.world, hanging.group, cables.data(), 4, stepsize);
    EXPECT_EQ(dBodyGetNumJoints(hanging.load) > 0, as_contact);
    dWorldStep(hanging.world, stepsize);
    dJointGroupEmpty(hanging.group);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      after[as_contact ? 1 : 0][axis] = dBodyGetLinearVel(hanging.load)[axis];
      after[as_contact ? 1 : 0][3 + axis] = dBodyGetAngularVel(hanging.load)[axis];
    }
    for (const dCableID cable : cables) {
      dCableDestroy(cable);
    }
  }
  for (std::size_t index = 0; index < 6; ++index) {
    EXPECT_NEAR(after[0][index], after[1][index], 1e-9) << index;
  }
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

/// A hook that the user moves by its place has no velocity. Its load sleeps.
TEST(DCable, GoesUpWithAHookThatIsMovedByItsPlace) {
  const Hanging hanging;
  const dBodyID hook = dBodyCreate(hanging.world);
  dBodySetKinematic(hook);
  dBodySetPosition(hanging.load, 0, -1, 0);
  dCableAttach(hanging.cable, hanging.load, hook);
  dCableSetLength(hanging.cable, 1);
  dBodySetAutoDisableFlag(hanging.load, 1);
  dBodySetAutoDisableFlag(hook, 1);  // or ODE keeps awake what is jointed to it
  for (int step = 1; step <= 300; ++step) {
    hanging.step();
  }
  EXPECT_EQ(dBodyIsEnabled(hanging.load), 0);
  for (int step = 1; step <= 120; ++step) {
    dBodySetPosition(hook, 0, 0.5 * step / 60.0, 0);
    hanging.step();
  }
  EXPECT_NEAR(dBodyGetPosition(hanging.load)[1], 0.0,
              0.06);  // led by its place, it lags some steps
  for (int step = 1; step <= 300; ++step) {
    hanging.step();
  }
  EXPECT_NEAR(dBodyGetPosition(hanging.load)[1], 0.0, 1e-3);
}

int messages = 0;

extern "C" {
void count_message(int /*number*/, const char* /*format*/, va_list /*arguments*/) { ++messages; }
}

/// Boxes on a floor without friction, one behind the other, the first of them on its way.
void tow_boxes(int count, double restitution, double speed) {
  const Scene library{0.0};
  const dWorldID world = dWorldCreate();
  const dJointGroupID group = dJointGroupCreate(0);
  dWorldSetGravity(world, 0, -9.81, 0);
  const dSpaceID space = dSimpleSpaceCreate(nullptr);
  dCreatePlane(space, 0, 1, 0, 0);
  std::vector<dBodyID> boxes;
  std::vector<dCableID> cables;
  for (int index = 0; index < count; ++index) {
    const dBodyID box = dBodyCreate(world);
    dMass mass;
    dMassSetBoxTotal(&mass, 1000.0 * (index + 1), 4, 1, 2);
    dBodySetMass(box, &mass);
    dBodySetPosition(box, -8.0 * index, 0.5, 0);
    dGeomSetBody(dCreateBox(space, 4, 1, 2), box);
    boxes.push_back(box);
    if (index > 0) {
      const dCableID cable = dCableCreate();
      dCableAttach(cable, boxes[boxes.size() - 2], box);
      dCableSetAnchor1(cable, -8.0 * index + 6.0, 0.5, 0);
      dCableSetAnchor2(cable, -8.0 * index + 2.0, 0.5, 0);
      dCableSetLength(cable, 5);
      dCableSetBounce(cable, restitution);
      cables.push_back(cable);
    }
  }
  dBodySetLinearVel(boxes.front(), speed, 0, 0);
  struct Near {
    dWorldID world;
    dJointGroupID group;
  } near{world, group};
  for (int step = 0; step < 600; ++step) {
    dSpaceCollide(space, &near, [](void* data, dGeomID one, dGeomID two) {
      const Near& here = *static_cast<Near*>(data);
      std::array<dContact, 8> contacts{};
      const int found = dCollide(one, two, 8, &contacts[0].geom, sizeof(dContact));
      for (std::size_t index = 0; index < static_cast<std::size_t>(found); ++index) {
        dJointAttach(dJointCreateContact(here.world, here.group, &contacts[index]),
                     dGeomGetBody(one), dGeomGetBody(two));
      }
    });
    dCableAddContacts(world, group, cables.data(), static_cast<int>(cables.size()), stepsize);
    dWorldStep(world, stepsize);
    dJointGroupEmpty(group);
  }
  double momentum = 0.0;
  for (int index = 0; index < count; ++index) {
    momentum += 1000.0 * (index + 1) * dBodyGetLinearVel(boxes[static_cast<std::size_t>(index)])[0];
  }
  EXPECT_NEAR(momentum, 1000.0 * speed, 1e-3);
  for (const dCableID cable : cables) {
    dCableDestroy(cable);
  }
  dJointGroupDestroy(group);
  dSpaceDestroy(space);
  dWorldDestroy(world);
}

TEST(DCable, TowsWithoutTensionAndWithoutOdesMessages) {
  const Scene library{0.0};
  dMessageFunction* const usual = dGetMessageHandler();
  dSetMessageHandler(count_message);
  for (const int count : {2, 3}) {
    for (const double restitution : {0.0, 0.5}) {
      messages = 0;
      tow_boxes(count, restitution, 5.0);
      // an impact of several contacts and cables may still cause some: nothing like one a step
      EXPECT_LE(messages, 10) << count << " boxes, restitution " << restitution;
    }
  }
  dSetMessageHandler(usual);
}

}  // namespace
}  // namespace tautline::test
