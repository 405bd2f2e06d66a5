#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "engines/cables/scene.hpp"
#include "tautline/bullet/btStepWithCables.h"

namespace tautline::test {
namespace {

btVector3 bullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

Vec3 eigen(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// Where the scene has a hook.
struct HookPose : btMotionState {
  btTransform pose = btTransform::getIdentity();

  void getWorldTransform(btTransform& now) const override { now = pose; }
  void setWorldTransform(const btTransform& /*now*/) override {}
};

}  // namespace

const std::string Scene::engine = sizeof(btScalar) == sizeof(double) ? "bullet64" : "bullet32";
const double Scene::rounding = std::numeric_limits<btScalar>::epsilon();

/// btTransformUtil::integrateTransform turns by the whole angle, but not beyond a limit.
double Scene::turn(double spin, double dt) {
  return std::min(spin * dt, static_cast<double>(ANGULAR_MOTION_THRESHOLD));
}

/// Every setting is Bullet's own, but that loads stay awake until `let_sleep`.
struct Scene::Engine {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};
  btEmptyShape nothing;
  btBoxShape box{btVector3(btScalar(0.1), btScalar(0.1), btScalar(0.1))};
  btStaticPlaneShape plane{btVector3(0, 1, 0), 0};
  btScalar dt;
  std::vector<std::unique_ptr<HookPose>> poses;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::vector<std::unique_ptr<btRigidBody>> ground;
  std::vector<btCableConstraint*> cables;
  std::vector<std::unique_ptr<btTypedConstraint>> constraints;
  std::function<void(double)> forces;

  explicit Engine(double rate) : dt(static_cast<btScalar>(1.0 / rate)) {
    world.setInternalTickCallback(&begin_step, this, true);
  }

  static void begin_step(btDynamicsWorld* of, btScalar time_step) {
    const Engine& here = *static_cast<Engine*>(of->getWorldUserInfo());
    if (here.forces) {
      here.forces(time_step);
    }
  }

