#include "world.hpp"

#include <dart/config.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/TranslationalJoint.hpp>
#include <dart/simulation/World.hpp>

#include <utility>

#include "cable_constraint.hpp"
#include "tautline/parabola.hpp"
#include "tautline/point_mass.hpp"

namespace tautline::dart_engine {
namespace {

dart::dynamics::Inertia inertia_of(double mass, const Eigen::Vector3d& moments) {
  dart::dynamics::Inertia result;
  result.setMass(mass);
  result.setMoment(moments.x(), moments.y(), moments.z(), 0.0, 0.0, 0.0);
  return result;
}

}  // namespace

struct BareWorld::Parts {
  dart::simulation::WorldPtr world = dart::simulation::World::create("tautline");
  dart::dynamics::SkeletonPtr skeleton = dart::dynamics::Skeleton::create("bodies");
  std::vector<dart::dynamics::BodyNode*> bodies;  // owned by the skeleton
  std::vector<std::shared_ptr<CableConstraint>> cables;
  std::shared_ptr<dart::constraint::PgsBoxedLcpSolver> gauss_seidel;  // none until it is used

  [[nodiscard]] dart::constraint::ConstraintSolver& solver() const {
    return *world->getConstraintSolver();
  }
  /// The joint of a body.
  [[nodiscard]] dart::dynamics::Joint& joint(std::size_t body) const {
    return *bodies[body]->getParentJoint();
  }
  /// The joint that carries the joint of a body in space.
  [[nodiscard]] dart::dynamics::Joint& carrier(std::size_t body) const {
    return *bodies[body]->getParentBodyNode()->getParentJoint();
  }
  void add_cable(std::vector<dart::dynamics::BodyNode*> on) {
    cables.push_back(std::make_shared<CableConstraint>(std::move(on)));
    solver().addConstraint(cables.back());
  }
};

BareWorld::BareWorld() : parts_(std::make_unique<Parts>()) {}
BareWorld::~BareWorld() = default;

void BareWorld::let_go(std::size_t cable) { parts_->cables[cable]->let_go(); }

void BareWorld::step(double dt) {
  parts_->world->setTimeStep(dt);
  parts_->world->step();
}

void BareWorld::solve_here(const Iteration& iteration) {
  if (!parts_->gauss_seidel) {
    parts_->gauss_seidel = std::make_shared<dart::constraint::PgsBoxedLcpSolver>();
    auto& solver = dynamic_cast<dart::constraint::BoxedLcpConstraintSolver&>(parts_->solver());
    solver.setBoxedLcpSolver(parts_->gauss_seidel);
    solver.setSecondaryBoxedLcpSolver(nullptr);
  }
  parts_->gauss_seidel->setOption({iteration.most, 0.0, iteration.change, iteration.least_impulse});
  parts_->solver().solve();
  if (parts_->skeleton->isImpulseApplied()) {
    parts_->skeleton->computeImpulseForwardDynamics();
    parts_->skeleton->setImpulseApplied(false);
  }
}

double BareWorld::impulse(std::size_t cable) const { return parts_->cables[cable]->impulse(); }

World::World(const Case& the_case) : gravity_(the_case.gravity) {
  dart::dynamics::BodyNode* const body =
      parts().skeleton->createJointAndBodyNodePair<dart::dynamics::PlanarJoint>().second;
  body->setInertia(
      inertia_of(the_case.body.mass, Eigen::Vector3d::Constant(turnable_inertia(the_case.body))));
  parts().bodies = {body};
  parts().world->setGravity({the_case.gravity.x(), the_case.gravity.y(), 0.0});
  parts().world->addSkeleton(parts().skeleton);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    parts().add_cable({body});
  }
  place(the_case.initial);
}

State World::state() const {
  const Eigen::VectorXd pose = parts().joint(0).getPositions();
  const Eigen::VectorXd velocity = parts().joint(0).getVelocities();
  State result;
  result.position = pose.head<2>();
  result.angle = pose[2];
  result.velocity = velocity.head<2>();
  result.spin = velocity[2];
  return result;
}

void World::place(const State& state) {
  parts().joint(0).setPositions(
      Eigen::Vector3d(state.position.x(), state.position.y(), state.angle));
  parts().joint(0).setVelocities(
      Eigen::Vector3d(state.velocity.x(), state.velocity.y(), state.spin));
}

void World::kick(const Vec2& change) {
  Eigen::VectorXd velocity = parts().joint(0).getVelocities();
  velocity.head<2>() += change;
  parts().joint(0).setVelocities(velocity);
}

void World::pull(std::size_t cable, const CableRow& row, double rate) {
  // a moment about the centre of mass, where the body's frame is, and a force turned into its axes
  const Eigen::Vector3d towards(row.towards.x(), row.towards.y(), 0.0);
  Eigen::Vector6d direction;
  direction << 0.0, 0.0, row.moment,
      parts().bodies[0]->getWorldTransform().linear().transpose() * towards;
  parts().cables[cable]->pull({direction}, rate);
}

void World::fly(double dt) { fly_parabola(*this, gravity_, dt); }

