#include "world.hpp"

#include <cmath>

#include "tautline/unwrap.hpp"

namespace tautline::bullet {

World::World(const Case& the_case, Sleep sleep)
    : body_(make_body(the_case.body.mass, the_case.body.inertia)), angle_(the_case.initial.angle) {
  place(the_case.initial);
  body_->setLinearFactor(btVector3(1, 1, 0));
  body_->setAngularFactor(btVector3(0, 0, 1));
  body_->setFlags(0);
  if (sleep == Sleep::never) {
    body_->setActivationState(DISABLE_DEACTIVATION);
  }
  body_->updateInertiaTensor();
  dynamics_.setGravity(vector(the_case.gravity));  // before the body, which takes it over
  dynamics_.addRigidBody(body_.get(), 0, 0);
}

World::~World() {
  for (const auto& constraint : constraints_) {
    dynamics_.removeConstraint(constraint.get());
  }
  for (const auto& fixed : fixed_) {
    dynamics_.removeRigidBody(fixed.get());
  }
  dynamics_.removeRigidBody(body_.get());
}

std::unique_ptr<btRigidBody> World::make_body(double mass, double inertia) {
  // zero about x and y means infinite to Bullet, and so does the zero of a point mass about z
  const btVector3 moments(0, 0, static_cast<btScalar>(inertia));
  return std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
      static_cast<btScalar>(mass), nullptr, &shape_, moments));
}

btRigidBody& World::add_fixed_body(const Vec2& position) {
  fixed_.push_back(make_body(0.0, 0.0));
  btRigidBody& added = *fixed_.back();
  added.setWorldTransform(btTransform(btQuaternion::getIdentity(), vector(position)));
  dynamics_.addRigidBody(&added, 0, 0);
  return added;
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
  const auto step = static_cast<btScalar>(dt);
  if (btFuzzyZero(step)) {  // less than SIMD_EPSILON, 1.2e-7 in float: only as a substep is it made
    dynamics_.stepSimulation(step, 1, step);
  } else {
    const int as_one_substep = 0;
    dynamics_.stepSimulation(step, as_one_substep);
  }
  follow_turn(dt);
}

void World::follow_turn(double dt) {
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
