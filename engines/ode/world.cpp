#include "world.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "library.hpp"
#include "tautline/parabola.hpp"
#include "tautline/point_mass.hpp"
#include "tautline/unwrap.hpp"

namespace tautline::ode {
namespace {

dWorldID create_world() {
  use_library();
  return dWorldCreate();
}

/// The only end of `cable` that is on `body`; none if there are several.
std::optional<Eigen::Vector3d> only_end_on(const SpatialCable& cable, std::size_t body) {
  std::optional<Eigen::Vector3d> result;
  for (std::size_t i = 0; i <= cable.segments(); ++i) {
    if (cable.end(i).body == body) {
      if (result) {
        return std::nullopt;
      }
      result = cable.end(i).at;
    }
  }
  return result;
}

/// True where `cable` pulls along one line: at one point of one body, or straight between two.
bool pulls_along_a_line(const SpatialCable& cable) {
  const std::vector<std::size_t> on = pulled_bodies(cable);
  return on.size() <= (cable.segments() == 1 ? 2U : 1U) && only_end_on(cable, on.front()) &&
         (cable.from.body || cable.to.body);
}

}  // namespace

BareWorld::BareWorld(std::size_t cables, Rotation rotation, Turning turning)
    : world_(create_world()),
      rotation_(rotation),
      turning_(turning),
      contacts_(dJointGroupCreate(0)),
      feedbacks_(cables),
      impulses_(cables) {}

BareWorld::~BareWorld() {
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
}

dBodyID BareWorld::add_body(double mass, const Eigen::Vector3d& moments) {
  dMass of_body;
  dMassSetParameters(&of_body, mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
  const dBodyID body = dBodyCreate(world_);
  dBodySetMass(body, &of_body);
  dBodySetFiniteRotationMode(body, rotation_ == Rotation::finite ? 1 : 0);
  bodies_.push_back(body);
  return body;
}

void BareWorld::set_gravity(const Eigen::Vector3d& gravity) {
  dWorldSetGravity(world_, gravity.x(), gravity.y(), gravity.z());
}

World::World(const Case& the_case, Rotation rotation)
    : BareWorld(the_case.cables.size(), rotation),
      gravity_(the_case.gravity),
      body_(
          add_body(the_case.body.mass, Eigen::Vector3d::Constant(turnable_inertia(the_case.body)))),
      angle_(the_case.initial.angle) {
  place(the_case.initial);
  set_gravity({gravity_.x(), gravity_.y(), 0.0});
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

void BareWorld::pull(dBodyID body, const CableContact& contact, const dSurfaceParameters& surface) {
  dContact made{};
  made.surface = surface;
  for (int axis = 0; axis < 3; ++axis) {
    made.geom.pos[axis] = contact.point[axis];
    made.geom.normal[axis] = contact.towards[axis];
  }
  made.geom.depth = std::max(0.0, -contact.gap);
  const dJointID joint = dJointCreateContact(world_, contacts_, &made);
  dJointAttach(joint, body, contact.other);  // the body first: the other order turns the normal
  dJointSetFeedback(joint, &feedbacks_[contact.cable]);
  pulls_.push_back({contact.cable, contact.towards});
}

void BareWorld::step_and_read_impulses(double dt) {
  dWorldStep(world_, dt);
  std::fill(impulses_.begin(), impulses_.end(), 0.0);
  for (const Pull& pull : pulls_) {
    const dReal* force = feedbacks_[pull.cable].f1;
    // the solver's force is >= 0; its projection back onto the normal may round below
    impulses_[pull.cable] =
        std::max(0.0, dt * Eigen::Vector3d(force[0], force[1], force[2]).dot(pull.towards));
  }
  pulls_.clear();
  dJointGroupEmpty(contacts_);
}

void BareWorld::solve_here() {
  struct Pose {
    dVector3 position;
    dQuaternion quaternion;
  };
  std::vector<Pose> poses(bodies_.size());
  for (std::size_t index = 0; index < bodies_.size(); ++index) {
    dBodyCopyPosition(bodies_[index], poses[index].position);
    dBodyCopyQuaternion(bodies_[index], poses[index].quaternion);
    if (turning_ == Turning::in_space) {
      dBodySetGyroscopicMode(bodies_[index], 0);  // no time passes
    }
  }
  dVector3 gravity;
  dWorldGetGravity(world_, gravity);
  dWorldSetGravity(world_, 0, 0, 0);
  step_and_read_impulses(1.0);  // any step: no force acts; a small one would lose digits
  dWorldSetGravity(world_, gravity[0], gravity[1], gravity[2]);
  for (std::size_t index = 0; index < bodies_.size(); ++index) {
    const Pose& pose = poses[index];
    dBodySetPosition(bodies_[index], pose.position[0], pose.position[1], pose.position[2]);
    dBodySetQuaternion(bodies_[index], pose.quaternion);
    if (turning_ == Turning::in_space) {
      dBodySetGyroscopicMode(bodies_[index], 1);  // as shipped
    }
  }
}

void World::pull(std::size_t index, const CableRow& row, const dSurfaceParameters& surface) {
  BareWorld::pull(body_,
                  {.cable = index,
                   .point = {row.point.x(), row.point.y(), 0.0},
                   .towards = {row.towards.x(), row.towards.y(), 0.0},
                   .gap = row.gap},
                  surface);
}

void World::advance(double dt) {
  step_and_read_impulses(dt);
  angle_ += dt * dBodyGetAngularVel(body_)[2];  // the new spin turns the body in ODE
  angle_ = state().angle;
}

void World::fly(double dt) { fly_parabola(*this, gravity_, dt); }

SystemWorld::SystemWorld(const SpatialSystem& system, Rotation rotation)
    : BareWorld(system.cables.size(), rotation, Turning::in_space), system_(system) {
  for (const SpatialBody& body : system.bodies) {
    moving_.push_back(add_body(body.mass, turnable_inertia(body)));
  }
  place(system.initial);
}

void check_contacts(const SpatialSystem& system) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    if (!pulls_along_a_line(system.cables[index])) {
      throw CableRefused("a contact of ODE pulls along one line", index,
                         "runs over a ring between bodies");
    }
  }
}

dBodyID SystemWorld::add_hook(const Eigen::Vector3d& position) {
  const dBodyID hook = dBodyCreate(id());
  dBodySetKinematic(hook);
  dBodySetPosition(hook, position.x(), position.y(), position.z());
  return hook;
}

void SystemWorld::move_hook(dBodyID hook, const Eigen::Vector3d& there, double dt) {
  const dReal* position = dBodyGetPosition(hook);
  dBodySetLinearVel(hook, (there.x() - position[0]) / dt, (there.y() - position[1]) / dt,
                    (there.z() - position[2]) / dt);
}

SpatialSystemState SystemWorld::state() const {
  const auto vector = [](const dReal* of) { return Eigen::Vector3d(of[0], of[1], of[2]); };
  SpatialSystemState result;
  result.time = time_;
  for (const dBodyID body : moving_) {
    const dReal* turn = dBodyGetQuaternion(body);
    SpatialState one;
    one.position = vector(dBodyGetPosition(body));
    one.orientation = Quaternion(turn[0], turn[1], turn[2], turn[3]);
    one.velocity = vector(dBodyGetLinearVel(body));
    one.spin = rotated_back<double>(one.orientation, vector(dBodyGetAngularVel(body)));
    result.bodies.push_back(one);
  }
  return result;
}

void SystemWorld::place(const SpatialSystemState& state) {
  time_ = state.time;
  for (std::size_t index = 0; index < moving_.size(); ++index) {
    const SpatialState& now = state.bodies[index];
    const Eigen::Vector3d spin = in_the_world(now, now.spin);
    const dQuaternion turn = {now.orientation[0], now.orientation[1], now.orientation[2],
                              now.orientation[3]};
    dBodySetPosition(moving_[index], now.position.x(), now.position.y(), now.position.z());
    dBodySetQuaternion(moving_[index], turn);
    dBodySetLinearVel(moving_[index], now.velocity.x(), now.velocity.y(), now.velocity.z());
    dBodySetAngularVel(moving_[index], spin.x(), spin.y(), spin.z());
  }
}

void SystemWorld::pull(std::size_t index, const SystemRow& row, const dSurfaceParameters& surface) {
  const SpatialCable& cable = system_.cables[index];
  const std::vector<std::size_t> on = pulled_bodies(cable);
  const SpatialState first = state().bodies[on[0]];
  BareWorld::pull(moving_[on[0]],
                  {.cable = index,
                   .point = first.position + in_the_world(first, *only_end_on(cable, on[0])),
                   .towards = row.force(on[0]),
                   .gap = row.gap,
                   .other = on.size() > 1 ? moving_[on[1]] : nullptr},
                  surface);
}

void SystemWorld::load(const std::vector<BodyLoad>& loads, const Eigen::Vector3d& gravity) {
  set_gravity(gravity);
  add(loads);
}

void SystemWorld::add(const std::vector<BodyLoad>& loads) {
  for (std::size_t index = 0; index < moving_.size(); ++index) {
    const auto& [force, moment] = loads[index];
    dBodyAddForce(moving_[index], force.x(), force.y(), force.z());
    dBodyAddTorque(moving_[index], moment.x(), moment.y(), moment.z());
  }
}

void SystemWorld::load(double dt) {
  const SpatialSystemState now = state();
  load(loads_in_step(system_, now, dt), gravity_in_step(system_, now, dt));
}

void SystemWorld::step_loaded(double dt) {
  step_and_read_impulses(dt);
  time_ += dt;
}

void SystemWorld::advance(double dt) {
  load(dt);
  step_loaded(dt);
}

void SystemWorld::fly(double dt) {
  const SpatialSystemState now = state();
  const std::vector<BodyLoad> loads = loads_in_step(system_, now, dt);
  const Eigen::Vector3d gravity = gravity_in_step(system_, now, dt);
  const auto kick = [&](double part) {
    for (std::size_t index = 0; index < moving_.size(); ++index) {
      const auto& [velocity, spin] =
          gain_in_step(system_.bodies[index], now.bodies[index], gravity, loads[index], part * dt);
      const dReal* before = dBodyGetLinearVel(moving_[index]);
      dBodySetLinearVel(moving_[index], before[0] + velocity.x(), before[1] + velocity.y(),
                        before[2] + velocity.z());
      const dReal* turning = dBodyGetAngularVel(moving_[index]);
      dBodySetAngularVel(moving_[index], turning[0] + spin.x(), turning[1] + spin.y(),
                         turning[2] + spin.z());
    }
  };
  kick(-0.5);
  load(loads, gravity);
  step_loaded(dt);
  kick(0.5);
}

std::vector<Setting> system_settings() {
  return {{"dWorldSetGravity, dBodyAddForce, dBodyAddTorque",
           "what is given, as it is in the middle of the step; drag as it decays in the step",
           "ODE knows no function of time."},
          {"dContactMotionN, motionN", "how fast an end moves or a cable is hauled in",
           "A contact with the world knows of no motion at its other side."}};
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
