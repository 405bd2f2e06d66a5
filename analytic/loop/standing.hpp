#pragma once

#include <optional>

#include "equilibrium.hpp"
#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/hold.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// The cables at zero gap at the start, by the rounding of the numbers given.
template <class TheCase>
[[nodiscard]] CableSet touching_at_start(const TheCase& the_case) {
  CableSet touching;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (starts_at_zero(the_case.cables[index], the_case.initial)) {
      touching.insert(index);
    }
  }
  return touching;
}

/// How touching cables stand.
struct Contacts {
  CableSet closing;
  CableSet resting;
};

/// The cables at zero gap that close now and those that rest, up to rounding.
template <class TheCase>
[[nodiscard]] Contacts contacts(const TheCase& the_case, const StateOf<TheCase>& state,
                                const TouchingOf<TheCase>& touching) {
  using Real = RealOf<TheCase>;
  Contacts result;
  for (const std::size_t index : touching.cables) {
    const Real rate = gap_rate(the_case.cables[index], state);
    const Real rounding = touching.rounding(the_case.cables[index]);
    if (rate < -rounding) {
      result.closing.insert(index);
    } else if (rate <= rounding) {
      result.resting.insert(index);
    }
  }
  return result;
}

/// True where what is left of the motion is rounding of the motion before, between cables that
/// leave it nowhere to go.
template <class TheCase>
[[nodiscard]] bool is_caught(const TheCase& the_case, const StateOf<TheCase>& state,
                             const TouchingOf<TheCase>& touching) {
  constexpr double of_rounding = 100.0;  // [-], left by a long row of impacts within an instant
  return speed_scale(the_case, state) <= of_rounding * touching.rounding_of_all(the_case);
}

/// The ending where the `taut` cables, of which `held` pulls, keep the body from moving, now and so
/// for ever. A turn about the centre that it hangs at is no motion.
template <class TheCase>
[[nodiscard]] std::optional<Ending> rest(const TheCase& the_case, const StateOf<TheCase>& state,
                                         const TouchingOf<TheCase>& touching, CableSet taut,
                                         const std::optional<BasicHold<TheCase>>& held) {
  if (taut.empty() || centre_speed(state) > touching.rounding_of_all(the_case)) {
    return std::nullopt;
  }
  const bool still = speed_scale(the_case, state) <= touching.rounding_of_all(the_case) ||
                     turns_freely(the_case, state, taut);
  return still ? equilibrium(the_case, state, *held) : std::nullopt;
}

/// `state` with what rounding has left of the gaps and rates of taut cables taken away, and of the
/// gaps of those just hit once it is more than a few arcs leave. `are_smooth`: else rates that are
/// not zero are no rounding.
template <class TheCase>
[[nodiscard]] StateOf<TheCase> on_cables(const TheCase& the_case, StateOf<TheCase> state,
                                         CableSet held, CableSet hit, bool are_smooth) {
  bool drifted = !held.empty();
  for (const std::size_t index : hit) {
    const CableOf<TheCase>& cable = the_case.cables[index];
    drifted = drifted || abs(gap(cable, state)) > few_roundings * rounding_of_gap(cable, state);
  }
  if (drifted) {
    constexpr double almost_dependent = 1e-2;  // [-], a sine: a hundredfold of the gaps is enough
    state = with_zero_gaps(the_case, state, held | hit, hit.empty() ? 0.0 : almost_dependent);
  }
  return held.empty() || !are_smooth ? state : with_zero_rates(the_case, state, held);
}

/// True where no time step from `time` on is small enough: tensions grow without bound.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] bool is_singular(const BasicHold<TheCase>& held, const Real& time) {
  return !(time + held.reach > time);
}

}  // namespace tautline
