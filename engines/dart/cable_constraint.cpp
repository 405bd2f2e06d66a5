#include "cable_constraint.hpp"

#include <dart/dynamics/Skeleton.hpp>
#include <limits>

namespace tautline::dart_engine {

CableConstraint::CableConstraint(dart::dynamics::BodyNode& body) : body_(body) { mDim = 1; }

void CableConstraint::pull(const CableRow& row, double rate) {
  // a moment about the centre of mass, where the body's frame is, and a force turned into its axes
  const Eigen::Vector3d towards(row.towards.x(), row.towards.y(), 0.0);
  direction_ << 0.0, 0.0, row.moment, body_.getWorldTransform().linear().transpose() * towards;
  rate_ = rate;
  acts_ = true;
}

/// DART solves A x = b + w with x between the bounds: b is the change of the gap rate that is
/// wanted. The body has been accelerated by gravity since `pull`.
void CableConstraint::getInformation(dart::constraint::ConstraintInfo* info) {
  info->lo[0] = 0.0;
  info->hi[0] = std::numeric_limits<double>::infinity();
  info->b[0] = rate_ - direction_.dot(body_.getSpatialVelocity());
  info->x[0] = 0.0;  // the impulse of a bounce is no guess for the next
  info->w[0] = 0.0;
}

void CableConstraint::applyUnitImpulse(std::size_t /*index*/) {
  const auto skeleton = body_.getSkeleton();
  skeleton->clearConstraintImpulses();
  skeleton->updateBiasImpulse(&body_, direction_);
  skeleton->updateVelocityChange();
}

void CableConstraint::getVelocityChange(double* change, bool /*with_softness*/) {
  *change = direction_.dot(body_.getBodyVelocityChange());
}

void CableConstraint::excite() { body_.getSkeleton()->setImpulseApplied(true); }
void CableConstraint::unexcite() { body_.getSkeleton()->setImpulseApplied(false); }

void CableConstraint::applyImpulse(double* impulse) {
  impulse_ = *impulse;
  body_.addConstraintImpulse(direction_ * *impulse);
}

dart::dynamics::SkeletonPtr CableConstraint::getRootSkeleton() const {
  return ConstraintBase::getRootSkeleton(body_.getSkeleton());
}

}  // namespace tautline::dart_engine
