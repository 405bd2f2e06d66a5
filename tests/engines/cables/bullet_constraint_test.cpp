// What Bullet's users expect of a constraint of its world.

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

#include "tautline/bullet/btCableConstraint.h"
#include "tautline/bullet/btStepWithCables.h"

namespace {

const btScalar time_step = btScalar(1) / 60;
const btScalar weight = 20;  // [N]

/// A load of 2 kg that hangs from the origin, overstretched by 0.1 m.
struct Hanging {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btSphereShape shape{btScalar(0.1)};
  btRigidBody load{
      btRigidBody::btRigidBodyConstructionInfo(2, nullptr, &shape, btVector3(1, 1, 1))};
  btCableConstraint cable{load, btVector3(0, 0, 0), btVector3(0, 0, 0), 1};

  Hanging() {
    world.setGravity(btVector3(0, -10, 0));
    load.setWorldTransform(
        btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(-1.1), 0)));
    world.addRigidBody(&load);
    world.addConstraint(&cable);
  }
  Hanging(const Hanging&) = delete;
  Hanging& operator=(const Hanging&) = delete;
  ~Hanging() {
    world.removeConstraint(&cable);
    world.removeRigidBody(&load);
  }
};

TEST(BtCableConstraint, KeepsItsParameters) {
  Hanging hanging;
  btCableConstraint& cable = hanging.cable;
  EXPECT_FLOAT_EQ(static_cast<float>(cable.getParam(BT_CONSTRAINT_ERP)), 0.2F);
  cable.setParam(BT_CONSTRAINT_ERP, btScalar(0.5));
  cable.setParam(BT_CONSTRAINT_CFM, btScalar(0.25));
  cable.setRestitution(btScalar(0.75));
  cable.setRestitutionThreshold(btScalar(0.125));
  cable.setMaxLength(3);
  EXPECT_EQ(cable.getParam(BT_CONSTRAINT_ERP), btScalar(0.5));
  EXPECT_EQ(cable.getParam(BT_CONSTRAINT_CFM), btScalar(0.25));
  EXPECT_EQ(cable.getRestitution(), btScalar(0.75));
  EXPECT_EQ(cable.getRestitutionThreshold(), btScalar(0.125));
  EXPECT_EQ(cable.getMaxLength(), 3);
}

TEST(BtCableConstraint, TakesItsErpOutOfTheOverstretch) {
  Hanging hanging;
  hanging.cable.setParam(BT_CONSTRAINT_ERP, btScalar(0.5));
  hanging.cable.setMaxCorrectionSpeed(100);
  const double before = hanging.cable.getGap();
  hanging.world.stepSimulation(time_step);
  EXPECT_NEAR(hanging.cable.getGap(), 0.5 * before, 1e-6);
}

TEST(BtCableConstraint, TakesItsOverstretchOutNoFasterThanAllowedAndWithoutVelocity) {
  Hanging hanging;
  hanging.cable.setMaxCorrectionSpeed(btScalar(0.3));
  for (int step = 1; step <= 5; ++step) {
    hanging.world.stepSimulation(time_step);
    EXPECT_NEAR(hanging.cable.getGap(), -0.1 + 0.3 * step / 60.0, 1e-5);
    EXPECT_NEAR(hanging.load.getLinearVelocity().length(), 0.0, 1e-5);
    EXPECT_NEAR(hanging.cable.getTension(time_step), weight, 1e-3);
  }
}

TEST(BtCableConstraint, ThrowsNothingThatStartsFarTooLow) {
  Hanging hanging;
  hanging.load.setWorldTransform(
      btTransform(btQuaternion::getIdentity(), btVector3(0, -6, 0)));  // 5 m
  for (int step = 0; step < 600; ++step) {
    hanging.world.stepSimulation(time_step);
    EXPECT_LE(hanging.load.getLinearVelocity().length(), 1e-4) << "step " << step;
  }
  EXPECT_NEAR(hanging.cable.getGap(), 0.0, 1e-4);
}

