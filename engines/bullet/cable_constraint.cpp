#include "cable_constraint.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace tautline::bullet {

// no type of Bullet's own: its debug drawer casts those to its own classes
CableConstraint::CableConstraint(btRigidBody& body)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, body) {}
CableConstraint::CableConstraint(btRigidBody& a, btRigidBody& b)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, a, b) {}

void CableConstraint::pull(const Effect& a, const Effect& b, double rate) {
  rows_ = 1;
  a_ = a;
  b_ = b;
  rate_ = static_cast<btScalar>(rate);
}

double CableConstraint::impulse() { return rows_ == 0 ? 0.0 : internalGetAppliedImpulse(); }

void CableConstraint::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = rows_;
  info->nub = 0;
}

void CableConstraint::getInfo2(btConstraintInfo2* info) {
  for (int axis = 0; axis < 3; ++axis) {
    info->m_J1linearAxis[axis] = a_.force[axis];
    info->m_J1angularAxis[axis] = a_.moment[axis];
    info->m_J2linearAxis[axis] = b_.force[axis];
    info->m_J2angularAxis[axis] = b_.moment[axis];
  }
  info->m_constraintError[0] = rate_;
  info->m_lowerLimit[0] = 0;
  info->m_upperLimit[0] = SIMD_INFINITY;
}

void CableConstraints::add(std::unique_ptr<CableConstraint> constraint, BareWorld& world,
                           Acting acting) {
  rows_.push_back(constraint.get());
  if (acting == Acting::in_steps) {
    world.add(std::move(constraint));
  } else {
    world.keep(std::move(constraint));
  }
}

CableConstraints::CableConstraints(const Case& the_case, World& world, Acting acting) {
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    add(std::make_unique<CableConstraint>(world.body()), world, acting);
  }
}

void CableConstraints::pull(std::size_t index, const CableRow& row, double rate) {
  rows_[index]->pull({vector(row.towards), btVector3(0, 0, static_cast<btScalar>(row.moment))}, {},
                     rate);
}

SystemCableConstraints::SystemCableConstraints(const SpatialSystem& system, SystemWorld& world,
                                               Acting acting)
    : world_(world) {
  for (std::size_t index = 0; index < system.cables.size(); ++index) {
    bodies_.push_back(pulled_bodies(system.cables[index]));
    const std::vector<std::size_t>& on = bodies_.back();
    if (on.size() > 2) {
      throw CableRefused("Bullet's constraints join two bodies", index,
                         "pulls at " + std::to_string(on.size()));
    }
    add(on.size() == 1 ? std::make_unique<CableConstraint>(world.body(on[0]))
                       : std::make_unique<CableConstraint>(world.body(on[0]), world.body(on[1])),
        world, acting);
  }
}

void SystemCableConstraints::pull(std::size_t index, const SystemRow& row, double rate) {
  const SpatialSystemState now = world_.state();
  const auto effect = [&](std::size_t end) -> CableConstraint::Effect {
    if (end >= bodies_[index].size()) {
      return {};
    }
    const std::size_t body = bodies_[index][end];
    return {vector(row.force(body)), vector(row.moment(body, now.bodies[body]))};
  };
  rows_[index]->pull(effect(0), effect(1), rate);
}

}  // namespace tautline::bullet
