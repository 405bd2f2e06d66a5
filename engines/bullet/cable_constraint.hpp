#pragma once

#include <btBulletDynamicsCommon.h>

#include <vector>

#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::bullet {

/// A cable as a constraint of one row that can only pull: the solver finds the impulse >= 0 that
/// gives the gap at least a wanted rate. Bullet adds no position correction of its own to it.
class CableConstraint final : public btTypedConstraint {
 public:
  explicit CableConstraint(btRigidBody& body);

  /// From now on the gap is to have at least `rate` [m/s] after a solve.
  void pull(const CableRow& row, double rate);

  /// From now on the cable is slack.
  void let_go() { rows_ = 0; }

  /// The impulse of the latest solve [N s], >= 0.
  [[nodiscard]] double impulse();

  void getInfo1(btConstraintInfo1* info) override;
  void getInfo2(btConstraintInfo2* info) override;
  void setParam(int /*number*/, btScalar /*value*/, int /*axis*/) override {}
  [[nodiscard]] btScalar getParam(int /*number*/, int /*axis*/) const override { return 0; }

 private:
  int rows_ = 0;
  btVector3 direction_;
  btVector3 moment_;
  btScalar rate_ = 0;
};

/// Where such constraints act.
enum class Acting { in_steps, in_solves_alone };

/// One constraint per cable of a case: the `Rows` of adapter/row_model.hpp.
class CableConstraints {
 public:
  /// `world` owns them.
  CableConstraints(const Case& the_case, World& world, Acting acting);

  void pull(std::size_t index, const CableRow& row, double rate) { rows_[index]->pull(row, rate); }
  void let_go(std::size_t index) { rows_[index]->let_go(); }
  [[nodiscard]] double impulse(std::size_t index) const { return rows_[index]->impulse(); }

  [[nodiscard]] btTypedConstraint* operator[](std::size_t index) const { return rows_[index]; }

 private:
  std::vector<CableConstraint*> rows_;
};

}  // namespace tautline::bullet
