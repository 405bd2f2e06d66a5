#pragma once

#include <optional>

#include "tautline/detail/hold.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// True where the body may turn for ever and nothing notices: every cable of `taut` is attached at
/// its centre, and no other can become taut whatever the angle.
template <class Real>
[[nodiscard]] bool turns_freely(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                CableSet taut);

/// The body of `state` at rest, where `taut` holds it; it keeps a turn that nothing notices.
template <class Real>
[[nodiscard]] BasicState<Real> resting(const BasicCase<Real>& the_case,
                                       const BasicState<Real>& state, CableSet taut) {
  BasicState<Real> still = standing_still(state);
  if (turns_freely(the_case, state, taut)) {
    still.spin = state.spin;
  }
  return still;
}

/// How a body ends that has no speed, with the motion `held` from `state`: Ending::rest or
/// Ending::unstable_rest. None where it will move.
template <class Real>
[[nodiscard]] std::optional<Ending> equilibrium(const BasicCase<Real>& the_case,
                                                const BasicState<Real>& state,
                                                const BasicHold<BasicCase<Real>>& held);

}  // namespace tautline
