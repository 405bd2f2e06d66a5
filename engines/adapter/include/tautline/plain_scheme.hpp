#pragma once

#include <span>
#include <vector>

#include "tautline/case.hpp"

namespace tautline {

/// A plain and correct scheme of fixed steps, the yardstick for all others: the velocity first,
/// then the pose. A step asks every cable that acts for its rebound, e times the rate at which it
/// closed, of all cables at once, by projected Gauss and Seidel; and it takes back a fifth of what
/// a cable is overstretched, by the pose alone. It converges with the first order of the step, and
/// has no more than a step has to have: what errs by much more than it does not owe that to its
/// step.
class PlainScheme {
 public:
  /// Which cables act in a step: those that are overstretched at its start, or those that would be
  /// at its end. The first comes late to an impact, the second early.
  enum class Acts { late, early };

  /// `the_case` may have a restitution above 1.
  PlainScheme(Case the_case, Acts acts);

  /// The body now; a caller may change it between two steps.
  [[nodiscard]] State& state() { return state_; }
  /// The body now, to read.
  [[nodiscard]] const State& state() const { return state_; }

  /// Its case; a caller may change cables and gravity between two steps.
  [[nodiscard]] Case& system() { return case_; }

  /// Advances by `dt` [s].
  void step(double dt);

  /// The impulse of each cable over the latest step [N s].
  [[nodiscard]] std::span<const double> impulses() const { return impulses_; }

 private:
  Case case_;
  Acts acts_;
  State state_;
  std::vector<double> impulses_;
};

}  // namespace tautline
