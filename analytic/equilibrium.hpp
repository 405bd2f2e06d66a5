#pragma once

#include <optional>

#include "tautline/hold.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// True where the body may turn for ever and nothing notices: every cable of `taut` is attached at
/// its centre, and no other can become taut whatever the angle.
template <class Real>
[[nodiscard]] bool turns_freely(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                CableSet taut);

/// How a body ends that has no speed, with the motion `held` from `state`: Ending::rest or
/// Ending::unstable_rest. None where it will move.
template <class Real>
[[nodiscard]] std::optional<Ending> equilibrium(const BasicCase<Real>& the_case,
                                                const BasicState<Real>& state,
                                                const BasicHold<Real>& held);

}  // namespace tautline
