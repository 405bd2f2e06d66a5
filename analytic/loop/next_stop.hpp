#pragma once

#include <optional>

#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/hold.hpp"
#include "tautline/detail/limits.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The instant that ends an arc, and what happens there.
template <class Real>
struct Stop {
  Real dt;                       // [s] from the start of the arc; NaN: numbers overflowed
  std::optional<Ending> ending;  // none: the motion goes on
  CableSet cables;               // that become taut
  bool is_step = false;          // where a series ends, and nothing happens
  bool is_knot = false;          // where something given over time is not smooth
};

/// The earliest of: a contact, a release, the reach of a series, a knot, a limit of the case's
/// validity, the end of the duration, which is `left` [s] away. `held`: the motion on taut cables;
/// none: flight.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] Stop<Real> next_stop(const TheCase& the_case, const StateOf<TheCase>& state,
                                   const TouchingOf<TheCase>& touching,
                                   const std::optional<BasicHold<TheCase>>& held,
                                   const Real& left) {
  Stop<Real> stop{left, Ending::reached_duration, {}};
  if (held) {
    const auto change = first_change(the_case, *held, stop.dt);
    if (!(change.dt >= stop.dt) || !change.cables.empty()) {
      stop = {change.dt, std::nullopt, change.cables,
              change.cables.empty() && change.dt == held->reach};
    }
  } else if constexpr (TheCase::flies_in_closed_form) {
    if (const auto search = first_contact(the_case, state, touching, stop.dt); search.contact) {
      stop = {search.contact->dt, std::nullopt, search.contact->cables};
    }
  }
  if (isnan(stop.dt)) {
    return stop;
  }
  if (const Real knot = time_to_knot(the_case, state); knot < stop.dt) {
    stop = {knot, std::nullopt, {}, false, true};  // what holds is found out again there
  }
  const auto limit = held ? reached_limit(the_case, held->motion, stop.dt)
                          : reached_limit(the_case, state, stop.dt);
  if (limit) {
    stop = {limit->dt, limit->ending, {}};
  }
  return stop;
}

}  // namespace tautline