  std::unique_ptr<btRigidBody> make(double mass, btCollisionShape& shape, const btVector3& inertia,
                                    const Vec3& position) {
    auto result = std::make_unique<btRigidBody>(btRigidBody::btRigidBodyConstructionInfo(
        static_cast<btScalar>(mass), nullptr, &shape, inertia));
    result->setWorldTransform(btTransform(btQuaternion::getIdentity(), bullet(position)));
    result->setInterpolationWorldTransform(result->getWorldTransform());
    return result;
  }
  int add(std::unique_ptr<btRigidBody> body) {
    bodies.push_back(std::move(body));
    return static_cast<int>(bodies.size()) - 1;
  }
  [[nodiscard]] btRigidBody& body(int index) const {
    return *bodies[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] btCableConstraint& cable(int index) const {
    return *cables[static_cast<std::size_t>(index)];
  }
  void add(std::unique_ptr<btTypedConstraint> constraint) {
    world.addConstraint(constraint.get());
    constraints.push_back(std::move(constraint));
  }
};

Scene::Scene(double down, double rate) : engine_(std::make_unique<Engine>(rate)) {
  engine_->world.setGravity(btVector3(0, static_cast<btScalar>(-down), 0));
}

Scene::~Scene() {
  for (const auto& constraint : engine_->constraints) {
    engine_->world.removeConstraint(constraint.get());
  }
  for (auto* bodies : {&engine_->bodies, &engine_->ground}) {
    for (const auto& body : *bodies) {
      engine_->world.removeRigidBody(body.get());
    }
  }
}

int Scene::add_body(double mass, const Vec3& moments, const Vec3& position, const Vec3& velocity) {
  auto body = engine_->make(mass, engine_->nothing, bullet(moments), position);
  body->setLinearVelocity(bullet(velocity));
  body->setActivationState(DISABLE_DEACTIVATION);
  engine_->world.addRigidBody(body.get(), 0, 0);
  return engine_->add(std::move(body));
}

int Scene::add_box(double mass, const Vec3& position) {
  btVector3 inertia;
  engine_->box.calculateLocalInertia(static_cast<btScalar>(mass), inertia);
  auto body = engine_->make(mass, engine_->box, inertia, position);
  engine_->world.addRigidBody(body.get());
  return engine_->add(std::move(body));
}

int Scene::add_hook(const Vec3& position) {
  auto pose = std::make_unique<HookPose>();
  pose->pose.setOrigin(bullet(position));
  auto body = std::make_unique<btRigidBody>(
      btRigidBody::btRigidBodyConstructionInfo(0, pose.get(), &engine_->nothing));
  body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
  body->setActivationState(DISABLE_DEACTIVATION);
  engine_->world.addRigidBody(body.get(), 0, 0);
  engine_->poses.push_back(std::move(pose));
  return engine_->add(std::move(body));
}

int Scene::add_cable(const CableData& data) {
  const CableEnd& first = data.first;
  const CableEnd& second = data.second;
  const auto length = static_cast<btScalar>(data.length);
  auto cable = second.body < 0 ? std::make_unique<btCableConstraint>(engine_->body(first.body),
                                                                     bullet(first.point),
                                                                     bullet(second.point), length)
                               : std::make_unique<btCableConstraint>(
                                     engine_->body(first.body), engine_->body(second.body),
                                     bullet(first.point), bullet(second.point), length);
  cable->setRestitution(static_cast<btScalar>(data.restitution));
  CableElasticity elasticity;
  elasticity.stiffness = data.stiffness;
  elasticity.damping = data.damping;
  elasticity.damping_ratio = data.damping_ratio;
  cable->setElasticity(elasticity);
  engine_->cables.push_back(cable.get());
  engine_->add(std::move(cable));
  return static_cast<int>(engine_->cables.size()) - 1;
}

void Scene::add_ball_joint(int body, const Vec3& point, int other) {
  btRigidBody& first = engine_->body(body);
  if (other < 0) {
    engine_->add(std::make_unique<btPoint2PointConstraint>(first, bullet(point)));
    return;
  }
  btRigidBody& second = engine_->body(other);
  const btVector3 at = first.getCenterOfMassTransform() * bullet(point);
  engine_->add(std::make_unique<btPoint2PointConstraint>(
      first, second, bullet(point), second.getCenterOfMassTransform().inverse() * at));
}

void Scene::add_ground() {
  engine_->ground.push_back(engine_->make(0, engine_->plane, btVector3(0, 0, 0), Vec3::Zero()));
  engine_->world.addRigidBody(engine_->ground.back().get());
}

void Scene::add_scenery() {
  add_ground();
  for (int level = 0; level < 3; ++level) {
    add_box(1.0, Vec3(5.0, 0.1 + 0.21 * level, 0.0));
    add_box(1.0, Vec3(-5.0, 1.0 + level, 0.0));
  }
}

void Scene::set_velocity(int body, const Vec3& velocity, const Vec3& spin) {
  engine_->body(body).setLinearVelocity(bullet(velocity));
  engine_->body(body).setAngularVelocity(bullet(spin));
}

void Scene::move_hook(int hook, const Vec3& position) {
  static_cast<HookPose*>(engine_->body(hook).getMotionState())->pose.setOrigin(bullet(position));
}

void Scene::wind(int cable, double rate) {
  engine_->cable(cable).setMaxLengthRate(static_cast<btScalar>(rate));
}

void Scene::keep_awake(int body) { engine_->body(body).setActivationState(DISABLE_DEACTIVATION); }

void Scene::let_sleep() {
  for (const auto& body : engine_->bodies) {
    body->forceActivationState(ACTIVE_TAG);
  }
}

void Scene::rebound_by_energy(int cable) { engine_->cable(cable).setReboundByEnergy(true); }

void Scene::break_at_tension(int cable, double tension) {
  engine_->cable(cable).setBreakingTension(static_cast<btScalar>(tension));
}

void Scene::set_length_rate(int cable, double rate) {
  engine_->cable(cable).setMaxLengthRate(static_cast<btScalar>(rate));
}

bool Scene::use_quick_step() { return false; }

void Scene::push(int body, const Vec3& force, const Vec3& torque) {
  engine_->body(body).applyCentralForce(bullet(force));
  engine_->body(body).applyTorque(bullet(torque));
}

void Scene::push_at(int body, const Vec3& force, const Vec3& point) {
  btRigidBody& at = engine_->body(body);
  at.applyForce(bullet(force), bullet(point) - at.getCenterOfMassPosition());
}

void Scene::push_in_steps(std::function<void(double)> forces) {
  engine_->forces = std::move(forces);
}

void Scene::step() {
  engine_->world.stepSimulation(engine_->dt, 0);  // one step of this length
}

int Scene::step_by_events() {
  return btStepWithCables(&engine_->world, engine_->cables.data(),
                          static_cast<int>(engine_->cables.size()), engine_->dt);
}

double Scene::dt() const { return engine_->dt; }
int Scene::count() const { return static_cast<int>(engine_->bodies.size()); }

BodyState Scene::body(int index) const {
  const btRigidBody& body = engine_->body(index);
  const btMatrix3x3& axes = body.getCenterOfMassTransform().getBasis();
  BodyState result;
  result.position = eigen(body.getCenterOfMassPosition());
  result.axes.col(0) = eigen(axes.getColumn(0));
  result.axes.col(1) = eigen(axes.getColumn(1));
  result.axes.col(2) = eigen(axes.getColumn(2));
  result.velocity = eigen(body.getLinearVelocity());
  result.spin = eigen(body.getAngularVelocity());
  result.mass = 1.0 / static_cast<double>(body.getInvMass());
  result.moments = eigen(body.getInvInertiaDiagLocal()).cwiseInverse();
  return result;
}

bool Scene::sleeps(int body) const {
  return engine_->body(body).getActivationState() == ISLAND_SLEEPING;
}

bool Scene::touched(int body) const {
  btDispatcher& dispatcher = engine_->dispatcher;
  for (int index = 0; index < dispatcher.getNumManifolds(); ++index) {
    const btPersistentManifold& manifold = *dispatcher.getManifoldByIndexInternal(index);
    const btCollisionObject* one = &engine_->body(body);
    if (manifold.getNumContacts() > 0 &&
        (manifold.getBody0() == one || manifold.getBody1() == one)) {
      return true;
    }
  }
  return false;
}

double Scene::impulse(int cable) const { return engine_->cable(cable).getAppliedImpulse(); }
double Scene::impact_impulse(int cable) const { return engine_->cable(cable).getImpactImpulse(); }
double Scene::taut_tension(int cable) const { return engine_->cable(cable).getTautTension(); }
double Scene::peak_tension(int cable) const { return engine_->cable(cable).getPeakTension(); }
bool Scene::broken(int cable) const { return !engine_->cable(cable).isEnabled(); }
bool Scene::taut(int cable) const { return engine_->cable(cable).isTaut(); }
double Scene::reported_gap(int cable) const { return engine_->cable(cable).getGap(); }
double Scene::reported_gap_rate(int cable) const { return engine_->cable(cable).getGapRate(); }

}  // namespace tautline::test