TEST(BtCableConstraint, ClampsWhatMakesNoSense) {
  Hanging hanging;
  btCableConstraint& cable = hanging.cable;
  cable.setRestitution(btScalar(1.5));
  EXPECT_EQ(cable.getRestitution(), 1);
  cable.setRestitution(btScalar(-0.5));
  EXPECT_EQ(cable.getRestitution(), 0);
  cable.setRestitution(std::numeric_limits<btScalar>::quiet_NaN());
  EXPECT_EQ(cable.getRestitution(), 0);
  cable.setMaxLength(-1);
  EXPECT_EQ(cable.getMaxLength(), 0);
  cable.setMaxLengthRate(std::numeric_limits<btScalar>::infinity());
  EXPECT_EQ(cable.getMaxLengthRate(), 0);
}

TEST(BtCableConstraint, HaulsAndWakesItsLoadAsAWinch) {
  Hanging hanging;
  hanging.load.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, -1, 0)));
  hanging.load.setActivationState(ISLAND_SLEEPING);
  hanging.cable.setMaxLengthRate(btScalar(-0.5));
  for (int step = 0; step < 60; ++step) {
    hanging.world.stepSimulation(time_step);
  }
  EXPECT_NEAR(hanging.cable.getMaxLength(), 0.5, 1e-5);
  EXPECT_NEAR(hanging.load.getCenterOfMassPosition().y(), -0.5, 1e-3);
  EXPECT_NEAR(hanging.load.getLinearVelocity().y(), 0.5, 1e-4);
  EXPECT_NEAR(hanging.cable.getTension(time_step), weight, 1e-2);
  hanging.cable.setMaxLengthRate(0);
  hanging.load.setActivationState(ISLAND_SLEEPING);
  hanging.cable.setMaxLength(btScalar(0.75));
  EXPECT_TRUE(hanging.load.isActive());
}

/// The speed of an impact is that relative to the length.
TEST(BtCableConstraint, ReboundsFromAMovingLength) {
  Hanging hanging;
  hanging.world.setGravity(btVector3(0, 0, 0));
  hanging.load.setGravity(btVector3(0, 0, 0));
  hanging.load.setWorldTransform(
      btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(-0.995), 0)));
  hanging.cable.setRestitution(btScalar(0.5));
  hanging.cable.setMaxLengthRate(-1);
  for (int step = 0; step < 3; ++step) {
    hanging.world.stepSimulation(time_step);
  }
  EXPECT_NEAR(hanging.load.getLinearVelocity().y(), 1.5, 1e-5);  // (1 + e) of the winch's
}

TEST(BtCableConstraint, WorksWithASolverThatKnowsRowsAlone) {
  btDantzigSolver dantzig;
  btMLCPSolver solver(&dantzig);
  Hanging hanging;
  hanging.world.setConstraintSolver(&solver);
  hanging.load.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, -1, 0)));
  for (int step = 0; step < 120; ++step) {
    hanging.world.stepSimulation(time_step);
  }
  EXPECT_NEAR(hanging.cable.getGap(), 0.0, 1e-3);
  EXPECT_NEAR(hanging.cable.getTension(time_step), weight, 1e-2);
  hanging.world.setConstraintSolver(&hanging.solver);
}

TEST(BtCableConstraint, GivesWithItsCfm) {
  Hanging hanging;
  hanging.cable.setParam(BT_CONSTRAINT_ERP, 0);
  hanging.cable.setParam(BT_CONSTRAINT_CFM, btScalar(0.25));
  hanging.world.stepSimulation(time_step);
  // the row of Bullet's solver: impulse = fall / (J M^-1 J^T) - cfm * impulse, in units of its own
  const double fall = 10.0 / 60.0;
  EXPECT_NEAR(hanging.cable.getAppliedImpulse(), fall * 2.0 / 1.25, 1e-3);
  EXPECT_LT(hanging.cable.getGapRate(), 0);
}

