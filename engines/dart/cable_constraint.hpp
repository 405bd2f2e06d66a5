#pragma once

#include <dart/constraint/ConstraintBase.hpp>
#include <dart/dynamics/BodyNode.hpp>

#include <vector>

namespace tautline::dart_engine {

/// A one-sided constraint row on bodies of one skeleton, as DART's own constraints are made: the
/// solver asks it for bounds and a right-hand side, and for the velocity changes that impulses
/// make.
class CableConstraint final : public dart::constraint::ConstraintBase {
 public:
  explicit CableConstraint(std::vector<dart::dynamics::BodyNode*> bodies);

  /// From now on it acts: after a solve the bodies move along `directions`, one for each, with at
  /// least `rate` [m/s] in sum: moment and force of a pull of 1 N, in the axes of the body.
  void pull(std::vector<Eigen::Vector6d> directions, double rate);
  void let_go() { acts_ = false; }

  /// In the latest solve [N s], >= 0.
  [[nodiscard]] double impulse() const { return impulse_; }

  void update() override { impulse_ = 0.0; }
  void getInformation(dart::constraint::ConstraintInfo* info) override;
  void applyUnitImpulse(std::size_t index) override;
  void getVelocityChange(double* change, bool with_softness) override;
  void excite() override;
  void unexcite() override;
  void applyImpulse(double* impulse) override;
  [[nodiscard]] bool isActive() const override { return acts_; }
  [[nodiscard]] dart::dynamics::SkeletonPtr getRootSkeleton() const override;

 private:
  std::vector<dart::dynamics::BodyNode*> bodies_;
  std::vector<Eigen::Vector6d> directions_;
  double rate_ = 0.0;     // [m/s], wanted
  double impulse_ = 0.0;  // [N s]
  bool acts_ = false;
};

}  // namespace tautline::dart_engine
