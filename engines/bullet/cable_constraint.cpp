#include "cable_constraint.hpp"

#include <memory>
#include <utility>

namespace tautline::bullet {

// no type of Bullet's own: its debug drawer casts those to its own classes
CableConstraint::CableConstraint(btRigidBody& body)
    : btTypedConstraint(MAX_CONSTRAINT_TYPE, body), direction_(0, 0, 0), moment_(0, 0, 0) {}

void CableConstraint::pull(const CableRow& row, double rate) {
  rows_ = 1;
  direction_ = vector(row.towards);
  moment_ = btVector3(0, 0, static_cast<btScalar>(row.moment));
  rate_ = static_cast<btScalar>(rate);
}

double CableConstraint::impulse() { return rows_ == 0 ? 0.0 : internalGetAppliedImpulse(); }

void CableConstraint::getInfo1(btConstraintInfo1* info) {
  info->m_numConstraintRows = rows_;
  info->nub = 0;
}

void CableConstraint::getInfo2(btConstraintInfo2* info) {
  for (int axis = 0; axis < 3; ++axis) {
    info->m_J1linearAxis[axis] = direction_[axis];
    info->m_J1angularAxis[axis] = moment_[axis];
  }
  info->m_constraintError[0] = rate_;
  info->m_lowerLimit[0] = 0;
  info->m_upperLimit[0] = SIMD_INFINITY;
}

CableConstraints::CableConstraints(const Case& the_case, World& world, Acting acting) {
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    auto constraint = std::make_unique<CableConstraint>(world.body());
    rows_.push_back(constraint.get());
    if (acting == Acting::in_steps) {
      world.add(std::move(constraint));
    } else {
      world.keep(std::move(constraint));
    }
  }
}

}  // namespace tautline::bullet
