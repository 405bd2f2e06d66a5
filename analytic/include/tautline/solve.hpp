#pragma once

#include <cstddef>

#include "tautline/case.hpp"
#include "tautline/detail/accumulation.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// So many steps of springs within impacts take as long as one of taut motion [-].
inline constexpr std::size_t springs_per_step = 5;

/// How exactly a case is solved, and under which impact law.
struct SolveOptions {
  /// How impacts that involve several cables are resolved. One cable alone: all laws agree.
  ImpactLaw law = ImpactLaw::simultaneous;

  /// When the rest of an accumulation is completed at once. The default error is below rounding.
  CompletionLimits completion = {};

  /// The run ends with Ending::event_limit once it has this many events: about a second.
  std::size_t max_events = 200'000;

  /// The run ends with Ending::step_limit after this many steps of taut motion: about a second. A
  /// swing takes some twenty, and a turn of the body about its cables three. The steps of springs
  /// within impacts under the energetic law cost less: `springs_per_step` of them count as one.
  std::size_t max_steps = 200'000;

  /// The run ends with Ending::locked where nothing else can happen: its taut cables leave one
  /// degree of freedom, and it has swung from one turning point to the other without an event.
  bool until_locked = false;

  /// With `until_locked`, in double: the run ends at the lock already where it is certain that
  /// nothing but a swing on two cables follows, whose numbers are then right to 1e-10 of their size
  /// instead of to rounding (analytic/README.md section 6, "A swing told ahead"). This costs a
  /// fifth of following it from one turning point to the other; where it is not certain, it is
  /// followed.
  bool swing_ahead = false;

  // Shortcuts (analytic/README.md section 7) find the same motion faster. These two can be turned
  // off, so that they can be checked against the general path.

  /// Finds bounces on one cable alone the short way, in double: the same motion, to rounding.
  bool single_bounces = true;

  /// Ends the search where half a swing, or a whole turn, shows that the motion repeats. Without it
  /// a swing is followed to the duration, and `until_locked` ends a run by a swing told ahead
  /// alone.
  bool half_swings = true;
};

/// The exact motion of `the_case` from time 0. Never throws on a case without `problems`; a case
/// with problems is a caller's mistake and throws std::invalid_argument with the first of them.
template <class TheCase>
[[nodiscard]] BasicSolution<TheCase> solve(const TheCase& the_case,
                                           const SolveOptions& options = {});

}  // namespace tautline
