#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "engines/cables/scene.hpp"
#include "tautline/ode/dStepWithCables.h"

namespace tautline::test {
namespace {

Vec3 eigen(const dReal* v) { return {v[0], v[1], v[2]}; }

extern "C" {
/// ODE tells of rows that are satisfied exactly, in their thousands; the results are right.
void drop_message(int /*number*/, const char* /*format*/, va_list /*arguments*/) {}
}

/// ODE, from its first use to the end of the process.
class Library {
 public:
  static void use() { static const Library library; }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

 private:
  Library() {
    dInitODE2(0);
    dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
    dSetMessageHandler(drop_message);
  }
  ~Library() { dCloseODE(); }
};

dWorldID create_world() {
  Library::use();
  return dWorldCreate();
}

}  // namespace

const std::string Scene::engine = "ode";
const double Scene::rounding = std::numeric_limits<dReal>::epsilon();

/// ODE adds spin times quaternion and normalises.
double Scene::turn(double spin, double dt) { return 2.0 * std::atan(0.5 * spin * dt); }

/// Every setting is ODE's own.
struct Scene::Engine {
  dWorldID world = create_world();
  dSpaceID space = dHashSpaceCreate(nullptr);
  dJointGroupID contacts = dJointGroupCreate(0);
  dJointGroupID of_cables = dJointGroupCreate(0);
  dReal dt;
  bool quick = false;
  std::vector<dBodyID> bodies;
  std::vector<bool> touched;  // by body
  std::vector<dCableID> cables;
  std::function<void(double)> forces;

  explicit Engine(double rate) : dt(1.0 / rate) {}

