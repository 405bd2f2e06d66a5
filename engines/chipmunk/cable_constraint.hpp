#pragma once

#include <memory>
#include <vector>

#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::chipmunk {

/// A one-sided constraint row between the ground and the body, as Chipmunk's own joints are made: a
/// `cpConstraintClass` whose impulses the space accumulates.
class CableConstraint {
 public:
  explicit CableConstraint(World& world);
  CableConstraint(const CableConstraint&) = delete;
  CableConstraint& operator=(const CableConstraint&) = delete;
  ~CableConstraint();

  /// Lets the space of `world` ask it in steps, until it ends.
  void join(World& world) { cpSpaceAddConstraint(world.space(), &constraint_); }

  /// From now on it acts: the gap of `row` opens with at least `rate` [m/s].
  void pull(const CableRow& row, double rate);
  void let_go();

  /// One iteration of Chipmunk's solver on this row. Returns the change of the gap rate [m/s].
  double apply();

  /// [N s], >= 0, since it began to act.
  [[nodiscard]] double impulse() const { return impulse_; }

  /// Chipmunk is to call this before it asks.
  void set_before_solve(cpConstraintPreSolveFunc function) {
    cpConstraintSetPreSolveFunc(&constraint_, function);
  }

 private:
  static void prepare(cpConstraint* constraint, cpFloat dt);
  static void apply_cached(cpConstraint* constraint, cpFloat dt);
  static void apply_once(cpConstraint* constraint, cpFloat dt);
  static cpFloat impulse_of(cpConstraint* constraint);

  static const cpConstraintClass callbacks;

  cpConstraint constraint_{};
  bool acts_ = false;
  CableRow row_{};
  double rate_ = 0.0;     // [m/s], wanted
  double impulse_ = 0.0;  // [N s]
};

/// One constraint per cable of a case, not in the space: the `Rows` of adapter/row_model.hpp.
class CableConstraints {
 public:
  CableConstraints(const Case& the_case, World& world);

  void pull(std::size_t index, const CableRow& row, double rate) { rows_[index]->pull(row, rate); }
  void let_go(std::size_t index) { rows_[index]->let_go(); }
  [[nodiscard]] double impulse(std::size_t index) const { return rows_[index]->impulse(); }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }
  [[nodiscard]] CableConstraint& operator[](std::size_t index) { return *rows_[index]; }

 private:
  std::vector<std::unique_ptr<CableConstraint>> rows_;
};

}  // namespace tautline::chipmunk