TEST(BtCableConstraint, ReportsTensionAndFeedback) {
  Hanging hanging;
  btJointFeedback feedback;
  hanging.cable.setJointFeedback(&feedback);
  for (int step = 0; step < 200; ++step) {
    hanging.world.stepSimulation(time_step);
  }
  EXPECT_TRUE(hanging.cable.isTaut());
  EXPECT_NEAR(hanging.cable.getTension(time_step), weight, 1e-3);
  EXPECT_NEAR(feedback.m_appliedForceBodyA.y(), weight, 1e-3);
}

TEST(BtCableConstraint, BreaksAtItsThreshold) {
  Hanging hanging;
  hanging.cable.setBreakingImpulseThreshold(btScalar(0.1));  // a step's weight is 0.33 N s
  for (int step = 0; step < 5; ++step) {
    hanging.world.stepSimulation(time_step);
  }
  EXPECT_FALSE(hanging.cable.isEnabled());
  EXPECT_LT(hanging.cable.getGap(), btScalar(-0.1));
}

TEST(BtStepWithCables, BreaksAtItsThreshold) {
  Hanging hanging;
  hanging.load.setWorldTransform(
      btTransform(btQuaternion::getIdentity(), btVector3(0, btScalar(-0.99), 0)));
  hanging.load.setLinearVelocity(btVector3(0, -2, 0));
  hanging.cable.setBreakingImpulseThreshold(1);  // the impact's is 4 N s
  btCableConstraint* cables[] = {&hanging.cable};
  for (int step = 0; step < 5; ++step) {
    btStepWithCables(&hanging.world, cables, 1, time_step);
  }
  EXPECT_FALSE(hanging.cable.isEnabled());
  EXPECT_LT(hanging.cable.getGap(), btScalar(-0.01));
}

TEST(BtCableConstraint, DoesNotReboundBelowItsThreshold) {
  for (const btScalar threshold : {btScalar(1), btScalar(3)}) {
    Hanging hanging;
    hanging.cable.setRestitution(btScalar(0.5));
    hanging.cable.setRestitutionThreshold(threshold);
    hanging.load.setLinearVelocity(btVector3(0, -2, 0));
    hanging.world.stepSimulation(time_step);
    EXPECT_NEAR(hanging.cable.getGapRate(), threshold < 2 ? 1.0 : 0.0, 1e-5);
  }
}

TEST(BtCableConstraint, IsMendedByEnablingIt) {
  Hanging hanging;
  hanging.cable.setBreakingImpulseThreshold(btScalar(0.1));
  hanging.world.stepSimulation(time_step);
  EXPECT_FALSE(hanging.cable.isEnabled());
  hanging.cable.setBreakingImpulseThreshold(SIMD_INFINITY);
  hanging.cable.setEnabled(true);
  hanging.world.stepSimulation(time_step);
  EXPECT_TRUE(hanging.cable.isEnabled());
  EXPECT_TRUE(hanging.cable.isTaut());
}

/// A hook with a mass, and a body that is static with one: cables move neither.
TEST(BtCableConstraint, HangsOnWhatHasAMassAndDoesNotMove) {
  for (const bool islands : {true, false}) {
    for (const int flag :
         {btCollisionObject::CF_KINEMATIC_OBJECT, btCollisionObject::CF_STATIC_OBJECT}) {
      Hanging hanging;
      hanging.world.getSimulationIslandManager()->setSplitIslands(islands);
      btEmptyShape nothing;
      btRigidBody hook(
          btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &nothing, btVector3(1, 1, 1)));
      hook.setCollisionFlags(flag);
      hanging.world.addRigidBody(&hook, 0, 0);
      btCableConstraint toWorld(hook, btVector3(0, 0, 0), btVector3(0, 0, 0), btScalar(0.5));
      btCableConstraint toLoad(hook, hanging.load, btVector3(0, 0, 0), btVector3(0, 0, 0),
                               btScalar(1.1));
      hanging.world.addConstraint(&toWorld);
      hanging.world.addConstraint(&toLoad);
      for (int step = 0; step < 60; ++step) {
        hanging.world.stepSimulation(time_step);
      }
      EXPECT_GE(hanging.cable.getGap(), -1e-3);
      EXPECT_NEAR(hook.getCenterOfMassPosition().length(), 0.0, 1e-6);
      hanging.world.removeConstraint(&toLoad);
      hanging.world.removeConstraint(&toWorld);
      hanging.world.removeRigidBody(&hook);
    }
  }
}

