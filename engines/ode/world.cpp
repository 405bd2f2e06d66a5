#include "world.hpp"

#include <algorithm>
#include <cmath>

#include "library.hpp"
#include "tautline/point_mass.hpp"
#include "tautline/unwrap.hpp"

namespace tautline::ode {
namespace {

dWorldID create_world() {
  use_library();
  return dWorldCreate();
}

dMass mass_of(const Body& body) {
  const double inertia = turnable_inertia(body);
  dMass mass;
  dMassSetParameters(&mass, body.mass, 0, 0, 0, inertia, inertia, inertia, 0, 0, 0);
  return mass;
}

}  // namespace

World::World(const Case& the_case, Rotation rotation)
    : gravity_(the_case.gravity),
      world_(create_world()),
      body_(dBodyCreate(world_)),
      contacts_(dJointGroupCreate(0)),
      feedbacks_(the_case.cables.size()),
      impulses_(the_case.cables.size()),
      angle_(the_case.initial.angle) {
  const dMass mass = mass_of(the_case.body);
  dBodySetMass(body_, &mass);
  dBodySetFiniteRotationMode(body_, rotation == Rotation::finite ? 1 : 0);
  place(the_case.initial);
  dWorldSetGravity(world_, gravity_.x(), gravity_.y(), 0);
}

World::~World() {
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
}

State World::state() const {
  const dReal* position = dBodyGetPosition(body_);
  const dReal* quaternion = dBodyGetQuaternion(body_);
  const dReal* velocity = dBodyGetLinearVel(body_);
  State result;
  result.position = Vec2(position[0], position[1]);
  result.angle = unwrap(2.0 * std::atan2(quaternion[3], quaternion[0]), angle_);
  result.velocity = Vec2(velocity[0], velocity[1]);
  result.spin = dBodyGetAngularVel(body_)[2];
  return result;
}

void World::place(const State& state) {
  dBodySetPosition(body_, state.position.x(), state.position.y(), 0);
  const dQuaternion turn = {std::cos(0.5 * state.angle), 0, 0, std::sin(0.5 * state.angle)};
  dBodySetQuaternion(body_, turn);
  dBodySetLinearVel(body_, state.velocity.x(), state.velocity.y(), 0);
  dBodySetAngularVel(body_, 0, 0, state.spin);
  angle_ = state.angle;
}

void World::kick(const Vec2& change) {
  const dReal* velocity = dBodyGetLinearVel(body_);
  dBodySetLinearVel(body_, velocity[0] + change.x(), velocity[1] + change.y(), 0);
}

void World::pull(std::size_t index, const CableRow& row, const dSurfaceParameters& surface) {
  dContact contact{};
  contact.surface = surface;
  contact.geom.pos[0] = row.point.x();
  contact.geom.pos[1] = row.point.y();
  contact.geom.normal[0] = row.towards.x();
  contact.geom.normal[1] = row.towards.y();
  contact.geom.depth = std::max(0.0, -row.gap);
  const dJointID joint = dJointCreateContact(world_, contacts_, &contact);
  dJointAttach(joint, body_, nullptr);  // the body first: the other order turns the normal
  dJointSetFeedback(joint, &feedbacks_[index]);
  pulls_.push_back({index, row.towards});
}

void World::step_and_read_impulses(double dt) {
  dWorldStep(world_, dt);
  std::fill(impulses_.begin(), impulses_.end(), 0.0);
  for (const Pull& pull : pulls_) {
    const dReal* force = feedbacks_[pull.cable].f1;
    // the solver's force is >= 0; its projection back onto the normal may round below
    impulses_[pull.cable] = std::max(0.0, dt * Vec2(force[0], force[1]).dot(pull.towards));
  }
  pulls_.clear();
  dJointGroupEmpty(contacts_);
}

void World::advance(double dt) {
  step_and_read_impulses(dt);
  angle_ += dt * dBodyGetAngularVel(body_)[2];  // the new spin turns the body in ODE
  angle_ = state().angle;
}

void World::solve_here() {
  dVector3 position;
  dQuaternion quaternion;
  dBodyCopyPosition(body_, position);
  dBodyCopyQuaternion(body_, quaternion);
  dWorldSetGravity(world_, 0, 0, 0);
  step_and_read_impulses(1.0);  // any step: no force acts; a small one would lose digits
  dWorldSetGravity(world_, gravity_.x(), gravity_.y(), 0);
  dBodySetPosition(body_, position[0], position[1], position[2]);
  dBodySetQuaternion(body_, quaternion);
}

std::vector<Setting> world_settings() {
  return {
      {"mu", "0", "A cable has no friction across it, and one row is enough."},
      {"dMass inertia of a point mass", "the mass times 1 m^2",
       "ODE needs one above 0; the cables of a point mass never turn it."},
      {"dSetMessageHandler", "messages dropped",
       "ODE warns thousands of times of rows that are satisfied exactly; the results are "
       "right."},
      {"dSetErrorHandler, dSetDebugHandler", "an exception", "ODE ends the process on an error."}};
}

}  // namespace tautline::ode
