#pragma once

#include <optional>
#include <type_traits>

#include "bench/measure/reference.hpp"

namespace tautline::bench {

/// The steps that a step-by-step model needs for a case, from what the plain scheme is off by over
/// shifts of its first step: by the worst of them and by their mean. scripts/judgement --safe-steps
/// counts the runs of sound models that hold `safe`.
struct StepNeeded {
  double part = 0.0;     // [-], of the shortest cable, that the position may be off by
  double until = 0.0;    // [s], up to here
  double safe = 0.0;     // [s], 1, 2 or 5 times a power of ten; 0 with `unlike`; a guess if it
                         // is below `shortest_needed`
  double typical = 0.0;  // [s], the same
  bool longest = false;  // `safe` is the longest step that is considered: all shorter ones do
  /// The first impact that the law of the exact motion resolves otherwise than the plain scheme
  /// [s], whose law is `simultaneous`: with one before `until` the plain scheme says nothing.
  std::optional<double> unlike;

  /// `step`, which is `safe` or `typical`, where the plain scheme says it.
  [[nodiscard]] std::optional<double> known(double step) const {
    return unlike ? std::nullopt : std::optional(step);
  }
};

/// The largest steps with an error of `part` [-] of the shortest cable of `reference`, of a case or
/// of a system, at most, over the first `usual_window` seconds of it: log error over log step,
/// between steps of 1e-2, 1e-3 and 1e-4 s. The plain scheme runs with the result, and a shorter one
/// is taken if that is too much.
template <class TheReference>
[[nodiscard]] StepNeeded step_needed(const TheReference& reference, double part);

/// The usual question: this part of the shortest cable [-], over this time [s].
inline constexpr double usual_window = 3.0;
inline constexpr double usual_part = 0.01;

/// The plain scheme runs with no shorter step [s]: it would take too long. A step of a system takes
/// ten times as long.
[[nodiscard]] constexpr double shortest_needed(bool of_a_system) {
  return of_a_system ? 1e-4 : 1e-5;
}
template <class TheReference>
inline constexpr double shortest_needed_for =
    shortest_needed(std::is_same_v<TheReference, ReferenceSystem>);

/// The largest of 1, 2 and 5 times a power of ten that is no larger than `step` [s].
[[nodiscard]] double rounded_down(double step);

/// The next smaller one of these.
[[nodiscard]] double next_smaller(double step);

}  // namespace tautline::bench
