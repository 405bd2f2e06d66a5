#pragma once

#include <optional>

#include "tautline/case.hpp"
#include "tautline/detail/first_contact.hpp"

namespace tautline {

/// How small the remaining bounces must be before they are completed at once.
struct CompletionLimits {
  /// Completing changes the later velocities by at most about this fraction of their scale [-].
  /// The default is below rounding: rebounds of some 1e-6 m/s in systems of sizes near one.
  double error = 1e-16;
  /// Instead of `error`, if given: no remaining rebound is faster than this [m/s].
  std::optional<double> speed;
  /// How many times its scale a derivative may be while the bounces last [-].
  double margin = 20.0;
};

/// What an accumulation of impacts, infinitely many bounces that end within a finite time, comes
/// to.
template <class TheCase>
struct BasicCompletion {
  using Real = RealOf<TheCase>;

  CableSet cables;         // taut when it is over
  bool ends;               // false: an elastic cable goes on bouncing, too low to matter
  Real remaining;          // [s] to the limit of the impact times, if it ends
  Real uncertainty;        // [s] of `remaining`
  Real error;              // [-], what completing changes the later velocities by
  StateOf<TheCase> after;  // projected onto the taut cables, M-orthogonally (Eq. 18)
};
using Completion = BasicCompletion<Case>;

/// The completion of the bounces of the cables in `touching` from `state` on. None if they rest
/// already, will leave, still bounce faster than `limits` allow, or if the certificate of
/// analytic/README.md section 5 fails.
template <class TheCase>
[[nodiscard]] std::optional<BasicCompletion<TheCase>> completion(
    const TheCase& the_case, const StateOf<TheCase>& state, const TouchingOf<TheCase>& touching,
    const CompletionLimits& limits = {});

}  // namespace tautline
