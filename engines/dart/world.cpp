#include "world.hpp"

#include <dart/config.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include "cable_constraint.hpp"
#include "tautline/point_mass.hpp"

namespace tautline::dart_engine {
namespace {

dart::dynamics::Inertia inertia_of(const Body& body) {
  const double about_z = turnable_inertia(body);
  dart::dynamics::Inertia result;
  result.setMass(body.mass);
  result.setMoment(about_z, about_z, about_z, 0.0, 0.0, 0.0);
  return result;
}

}  // namespace

struct World::Parts {
  dart::simulation::WorldPtr world = dart::simulation::World::create("tautline");
  dart::dynamics::SkeletonPtr skeleton = dart::dynamics::Skeleton::create("body");
  dart::dynamics::PlanarJoint* joint = nullptr;  // owned by the skeleton
  std::vector<std::shared_ptr<CableConstraint>> cables;
  std::shared_ptr<dart::constraint::PgsBoxedLcpSolver> gauss_seidel;  // none until it is used

  [[nodiscard]] dart::constraint::ConstraintSolver& solver() const {
    return *world->getConstraintSolver();
  }
};

World::World(const Case& the_case) : parts_(std::make_unique<Parts>()) {
  const auto [joint, body] =
      parts_->skeleton->createJointAndBodyNodePair<dart::dynamics::PlanarJoint>();
  body->setInertia(inertia_of(the_case.body));
  parts_->joint = joint;
  parts_->world->setGravity({the_case.gravity.x(), the_case.gravity.y(), 0.0});
  parts_->world->addSkeleton(parts_->skeleton);
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    parts_->cables.push_back(std::make_shared<CableConstraint>(*body));
    parts_->solver().addConstraint(parts_->cables.back());
  }
  place(the_case.initial);
}

World::~World() = default;

State World::state() const {
  const Eigen::VectorXd pose = parts_->joint->getPositions();
  const Eigen::VectorXd velocity = parts_->joint->getVelocities();
  State result;
  result.position = pose.head<2>();
  result.angle = pose[2];
  result.velocity = velocity.head<2>();
  result.spin = velocity[2];
  return result;
}

void World::place(const State& state) {
  parts_->joint->setPositions(Eigen::Vector3d(state.position.x(), state.position.y(), state.angle));
  parts_->joint->setVelocities(Eigen::Vector3d(state.velocity.x(), state.velocity.y(), state.spin));
}

void World::kick(const Vec2& change) {
  Eigen::VectorXd velocity = parts_->joint->getVelocities();
  velocity.head<2>() += change;
  parts_->joint->setVelocities(velocity);
}

void World::pull(std::size_t cable, const CableRow& row, double rate) {
  parts_->cables[cable]->pull(row, rate);
}

void World::let_go(std::size_t cable) { parts_->cables[cable]->let_go(); }

void World::advance(double dt) {
  parts_->world->setTimeStep(dt);
  parts_->world->step();
}

void World::solve_here(const Iteration& iteration) {
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

double World::impulse(std::size_t cable) const { return parts_->cables[cable]->impulse(); }

std::string version() { return DART_VERSION; }

}  // namespace tautline::dart_engine
