// Loads that have come to rest, and what sets them going again; and the settings of Bullet's that
// the guide names.

#include <btBulletDynamicsCommon.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "tautline/bullet/btStepWithCables.h"

namespace {

const btScalar sleep_time_step = btScalar(1) / 60;

/// Where the user has the hook.
struct MovedHook : btMotionState {
  btTransform pose = btTransform::getIdentity();

  void getWorldTransform(btTransform& now) const override { now = pose; }
  void setWorldTransform(const btTransform& /*now*/) override {}
};

/// One load below the other on cables of 2 m and 1 m, from a hook that is a kinematic body. They
/// may sleep, and have hung for 4 s.
struct Crane {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btSphereShape shape{btScalar(0.1)};
  MovedHook state;
  btRigidBody hook;
  btRigidBody load{inertial(10)};
  btRigidBody below{inertial(5)};
  std::unique_ptr<btCableConstraint> cable;
  std::unique_ptr<btCableConstraint> lower;
  bool by_events;

  btRigidBody::btRigidBodyConstructionInfo inertial(btScalar mass) {
    const btScalar moment = btScalar(0.004) * mass;
    return {mass, nullptr, &shape, btVector3(moment, moment, moment)};
  }

  Crane(bool events, bool by_motion_state, const btVector3& pivot_in_hook)
      : hook(btRigidBody::btRigidBodyConstructionInfo(0, by_motion_state ? &state : nullptr,
                                                      &shape)),
        by_events(events) {
    world.setGravity(btVector3(0, btScalar(-9.81), 0));
    hook.setCollisionFlags(hook.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    hook.setActivationState(DISABLE_DEACTIVATION);  // as Bullet's manual has it
    load.translate(pivot_in_hook + btVector3(0, -2, 0));
    below.translate(pivot_in_hook + btVector3(0, -3, 0));
    cable = std::make_unique<btCableConstraint>(load, hook, btVector3(0, 0, 0), pivot_in_hook, 2);
    lower =
        std::make_unique<btCableConstraint>(below, load, btVector3(0, 0, 0), btVector3(0, 0, 0), 1);
    for (btRigidBody* body : {&hook, &load, &below}) {
      world.addRigidBody(body);
    }
    world.addConstraint(cable.get());
    world.addConstraint(lower.get());
    run(240, [](int) {});
  }
  Crane(const Crane&) = delete;
  Crane& operator=(const Crane&) = delete;
  ~Crane() {
    world.removeConstraint(cable.get());
    world.removeConstraint(lower.get());
    for (btRigidBody* body : {&hook, &load, &below}) {
      world.removeRigidBody(body);
    }
  }

  void run(int steps, const std::function<void(int)>& before_each) {
    btCableConstraint* cables[] = {cable.get(), lower.get()};
    for (int step = 1; step <= steps; ++step) {
      before_each(step);
      by_events ? static_cast<void>(btStepWithCables(&world, cables, 2, sleep_time_step))
                : static_cast<void>(world.stepSimulation(sleep_time_step, 0));
    }
  }
  void expect_at(double height) const {
    EXPECT_NEAR(load.getCenterOfMassPosition().y(), height, 1e-2);
    EXPECT_NEAR(below.getCenterOfMassPosition().y(), height - 1, 1e-2);
    EXPECT_GE(cable->getGap(), btScalar(-1e-2));
    EXPECT_GE(lower->getGap(), btScalar(-1e-2));
  }
};

class BtRestingLoad : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Stepped, BtRestingLoad, testing::Bool(),
                         [](const testing::TestParamInfo<bool>& instance) {
                           return instance.param ? "ByEvents" : "Fixed";
                         });

TEST_P(BtRestingLoad, GoesUpWithAHookThatStartsToMove) {
  for (const bool by_motion_state : {true, false}) {
    Crane crane(GetParam(), by_motion_state, btVector3(0, 0, 0));
    crane.run(180, [&](int step) {
      crane.state.pose.setOrigin(btVector3(0, static_cast<btScalar>(step / 60.0), 0));
      if (!by_motion_state) {
        crane.hook.setWorldTransform(crane.state.pose);
      }
    });
    crane.expect_at(1);
  }
}

TEST_P(BtRestingLoad, GoesUpWithAHookThatTurns) {
  Crane crane(GetParam(), true, btVector3(btScalar(0.5), 0, 0));
  // by a right angle in 4 s: the cable's end goes from beside the hook's centre to above it
  crane.run(240, [&](int step) {
    const double angle = 0.5 * SIMD_PI * step / 240.0;
    crane.state.pose.setRotation(btQuaternion(btVector3(0, 0, 1), static_cast<btScalar>(angle)));
  });
  const btVector3 end = crane.cable->getPivotBInWorld();
  EXPECT_NEAR(end.y(), 0.5, 1e-5);
  EXPECT_LT(crane.load.getCenterOfMassPosition().distance(end), 2.01);
  EXPECT_GT(crane.load.getCenterOfMassPosition().y(), -1.6);
}

TEST_P(BtRestingLoad, GoesUpWithAWinchThatStarts) {
  Crane crane(GetParam(), true, btVector3(0, 0, 0));
  crane.load.forceActivationState(ISLAND_SLEEPING);
  crane.below.forceActivationState(ISLAND_SLEEPING);
  crane.lower->setMaxLengthRate(btScalar(-0.25));
  crane.run(120, [](int) {});
  EXPECT_NEAR(crane.below.getCenterOfMassPosition().y(), -2.5, 1e-2);
  crane.lower->setMaxLengthRate(0);
  crane.load.forceActivationState(ISLAND_SLEEPING);
  crane.below.forceActivationState(ISLAND_SLEEPING);
  crane.cable->setPivotB(btVector3(0, 1, 0));  // another place on the hook
  crane.run(240, [](int) {});
  EXPECT_NEAR(crane.load.getCenterOfMassPosition().y(), -1, 1e-2);
}

/// From the world, which does not move, it still falls asleep.
TEST(BtRestingLoads, FallAsleepBelowAPointOfTheWorld) {
  Crane crane(false, true, btVector3(0, 0, 0));
  crane.world.removeConstraint(crane.cable.get());
  crane.cable =
      std::make_unique<btCableConstraint>(crane.load, btVector3(0, 0, 0), btVector3(0, 0, 0), 2);
  crane.world.addConstraint(crane.cable.get());
  crane.run(240, [](int) {});
  EXPECT_FALSE(crane.load.isActive());
  EXPECT_FALSE(crane.below.isActive());
}

/// How far a car of 1000 kg creeps in 10 s whose brakes hold more than the 3000 N that a truck
/// pulls with [m].
double creeps(int solver_mode, int iterations) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, btScalar(-9.81), 0));
  world.getSolverInfo().m_solverMode |= solver_mode;
  world.getSolverInfo().m_numIterations = iterations;
  btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
  btBoxShape shape(btVector3(2, btScalar(0.5), 1));
  btVector3 moments;
  const auto body = [&](btScalar mass, btCollisionShape& of, btScalar x, btScalar friction) {
    moments.setZero();
    if (mass > 0) {
      of.calculateLocalInertia(mass, moments);
    }
    auto result = std::make_unique<btRigidBody>(
        btRigidBody::btRigidBodyConstructionInfo(mass, nullptr, &of, moments));
    result->translate(btVector3(x, mass > 0 ? btScalar(0.5) : btScalar(0), 0));
    result->setFriction(friction);
    result->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(result.get());
    return result;
  };
  const auto ground = body(0, plane, 0, 1);
  const auto car = body(1000, shape, -2, btScalar(0.5));
  const auto truck = body(2000, shape, btScalar(7.5), 0);
  btCableConstraint cable(*truck, *car, btVector3(-2, 0, 0), btVector3(2, 0, 0), btScalar(5.5));
  world.addConstraint(&cable);
  for (int step = 0; step < 600; ++step) {
    truck->applyCentralForce(btVector3(3000, 0, 0));
    world.stepSimulation(sleep_time_step, 0);
  }
  world.removeConstraint(&cable);
  for (btRigidBody* one : {ground.get(), car.get(), truck.get()}) {
    world.removeRigidBody(one);
  }
  return std::abs(static_cast<double>(car->getCenterOfMassPosition().x()) + 2.0);
}

