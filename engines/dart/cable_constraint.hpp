#pragma once

#include <dart/constraint/ConstraintBase.hpp>
#include <dart/dynamics/BodyNode.hpp>

#include "tautline/cable_row.hpp"

namespace tautline::dart_engine {

/// A one-sided constraint row on a body, as DART's own constraints are made: the solver asks it for
/// bounds and a right-hand side, and for the velocity changes that impulses make.
class CableConstraint final : public dart::constraint::ConstraintBase {
 public:
  explicit CableConstraint(dart::dynamics::BodyNode& body);

  /// From now on it acts: after a solve the gap of `row` opens with at least `rate` [m/s].
  void pull(const CableRow& row, double rate);
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
  dart::dynamics::BodyNode& body_;
  Eigen::Vector6d direction_ = Eigen::Vector6d::Zero();  // moment and force, in the body's axes
  double rate_ = 0.0;                                    // [m/s], wanted
  double impulse_ = 0.0;                                 // [N s]
  bool acts_ = false;
};

}  // namespace tautline::dart_engine
