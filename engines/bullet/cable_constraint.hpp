#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::bullet {

/// A cable as a constraint of one row that can only pull: the solver finds the impulse >= 0 that
/// gives the gap at least a wanted rate. Bullet adds no position correction of its own to it.
class CableConstraint final : public btTypedConstraint {
 public:
  /// It joins a body and the world, or two bodies.
  explicit CableConstraint(btRigidBody& body);
  CableConstraint(btRigidBody& a, btRigidBody& b);

  /// A pull of 1 N does this to a body.
  struct Effect {
    btVector3 force{0, 0, 0};   // [-]
    btVector3 moment{0, 0, 0};  // [m], about its centre, in world axes
  };

  /// From now on the gap is to have at least `rate` [m/s] after a solve, of what `a` and `b` do.
  void pull(const Effect& a, const Effect& b, double rate);

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
  Effect a_;
  Effect b_;
  btScalar rate_ = 0;
};

/// Where such constraints act.
enum class Acting { in_steps, in_solves_alone };

/// One constraint per cable of a case: the `Rows` of adapter/row_model.hpp.
class CableConstraints {
 public:
  /// `world` owns them.
  CableConstraints(const Case& the_case, World& world, Acting acting);

  void pull(std::size_t index, const CableRow& row, double rate);
  void let_go(std::size_t index) { rows_[index]->let_go(); }
  [[nodiscard]] double impulse(std::size_t index) const { return rows_[index]->impulse(); }

  [[nodiscard]] btTypedConstraint* operator[](std::size_t index) const { return rows_[index]; }

 protected:
  CableConstraints() = default;
  void add(std::unique_ptr<CableConstraint> constraint, BareWorld& world, Acting acting);

  std::vector<CableConstraint*> rows_;
};

/// Rows of a system. Bullet's constraints join two bodies at most.
class SystemCableConstraints : public CableConstraints {
 public:
  /// Throws std::invalid_argument where a cable pulls at more than two bodies.
  SystemCableConstraints(const SpatialSystem& system, SystemWorld& world, Acting acting);

  void pull(std::size_t index, const SystemRow& row, double rate);

 private:
  const SystemWorld& world_;
  std::vector<std::vector<std::size_t>> bodies_;  // of each cable: one or two
};

}  // namespace tautline::bullet
