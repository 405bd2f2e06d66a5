#pragma once

#include <cstddef>
#include <optional>

#include "spread.hpp"
#include "tautline/solution.hpp"

namespace tautline {

// Which cables become taut at one instant: to the last bit, or by symmetry. Others that doubles do
// not tell apart do so one by one, and in which order is open.

/// True where all of `cables` are at zero gap and nothing was rounded. False where that is not
/// seen.
[[nodiscard]] bool are_exactly_taut(const Case& the_case, const State& state, CableSet cables);

/// Cables that become taut, and those of the events before.
struct Hit {
  CableSet earlier;
  CableSet now;
};

/// How much later the cables that are hit `now` become taut per unit of the state [s]: cables that
/// are alike, or that a symmetry of the motion under `law` keeps in step. None for others, which
/// need not do so at one instant.
[[nodiscard]] std::optional<StateRow> delay_of(const Case& the_case, ImpactLaw law,
                                               const State& state, const Hit& hit);

/// True where after this arc several cables are hit at once that need not be: rounding resolves
/// them together, the motion one by one. Of a solution that starts nearby the same is true.
[[nodiscard]] bool merges_after(const Case& the_case, ImpactLaw law, const Solution& solution,
                                std::size_t arc);

/// The taut cables after `event`, if these are before it.
[[nodiscard]] inline CableSet taut_after(const Event& event, CableSet before) {
  return event.kind == EventKind::taut    ? before | event.cables
         : event.kind == EventKind::slack ? before - event.cables
                                          : before;
}

}  // namespace tautline