  [[nodiscard]] dBodyID body(int index) const {
    return index < 0 ? nullptr : bodies[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] dCableID cable(int index) const { return cables[static_cast<std::size_t>(index)]; }

  int add(const dMass& mass, const Vec3& position) {
    bodies.push_back(dBodyCreate(world));
    touched.push_back(false);
    dBodySetMass(bodies.back(), &mass);
    dBodySetPosition(bodies.back(), position.x(), position.y(), position.z());
    return static_cast<int>(bodies.size()) - 1;
  }

  void touch(dBodyID body) {
    const auto found = std::find(bodies.begin(), bodies.end(), body);
    if (found != bodies.end()) {
      touched[static_cast<std::size_t>(found - bodies.begin())] = true;
    }
  }
  static void collide(void* data, dGeomID first, dGeomID second) {
    Engine& here = *static_cast<Engine*>(data);
    std::array<dContact, 8> found{};
    const int count =
        dCollide(first, second, static_cast<int>(found.size()), &found[0].geom, sizeof(dContact));
    for (std::size_t index = 0; index < static_cast<std::size_t>(count); ++index) {
      found[index].surface.mode = dContactApprox1;
      found[index].surface.mu = 0.5;
      dJointAttach(dJointCreateContact(here.world, here.contacts, &found[index]),
                   dGeomGetBody(first), dGeomGetBody(second));
      here.touch(dGeomGetBody(first));
      here.touch(dGeomGetBody(second));
    }
  }
  void solve(dReal stepsize) const {
    if (forces) {
      forces(stepsize);
    }
    quick ? dWorldQuickStep(world, stepsize) : dWorldStep(world, stepsize);
    dJointGroupEmpty(contacts);
  }
  /// A part of a step by events.
  static void step(void* data, dReal stepsize) {
    dSpaceCollide(static_cast<Engine*>(data)->space, data, &collide);
    static_cast<Engine*>(data)->solve(stepsize);
  }
};

Scene::Scene(double down, double rate) : engine_(std::make_unique<Engine>(rate)) {
  dWorldSetGravity(engine_->world, 0, -down, 0);
}

Scene::~Scene() {
  for (const dCableID cable : engine_->cables) {
    dCableDestroy(cable);
  }
  dJointGroupDestroy(engine_->contacts);
  dJointGroupDestroy(engine_->of_cables);
  dSpaceDestroy(engine_->space);
  dWorldDestroy(engine_->world);
}

int Scene::add_body(double mass, const Vec3& moments, const Vec3& position, const Vec3& velocity) {
  dMass data;
  dMassSetParameters(&data, mass, 0, 0, 0, moments.x(), moments.y(), moments.z(), 0, 0, 0);
  const int index = engine_->add(data, position);
  set_velocity(index, velocity, Vec3::Zero());
  return index;
}

int Scene::add_box(double mass, const Vec3& position) {
  dMass data;
  dMassSetBoxTotal(&data, mass, 0.2, 0.2, 0.2);
  const int index = engine_->add(data, position);
  dGeomSetBody(dCreateBox(engine_->space, 0.2, 0.2, 0.2), engine_->body(index));
  return index;
}

int Scene::add_hook(const Vec3& position) {
  dMass data;
  dMassSetSphereTotal(&data, 1.0, 0.1);  // which ODE wants and does not use
  const int index = engine_->add(data, position);
  dBodySetKinematic(engine_->body(index));
  return index;
}

int Scene::add_cable(const CableData& data) {
  const dCableID cable = dCableCreate();
  dCableAttach(cable, engine_->body(data.first.body), engine_->body(data.second.body));
  const auto place = [this](const CableEnd& end) {
    dVector3 result = {end.point.x(), end.point.y(), end.point.z(), 0};
    if (end.body >= 0) {
      dBodyGetRelPointPos(engine_->body(end.body), end.point.x(), end.point.y(), end.point.z(),
                          result);
    }
    return eigen(result);
  };
  const Vec3 first = place(data.first);
  const Vec3 second = place(data.second);
  dCableSetAnchor1(cable, first.x(), first.y(), first.z());
  dCableSetAnchor2(cable, second.x(), second.y(), second.z());
  dCableSetLength(cable, data.length);
  dCableSetBounce(cable, data.restitution);
  CableElasticity elasticity;
  elasticity.stiffness = data.stiffness;
  elasticity.damping = data.damping;
  elasticity.damping_ratio = data.damping_ratio;
  dCableSetElasticity(cable, elasticity);
  engine_->cables.push_back(cable);
  return static_cast<int>(engine_->cables.size()) - 1;
}

void Scene::add_ball_joint(int body, const Vec3& point, int other) {
  const dJointID joint = dJointCreateBall(engine_->world, nullptr);
  dJointAttach(joint, engine_->body(body), engine_->body(other));
  dJointAttach(joint, engine_->body(body), nullptr);
  dVector3 at;
  dBodyGetRelPointPos(engine_->body(body), point.x(), point.y(), point.z(), at);
  dJointSetBallAnchor(joint, at[0], at[1], at[2]);
}

void Scene::add_ground() { dCreatePlane(engine_->space, 0, 1, 0, 0); }

void Scene::add_scenery() {
  add_ground();
  for (int level = 0; level < 3; ++level) {
    add_box(1.0, Vec3(5.0, 0.1 + 0.21 * level, 0.0));
    add_box(1.0, Vec3(-5.0, 1.0 + level, 0.0));
  }
}

void Scene::set_velocity(int body, const Vec3& velocity, const Vec3& spin) {
  dBodySetLinearVel(engine_->body(body), velocity.x(), velocity.y(), velocity.z());
  dBodySetAngularVel(engine_->body(body), spin.x(), spin.y(), spin.z());
}

void Scene::move_hook(int hook, const Vec3& position) {
  const Vec3 velocity = (position - eigen(dBodyGetPosition(engine_->body(hook)))) / engine_->dt;
  dBodySetLinearVel(engine_->body(hook), velocity.x(), velocity.y(), velocity.z());
}

void Scene::wind(int cable, double rate) { dCableSetLengthRate(engine_->cable(cable), rate); }

void Scene::keep_awake(int body) { dBodySetAutoDisableFlag(engine_->body(body), 0); }

void Scene::let_sleep() {
  for (const dBodyID body : engine_->bodies) {
    dBodySetAutoDisableFlag(body, 1);
  }
}

void Scene::rebound_by_energy(int cable) { dCableSetBounceByEnergy(engine_->cable(cable), 1); }

void Scene::break_at_tension(int cable, double tension) {
  dCableSetBreakingTension(engine_->cable(cable), tension);
}

void Scene::set_length_rate(int cable, double rate) {
  dCableSetLengthRate(engine_->cable(cable), rate);
}

void Scene::push(int body, const Vec3& force, const Vec3& torque) {
  dBodyAddForce(engine_->body(body), force.x(), force.y(), force.z());
  dBodyAddTorque(engine_->body(body), torque.x(), torque.y(), torque.z());
}

void Scene::push_at(int body, const Vec3& force, const Vec3& point) {
  dBodyAddForceAtPos(engine_->body(body), force.x(), force.y(), force.z(), point.x(), point.y(),
                     point.z());
}

void Scene::push_in_steps(std::function<void(double)> forces) {
  engine_->forces = std::move(forces);
}

bool Scene::use_quick_step() {
  engine_->quick = true;
  return true;
}

void Scene::step() {
  std::fill(engine_->touched.begin(), engine_->touched.end(), false);
  dSpaceCollide(engine_->space, engine_.get(), &Engine::collide);
  dCableAddContacts(engine_->world, engine_->of_cables, engine_->cables.data(),
                    static_cast<int>(engine_->cables.size()), engine_->dt);
  engine_->solve(engine_->dt);
  dJointGroupEmpty(engine_->of_cables);
}

int Scene::step_by_events() {
  std::fill(engine_->touched.begin(), engine_->touched.end(), false);
  return dStepWithCables(engine_->world, engine_->of_cables, engine_->cables.data(),
                         static_cast<int>(engine_->cables.size()), engine_->dt, &Engine::step,
                         engine_.get());
}

double Scene::dt() const { return engine_->dt; }
int Scene::count() const { return static_cast<int>(engine_->bodies.size()); }

BodyState Scene::body(int index) const {
  const dBodyID body = engine_->body(index);
  const dReal* rotation = dBodyGetRotation(body);
  dMass mass;
  dBodyGetMass(body, &mass);
  BodyState result;
  result.position = eigen(dBodyGetPosition(body));
  // rows of three, each in four places
  result.axes.row(0) = eigen(&rotation[0]);
  result.axes.row(1) = eigen(&rotation[4]);
  result.axes.row(2) = eigen(&rotation[8]);
  result.velocity = eigen(dBodyGetLinearVel(body));
  result.spin = eigen(dBodyGetAngularVel(body));
  const bool hook = dBodyIsKinematic(body) != 0;
  const double infinite = std::numeric_limits<double>::infinity();
  result.mass = hook ? infinite : mass.mass;
  result.moments = hook ? Vec3::Constant(infinite) : Vec3(mass.I[0], mass.I[5], mass.I[10]);
  return result;
}

bool Scene::sleeps(int body) const { return dBodyIsEnabled(engine_->body(body)) == 0; }
bool Scene::touched(int body) const { return engine_->touched[static_cast<std::size_t>(body)]; }

double Scene::impulse(int cable) const { return dCableGetImpulse(engine_->cable(cable)); }
double Scene::impact_impulse(int cable) const {
  return dCableGetImpactImpulse(engine_->cable(cable));
}
double Scene::taut_tension(int cable) const { return dCableGetTautTension(engine_->cable(cable)); }
double Scene::peak_tension(int cable) const { return dCableGetPeakTension(engine_->cable(cable)); }
bool Scene::broken(int cable) const { return dCableIsBroken(engine_->cable(cable)) != 0; }
bool Scene::taut(int cable) const { return dCableIsTaut(engine_->cable(cable)) != 0; }
double Scene::reported_gap(int cable) const { return dCableGetGap(engine_->cable(cable)); }
double Scene::reported_gap_rate(int cable) const { return dCableGetGapRate(engine_->cable(cable)); }

}  // namespace tautline::test