/// Bullet's friction acts in the direction that a contact happened to slip in, and in no other,
/// unless it is told to.
TEST(BtStaticTow, HoldsStillWithTwoDirectionsOfFriction) {
  EXPECT_LT(creeps(SOLVER_USE_2_FRICTION_DIRECTIONS, 10), 0.02);
  EXPECT_LT(creeps(SOLVER_USE_2_FRICTION_DIRECTIONS, 30), 1e-3);
}

/// The most energy that a ball gains which bounces between the ground and a cable's end, with e = 1
/// of both [of its energy].
double gained_between_ground_and_cable(bool split_impulse) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity(btVector3(0, btScalar(-9.81), 0));
  world.getSolverInfo().m_splitImpulse = split_impulse ? 1 : 0;
  world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0;
  world.getSolverInfo().m_restitutionVelocityThreshold = 0;
  btStaticPlaneShape plane(btVector3(0, 1, 0), 0);
  btSphereShape shape(btScalar(0.1));
  btRigidBody ground(btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &plane));
  btRigidBody ball(
      btRigidBody::btRigidBodyConstructionInfo(1, nullptr, &shape, btVector3(1, 1, 1)));
  ball.translate(btVector3(0, 1, 0));
  ball.setLinearVelocity(btVector3(0, 3, 0));
  for (btRigidBody* body : {&ground, &ball}) {
    body->setRestitution(1);
    body->setActivationState(DISABLE_DEACTIVATION);
    world.addRigidBody(body);
  }
  // from a point below the ground, so that it holds the ball down
  btCableConstraint cable(ball, btVector3(0, 0, 0), btVector3(0, -1, 0), btScalar(2.2));
  cable.setRestitution(1);
  world.addConstraint(&cable);
  const auto energy = [&] {
    const double v = static_cast<double>(ball.getLinearVelocity().y()) - 0.5 * 9.81 / 60.0;
    return 0.5 * v * v +
           9.81 * static_cast<double>(ball.getCenterOfMassPosition().y() - btScalar(0.1));
  };
  const double start = energy();
  double most = start;
  for (int step = 0; step < 3600; ++step) {
    world.stepSimulation(sleep_time_step, 0);
    most = std::max(most, energy());
  }
  world.removeConstraint(&cable);
  world.removeRigidBody(&ball);
  world.removeRigidBody(&ground);
  return most / start - 1.0;
}

/// Else the speed that takes out a contact's penetration stays, and grows beyond all bounds.
TEST(BtElasticContact, GainsLittleBesideACableWithSplitImpulses) {
  EXPECT_LT(gained_between_ground_and_cable(true), 0.05);
  EXPECT_GT(gained_between_ground_and_cable(false), 1.0);
}

}  // namespace
