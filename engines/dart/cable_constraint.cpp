#include "cable_constraint.hpp"

#include <dart/dynamics/Skeleton.hpp>
#include <limits>
#include <utility>

namespace tautline::dart_engine {

CableConstraint::CableConstraint(std::vector<dart::dynamics::BodyNode*> bodies)
    : bodies_(std::move(bodies)) {
  mDim = 1;
}

void CableConstraint::pull(std::vector<Eigen::Vector6d> directions, double rate) {
  directions_ = std::move(directions);
  rate_ = rate;
  acts_ = true;
}

/// DART solves A x = b + w with x between the bounds: b is the change of the gap rate that is
/// wanted. The bodies have been accelerated by gravity since `pull`.
void CableConstraint::getInformation(dart::constraint::ConstraintInfo* info) {
  info->lo[0] = 0.0;
  info->hi[0] = std::numeric_limits<double>::infinity();
  info->b[0] = rate_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    info->b[0] -= directions_[i].dot(bodies_[i]->getSpatialVelocity());
  }
  info->x[0] = 0.0;  // the impulse of a bounce is no guess for the next
  info->w[0] = 0.0;
}

/// No body hangs on another one, so that the impulses on each can be noted one after the other.
void CableConstraint::applyUnitImpulse(std::size_t /*index*/) {
  const auto skeleton = bodies_.front()->getSkeleton();
  skeleton->clearConstraintImpulses();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    skeleton->updateBiasImpulse(bodies_[i], directions_[i]);
  }
  skeleton->updateVelocityChange();
}

void CableConstraint::getVelocityChange(double* change, bool /*with_softness*/) {
  *change = 0.0;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    *change += directions_[i].dot(bodies_[i]->getBodyVelocityChange());
  }
}

void CableConstraint::excite() { bodies_.front()->getSkeleton()->setImpulseApplied(true); }
void CableConstraint::unexcite() { bodies_.front()->getSkeleton()->setImpulseApplied(false); }

void CableConstraint::applyImpulse(double* impulse) {
  impulse_ = *impulse;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i]->addConstraintImpulse(directions_[i] * *impulse);
  }
}

dart::dynamics::SkeletonPtr CableConstraint::getRootSkeleton() const {
  return ConstraintBase::getRootSkeleton(bodies_.front()->getSkeleton());
}

}  // namespace tautline::dart_engine