SystemWorld::SystemWorld(const SpatialSystem& system) : system_(system) {
  using namespace dart::dynamics;
  for (std::size_t index = 0; index < system.bodies.size(); ++index) {
    const SpatialBody& body = system.bodies[index];
    const std::string number = std::to_string(index);
    TranslationalJoint::Properties carries;
    carries.mName = "carries" + number;
    BallJoint::Properties turns;
    turns.mName = "turns" + number;
    BodyNode* const carrier =
        parts()
            .skeleton
            ->createJointAndBodyNodePair<TranslationalJoint>(
                nullptr, carries, BodyNode::AspectProperties("carrier" + number))
            .second;
    BodyNode* const carried = parts()
                                  .skeleton
                                  ->createJointAndBodyNodePair<BallJoint>(
                                      carrier, turns, BodyNode::AspectProperties("body" + number))
                                  .second;
    // both are at the centre, so that it is all the same which of them has the mass
    carrier->setInertia(inertia_of(0.5 * body.mass, Eigen::Vector3d::Zero()));
    carried->setInertia(inertia_of(0.5 * body.mass, turnable_inertia(body)));
    parts().bodies.push_back(carried);
  }
  parts().world->addSkeleton(parts().skeleton);
  for (const SpatialCable& cable : system.cables) {
    std::vector<dart::dynamics::BodyNode*> on;
    for (const std::size_t body : pulled_bodies(cable)) {
      on.push_back(parts().bodies[body]);
    }
    parts().add_cable(on);
  }
  place(system.initial);
}

SpatialSystemState SystemWorld::state() const {
  SpatialSystemState result;
  result.time = time_;
  for (std::size_t index = 0; index < system_.bodies.size(); ++index) {
    const Eigen::Quaterniond turn(parts().bodies[index]->getWorldTransform().linear());
    SpatialState one;
    one.position = parts().carrier(index).getPositions();
    one.orientation = Quaternion(turn.w(), turn.x(), turn.y(), turn.z()).normalized();
    one.velocity = parts().carrier(index).getVelocities();
    one.spin = parts().joint(index).getVelocities();
    result.bodies.push_back(one);
  }
  return result;
}

void SystemWorld::place(const SpatialSystemState& state) {
  time_ = state.time;
  for (std::size_t index = 0; index < state.bodies.size(); ++index) {
    const SpatialState& now = state.bodies[index];
    parts().carrier(index).setPositions(now.position);
    parts().carrier(index).setVelocities(now.velocity);
    set_orientation(index, now.orientation);
    parts().joint(index).setVelocities(now.spin);
  }
}

/// The joint's own coordinates are always near a turn by 1 rad: those of a turn by less than 1e-3
/// rad are to DART a turn that is off by a sixth of its cube.
void SystemWorld::set_orientation(std::size_t index, const Quaternion& turn) {
  const Eigen::Vector3d own = Eigen::Vector3d::UnitX();  // [rad]
  const Quaternion before = product<double>(turn, conjugate<double>(quaternion_of<double>(own)));
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() =
      Eigen::Quaterniond(before[0], before[1], before[2], before[3]).toRotationMatrix();
  parts().joint(index).setTransformFromParentBodyNode(transform);
  parts().joint(index).setPositions(own);
}

void SystemWorld::step_and_follow(double dt) {
  step(dt);
  time_ += dt;
  const SpatialSystemState now = state();
  for (std::size_t index = 0; index < now.bodies.size(); ++index) {
    set_orientation(index, now.bodies[index].orientation);
  }
}

void SystemWorld::pull(std::size_t cable, const SystemRow& row, double rate) {
  std::vector<Eigen::Vector6d> directions;
  for (const std::size_t body : pulled_bodies(system_.cables[cable])) {
    Eigen::Vector6d direction;
    direction << row.wrench.segment<3>(static_cast<Eigen::Index>(6 * body + 3)),
        parts().bodies[body]->getWorldTransform().linear().transpose() * row.force(body);
    directions.push_back(direction);
  }
  parts().cables[cable]->pull(std::move(directions), rate);
}

void SystemWorld::load(const std::vector<BodyLoad>& loads, const Eigen::Vector3d& gravity) {
  if (parts().world->getGravity() != gravity) {
    parts().world->setGravity(gravity);
  }
  add(loads);
}

void SystemWorld::add(const std::vector<BodyLoad>& loads) {
  for (std::size_t index = 0; index < loads.size(); ++index) {
    parts().bodies[index]->addExtForce(loads[index].force);
    parts().bodies[index]->addExtTorque(loads[index].moment);
  }
}

void SystemWorld::advance(double dt) {
  const SpatialSystemState now = state();
  load(loads_in_step(system_, now, dt), gravity_in_step(system_, now, dt));
  step_and_follow(dt);
}

void SystemWorld::fly(double dt) {
  const SpatialSystemState now = state();
  const std::vector<BodyLoad> loads = loads_in_step(system_, now, dt);
  const Eigen::Vector3d gravity = gravity_in_step(system_, now, dt);
  const auto kick = [&](double part) {
    for (std::size_t index = 0; index < loads.size(); ++index) {
      const Gain gain =
          gain_in_step(system_.bodies[index], now.bodies[index], gravity, loads[index], part * dt);
      auto& carrier = parts().carrier(index);
      carrier.setVelocities(carrier.getVelocities() + gain.velocity);
      auto& joint = parts().joint(index);
      joint.setVelocities(joint.getVelocities() + in_the_body(now.bodies[index], gain.spin));
    }
  };
  kick(-0.5);
  load(loads, gravity);
  step_and_follow(dt);
  kick(0.5);
}

std::vector<Setting> system_settings() {
  return {
      {"joints", "TranslationalJoint, and a BallJoint on it",
       "Their velocities are those of a state: one in the world, and a spin in the body's axes."},
      {"setTransformFromParentBodyNode of the BallJoint",
       "the orientation, but for a turn by 1 rad",
       "DART takes two terms of the series of a turn by less than 1e-3 rad: 2e-10 rad off."},
      {"setGravity, addExtForce, addExtTorque",
       "what is given, as it is in the middle of the step; drag as it decays in the step",
       "DART knows no function of time."}};
}

std::string version() { return DART_VERSION; }

}  // namespace tautline::dart_engine
