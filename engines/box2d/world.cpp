#include "world.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "tautline/event_driver.hpp"
#include "tautline/impulses_by_hand.hpp"

namespace tautline::box2d {
namespace {

/// What Box2D's manual suggests; a step has no defaults for them.
constexpr int velocity_iterations = 8;
constexpr int position_iterations = 3;

b2Body* create_body(b2World& world, const Case& the_case) {
  b2BodyDef definition;
  definition.type = b2_dynamicBody;
  b2Body* body = world.CreateBody(&definition);
  b2MassData mass;
  mass.mass = number(the_case.body.mass);
  mass.center.SetZero();
  mass.I = number(the_case.body.inertia);  // the zero of a point mass means infinite
  body->SetMassData(&mass);
  return body;
}

b2Body* create_ground(b2World& world) {
  const b2BodyDef definition;
  return world.CreateBody(&definition);
}

b2Vec2 rounded(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

}  // namespace

float number(double value) {
  const auto result = static_cast<float>(value);
  if (!std::isfinite(result) || (result == 0.0F && value != 0.0)) {  // exactly: it underflows
    std::ostringstream text;
    text << "unsupported: Box2D's single precision cannot hold " << value;
    throw std::invalid_argument(text.str());
  }
  return result;
}

b2Vec2 vector(const Vec2& v) { return {number(v.x()), number(v.y())}; }

World::World(const Case& the_case)
    : world_(vector(the_case.gravity)),
      ground_(create_ground(world_)),
      body_(create_body(world_, the_case)) {
  world_.SetAllowSleeping(false);
  place(the_case.initial);
}

State World::state() const {
  const b2Vec2& position = body_->GetPosition();
  const b2Vec2& velocity = body_->GetLinearVelocity();
  State result;
  result.position = Vec2(position.x, position.y);
  result.angle = body_->GetAngle();
  result.velocity = Vec2(velocity.x, velocity.y);
  result.spin = body_->GetAngularVelocity();
  return result;
}

void World::place(const State& state) {
  body_->SetTransform(rounded(state.position), static_cast<float>(state.angle));
  body_->SetLinearVelocity(rounded(state.velocity));
  body_->SetAngularVelocity(static_cast<float>(state.spin));
}

void World::kick(const Vec2& change) {
  body_->SetLinearVelocity(rounded(state().velocity + change));
}

void World::advance(double dt) {
  world_.Step(static_cast<float>(dt), velocity_iterations, position_iterations);
}

CableVector World::pull(const std::vector<CableRow>& rows, const CableVector& rates) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, max_cables> gradients(3, count);
  for (Eigen::Index index = 0; index < count; ++index) {
    const CableRow& row = rows[static_cast<std::size_t>(index)];
    gradients.col(index) << row.towards, row.moment;
  }
  const double inertia = body_->GetInertia();
  const Eigen::Vector3d inverse_mass(1.0 / body_->GetMass(), 1.0 / body_->GetMass(),
                                     inertia > 0.0 ? 1.0 / inertia : 0.0);
  const State now = state();
  const Eigen::Vector3d velocity(now.velocity.x(), now.velocity.y(), now.spin);
  const CableVector excess = gradients.transpose() * velocity - rates;
  const double rounding = EventAdapter::float_rounding.rate * excess.cwiseAbs().maxCoeff();
  CableVector impulses = impulses_by_hand(
      gradients.transpose() * inverse_mass.asDiagonal() * gradients, excess, rounding);
  const Eigen::Vector3d total = gradients * impulses;
  const bool wake = true;
  body_->ApplyLinearImpulseToCenter(rounded(total.head<2>()), wake);
  body_->ApplyAngularImpulse(static_cast<float>(total.z()), wake);
  return impulses;
}

std::vector<Setting> world_settings() {
  return {
      {"SetAllowSleeping", "false",
       "Box2D freezes a body slower than 0.01 m/s and 2 degrees/s for half a second."},
      {"velocityIterations, positionIterations",
       std::to_string(velocity_iterations) + ", " + std::to_string(position_iterations),
       "Box2D ships no default; its manual suggests these, and its testbed has them.",
       Origin::engine_demo},
  };
}

}  // namespace tautline::box2d
