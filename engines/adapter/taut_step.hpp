#pragma once

#include "tautline/event_adapter.hpp"

namespace tautline {

/// Moves the body of `adapter` by `dt` [s] > 0 while the cables `held`, at zero gap and rate, stay
/// taut as long as they pull. Second order in `dt`: the scheme RATTLE (Andersen 1983), of flights
/// and solves of the engine's own. False where no impulses are
/// found that hold them; the body is then anywhere.
[[nodiscard]] bool taut_step(const Case& the_case, EventAdapter& adapter, CableSet held, double dt);

}  // namespace tautline
