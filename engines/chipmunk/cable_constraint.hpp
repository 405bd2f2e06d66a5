#pragma once

#include <memory>
#include <vector>

#include "tautline/cable_row.hpp"
#include "world.hpp"

namespace tautline::chipmunk {

/// How a cable acts by itself in a step of a space.
struct FixedStepCable {
  Activation activation;
  double correction;  // [1/s], part of the overstretch
};

/// A one-sided constraint row between the ground and the body, as Chipmunk's own joints are made: a
/// `cpConstraintClass` whose impulses the space accumulates.
class CableConstraint {
 public:
  CableConstraint(World& world, const Cable& cable);
  CableConstraint(const CableConstraint&) = delete;
  CableConstraint& operator=(const CableConstraint&) = delete;
  ~CableConstraint() = default;

  /// From now on it looks at the cable in every step of the space and acts where it should.
  void act_in_steps(const FixedStepCable& how) { how_ = how; }

  /// Lets it act at the present pose: the gap opens with at least `rate` [m/s].
  void pull(double rate);
  void let_go();

  /// One iteration of Chipmunk's solver on this row. Returns the change of the gap rate [m/s].
  double apply();

  /// [N s], >= 0, since it began to act.
  [[nodiscard]] double impulse() const { return impulse_; }

  [[nodiscard]] cpConstraint* constraint() { return &constraint_; }

 private:
  static void prepare(cpConstraint* constraint, cpFloat dt);
  static void apply_cached(cpConstraint* constraint, cpFloat dt);
  static void apply_once(cpConstraint* constraint, cpFloat dt);
  static cpFloat impulse_of(cpConstraint* constraint);

  static const cpConstraintClass callbacks;

  cpConstraint constraint_{};
  Cable cable_;
  std::optional<FixedStepCable> how_;
  bool acts_ = false;
  CableRow row_{};
  double rate_ = 0.0;     // [m/s], wanted
  double impulse_ = 0.0;  // [N s]
};

/// One constraint per cable of `the_case`, not in the space yet.
[[nodiscard]] std::vector<std::unique_ptr<CableConstraint>> cable_constraints(const Case& the_case,
                                                                              World& world);

}  // namespace tautline::chipmunk
