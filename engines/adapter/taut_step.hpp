#pragma once

#include <optional>

#include "tautline/event_adapter.hpp"

namespace tautline {

/// Moves the bodies of `adapter` by `dt` [s] > 0 while the cables `held`, at zero gap and rate,
/// stay taut as long as they pull. Second order in `dt`: the scheme RATTLE (Andersen 1983), of
/// flights and solves of the engine's own. The impulses of `held` over it [N s], in rising index
/// order; none where none are found that hold them: the bodies are then anywhere.
template <class TheCase>
[[nodiscard]] std::optional<CableVector> taut_step(const TheCase& the_case,
                                                   BasicEventAdapter<TheCase>& adapter,
                                                   CableSet held, double dt);

}  // namespace tautline