TEST(BtStepWithCables, LeavesASleepingLoadTaut) {
  Hanging hanging;
  hanging.load.setWorldTransform(btTransform(btQuaternion::getIdentity(), btVector3(0, -1, 0)));
  hanging.world.stepSimulation(time_step);
  EXPECT_TRUE(hanging.cable.isTaut());
  hanging.load.setActivationState(ISLAND_SLEEPING);
  btCableConstraint* cables[] = {&hanging.cable};
  btStepWithCables(&hanging.world, cables, 1, time_step);
  EXPECT_FALSE(hanging.load.isActive());
  EXPECT_TRUE(hanging.cable.isTaut());
}

/// Where the user has the hook.
struct HookPose : btMotionState {
  btTransform pose = btTransform::getIdentity();

  void getWorldTransform(btTransform& now) const override { now = pose; }
  void setWorldTransform(const btTransform& /*now*/) override {}
};

/// A hook rises at 1 m/s in no gravity, and takes up a load on a cable that is 0.055 m slack.
void expect_exact_hoisting(bool byMotionState) {
  Hanging hanging;
  btDiscreteDynamicsWorld& world = hanging.world;
  world.removeConstraint(&hanging.cable);
  hanging.load.setGravity(btVector3(0, 0, 0));
  hanging.load.setActivationState(DISABLE_DEACTIVATION);
  HookPose pose;
  btEmptyShape nothing;
  btRigidBody hook(
      btRigidBody::btRigidBodyConstructionInfo(0, byMotionState ? &pose : nullptr, &nothing));
  hook.setCollisionFlags(hook.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  hook.setActivationState(DISABLE_DEACTIVATION);
  world.addRigidBody(&hook, 0, 0);
  btCableConstraint cable(hanging.load, hook, btVector3(0, 0, 0), btVector3(0, 0, 0),
                          btScalar(1.155));
  cable.setRestitution(btScalar(0.5));
  world.addConstraint(&cable);
  btCableConstraint* cables[] = {&cable};
  const double rounding = 1e3 * SIMD_EPSILON;
  double time = 0;
  for (int step = 0; step < 6; ++step) {
    time += time_step;
    pose.pose.setOrigin(btVector3(0, static_cast<btScalar>(time), 0));
    if (!byMotionState) {
      hook.setWorldTransform(pose.pose);
    }
    const int parts = btStepWithCables(&world, cables, 1, time_step);
    // taut after 0.055 s; the load then rises at (1 + e) of the hook's speed, never overstretched
    const double flight = time - 0.055;
    EXPECT_EQ(parts, step == 3 ? 2 : 1) << "step " << step;
    EXPECT_NEAR(cable.getGap(), flight < 0 ? -flight : 0.5 * flight, rounding) << "step " << step;
    EXPECT_NEAR(hook.getWorldTransform().getOrigin().y(), time, rounding);
    EXPECT_NEAR(hook.getLinearVelocity().y(), 1, 1e3 * rounding);  // of a difference
    EXPECT_EQ(hook.getMotionState(), byMotionState ? &pose : nullptr);
  }
  EXPECT_NEAR(hanging.load.getLinearVelocity().y(), 1.5, rounding);
  world.removeConstraint(&cable);
  world.removeRigidBody(&hook);
  world.addConstraint(&hanging.cable);
}

TEST(BtStepWithCables, TakesUpALoadFromAMovingHook) {
  expect_exact_hoisting(true);
  expect_exact_hoisting(false);
}

}  // namespace
