#include "world.hpp"

#include <cmath>

#include "tautline/unwrap.hpp"

namespace tautline::bullet {

BareWorld::~BareWorld() {
  for (const auto& constraint : constraints_) {
    dynamics_.removeConstraint(constraint.get());
  }
  for (const auto& body : bodies_) {
    dynamics_.removeRigidBody(body.get());
  }
}

btRigidBody& BareWorld::add_body(double mass, const btVector3& moments) {
  bodies_.push_back(std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
      static_cast<btScalar>(mass), nullptr, &shape_, moments)));
  return *bodies_.back();
}

btRigidBody& BareWorld::add_fixed_body(const btVector3& position) {
  btRigidBody& added = add_body(0.0, btVector3(0, 0, 0));
  added.setWorldTransform(btTransform(btQuaternion::getIdentity(), position));
  dynamics_.addRigidBody(&added, 0, 0);
  return added;
}

btRigidBody& BareWorld::add_hook(btMotionState& pose) {
  btRigidBody& added = add_body(0.0, btVector3(0, 0, 0));
  added.setMotionState(&pose);  // and it is there
  added.setInterpolationWorldTransform(added.getWorldTransform());
  added.setCollisionFlags(added.getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  added.setActivationState(DISABLE_DEACTIVATION);
  dynamics_.addRigidBody(&added, 0, 0);
  return added;
}

void BareWorld::step_once(double dt) {
  const auto step = static_cast<btScalar>(dt);
  if (btFuzzyZero(step)) {  // less than SIMD_EPSILON, 1.2e-7 in float: only as a substep is it made
    dynamics_.stepSimulation(step, 1, step);
  } else {
    const int as_one_substep = 0;
    dynamics_.stepSimulation(step, as_one_substep);
  }
}

World::World(const Case& the_case, Sleep sleep)
    // zero about x and y means infinite to Bullet, and so does the zero of a point mass about z
    : body_(&add_body(the_case.body.mass,
                      btVector3(0, 0, static_cast<btScalar>(the_case.body.inertia)))),
      angle_(the_case.initial.angle) {
  place(the_case.initial);
  body_->setLinearFactor(btVector3(1, 1, 0));
  body_->setAngularFactor(btVector3(0, 0, 1));
  body_->setFlags(0);
  if (sleep == Sleep::never) {
    body_->setActivationState(DISABLE_DEACTIVATION);
  }
  body_->updateInertiaTensor();
  dynamics().setGravity(vector(the_case.gravity));  // before the body, which takes it over
  dynamics().addRigidBody(body_, 0, 0);
}

State World::state() const {
  const btTransform& pose = body_->getWorldTransform();
  const btVector3& velocity = body_->getLinearVelocity();
  const btMatrix3x3& axes = pose.getBasis();
  State result;
  result.position = Vec2(pose.getOrigin().x(), pose.getOrigin().y());
  result.angle = unwrap(std::atan2(axes[1][0], axes[0][0]), angle_);
  result.velocity = Vec2(velocity.x(), velocity.y());
  result.spin = body_->getAngularVelocity().z();
  return result;
}

void World::advance(double dt) {
  step_once(dt);
  follow(dt);
}

void World::follow(double dt) {
  angle_ += dt * body_->getAngularVelocity().z();  // the new spin turns the body in Bullet
  angle_ = state().angle;
}

void World::place(const State& state) {
  btTransform pose(btQuaternion(btVector3(0, 0, 1), static_cast<btScalar>(state.angle)),
                   vector(state.position));
  body_->setWorldTransform(pose);
  body_->setInterpolationWorldTransform(pose);
  body_->setLinearVelocity(vector(state.velocity));
  body_->setAngularVelocity(btVector3(0, 0, static_cast<btScalar>(state.spin)));
  angle_ = state.angle;
}

void World::kick(const Vec2& change) {
  body_->setLinearVelocity(body_->getLinearVelocity() + vector(change));
}

SystemWorld::SystemWorld(const SpatialSystem& system) : system_(system) {
  dynamics().setGravity(vector(gravity_in_step(system_, system_.initial, 0.0)));
  for (const SpatialBody& body : system_.bodies) {
    moving_.push_back(&add_body(body.mass, vector(body.inertia)));
  }
  place(system_.initial);
  for (btRigidBody* const body : moving_) {
    body->setActivationState(DISABLE_DEACTIVATION);
    dynamics().addRigidBody(body, 0, 0);
  }
}

SpatialSystemState SystemWorld::state() const {
  SpatialSystemState result;
  result.time = time_;
  for (const btRigidBody* const body : moving_) {
    const btQuaternion turn = body->getWorldTransform().getRotation();
    SpatialState one;
    one.position = from_bullet(body->getWorldTransform().getOrigin());
    one.orientation = Quaternion(turn.w(), turn.x(), turn.y(), turn.z()).normalized();
    one.velocity = from_bullet(body->getLinearVelocity());
    one.spin = rotated_back<double>(one.orientation, from_bullet(body->getAngularVelocity()));
    result.bodies.push_back(one);
  }
  return result;
}

void SystemWorld::place(const SpatialSystemState& state) {
  time_ = state.time;
  for (std::size_t index = 0; index < moving_.size(); ++index) {
    const SpatialState& now = state.bodies[index];
    btRigidBody& body = *moving_[index];
    const btVector3 axis = vector(Eigen::Vector3d(now.orientation.tail<3>()));
    const btTransform pose(
        btQuaternion(axis.x(), axis.y(), axis.z(), static_cast<btScalar>(now.orientation[0])),
        vector(now.position));
    body.setWorldTransform(pose);
    body.setInterpolationWorldTransform(pose);
    body.setLinearVelocity(vector(now.velocity));
    body.setAngularVelocity(vector(in_the_world(now, now.spin)));
    body.updateInertiaTensor();
  }
}

void SystemWorld::load(const std::vector<BodyLoad>& loads, const Eigen::Vector3d& gravity) {
  dynamics().setGravity(vector(gravity));
  add(loads);
}

void SystemWorld::add(const std::vector<BodyLoad>& loads) {
  for (std::size_t index = 0; index < moving_.size(); ++index) {
    moving_[index]->applyCentralForce(vector(loads[index].force));
    moving_[index]->applyTorque(vector(loads[index].moment));
  }
}

void SystemWorld::load(double dt) {
  const SpatialSystemState now = state();
  load(loads_in_step(system_, now, dt), gravity_in_step(system_, now, dt));
}

void SystemWorld::advance(double dt) {
  load(dt);
  step_once(dt);
  follow(dt);
}

void SystemWorld::fly(double dt) {
  const SpatialSystemState now = state();
  const std::vector<BodyLoad> loads = loads_in_step(system_, now, dt);
  const Eigen::Vector3d gravity = gravity_in_step(system_, now, dt);
  const auto kick = [&](double part) {
    for (std::size_t index = 0; index < moving_.size(); ++index) {
      btRigidBody& body = *moving_[index];
      const Gain gain =
          gain_in_step(system_.bodies[index], now.bodies[index], gravity, loads[index], part * dt);
      body.setLinearVelocity(body.getLinearVelocity() + vector(gain.velocity));
      body.setAngularVelocity(body.getAngularVelocity() + vector(gain.spin));
    }
  };
  kick(-0.5);
  load(loads, gravity);
  step_once(dt);
  follow(dt);
  kick(0.5);
}

std::vector<Setting> system_settings() {
  return {{"setLinearFactor, setAngularFactor, setFlags", "as shipped",
           "Bodies of a system move in space, with Bullet's own gyroscopic term."},
          {"gravity, applyCentralForce, applyTorque",
           "what is given, as it is in the middle of the step; drag as it decays in the step",
           "Bullet knows no function of time."}};
}

std::vector<Setting> world_settings(Sleep sleep) {
  std::vector<Setting> result = {
      {"stepSimulation maxSubSteps", "0",
       "With the default, 1 substep of 1/60 s, Bullet does nothing in a smaller step."},
      {"setLinearFactor, setAngularFactor", "(1, 1, 0), (0, 0, 1)", "The problem is planar."},
      {"setFlags", "0",
       "The gyroscopic term is zero in the plane, and its solve is singular for the infinite "
       "inertia about x and y."},
      {"addRigidBody group, mask", "0, 0", "The body touches nothing but its cables."},
  };
  if (sleep == Sleep::never) {
    result.push_back(
        {"setActivationState", "DISABLE_DEACTIVATION",
         "Bullet freezes a body slower than 0.8 m/s and 1 rad/s for 2 s, in the middle of a "
         "swing."});
  }
  return result;
}

}  // namespace tautline::bullet
