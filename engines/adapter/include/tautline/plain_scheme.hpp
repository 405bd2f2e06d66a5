#pragma once

#include <span>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// A plain and correct scheme of fixed steps, the yardstick for all others: the velocity first,
/// then the pose. A step asks every cable that acts for its rebound, e times the rate at which it
/// closed, of all cables at once, by projected Gauss and Seidel; and it takes back a fifth of what
/// a cable is overstretched, by the pose alone. Between cables' impulses the angular momentum of a
/// body in space stays as it is. An elastic cable pulls as its law has it at the start of a step.
/// The scheme converges with the first order of the step, and has no more than a step has to have:
/// what errs by much more than it does not owe that to its step. A case is a `Case` or a
/// `SpatialSystem`; what is given over time acts in a step as at its start.
template <class TheCase>
class BasicPlainScheme {
 public:
  /// Which cables act in a step: those that are overstretched at its start, or those that would be
  /// at its end. The first comes late to an impact, the second early.
  enum class Acts { late, early };

  /// `the_case` may have a restitution above 1.
  BasicPlainScheme(TheCase the_case, Acts acts);

  /// The body now; a caller may change it between two steps.
  [[nodiscard]] StateOf<TheCase>& state() { return state_; }
  /// The body now, to read.
  [[nodiscard]] const StateOf<TheCase>& state() const { return state_; }

  /// Its case; a caller may change cables and gravity between two steps.
  [[nodiscard]] TheCase& system() { return case_; }

  /// Advances by `dt` [s].
  void step(double dt);

  /// The impulse of each cable over the latest step [N s].
  [[nodiscard]] std::span<const double> impulses() const { return impulses_; }

 private:
  TheCase case_;
  Acts acts_;
  StateOf<TheCase> state_;
  std::vector<double> impulses_;
};

using PlainScheme = BasicPlainScheme<Case>;

}  // namespace tautline
