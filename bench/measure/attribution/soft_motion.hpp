#pragma once

#include <optional>
#include <span>
#include <string>

#include "tautline/case.hpp"
#include "tautline/engine.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

// The motion of a case whose cables are springs and dampers of an engine (`SoftRow`): what the
// engine would do if its steps were short. An elastic cable of the solver has one stiffness for all
// poses and bears the whole load. A soft row has the response of each pose, and may take over the
// load: then a slow impact rebounds as a fast one does, and a body that hangs sags by nothing. So
// the motion has a way of its own:
//
//   slack      the exact motion, until the first cable reaches its length
//   stretched  steps of 1/100 of the time sqrt(1/stiffness): half of the pull's impulse, a free
//              flight, the other half; of second order, off by 1e-5 of a contact

/// The end of that motion, or why it is not found.
template <class TheState>
struct SoftEnd {
  std::optional<TheState> state;
  std::string why;  // a sentence without its point; "" with a state

  explicit operator bool() const { return state.has_value(); }
  const TheState* operator->() const { return &state.value(); }
};

/// `the_case` at `time` [s] if its cables are `rows`, one for each; not found where that takes too
/// many steps or the motion between two contacts cannot be found.
[[nodiscard]] SoftEnd<State> soft_motion(const Case& the_case, std::span<const SoftRow> rows,
                                         double time);
/// Likewise of a system.
[[nodiscard]] SoftEnd<SpatialSystemState> soft_motion(const SpatialSystem& system,
                                                      std::span<const SoftRow> rows, double time);

}  // namespace tautline::bench
