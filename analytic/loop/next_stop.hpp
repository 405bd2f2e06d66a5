#pragma once

#include <optional>

#include "tautline/first_contact.hpp"
#include "tautline/hold.hpp"
#include "tautline/limits.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The instant that ends an arc, and what happens there.
template <class Real>
struct Stop {
  Real dt;                       // [s] from the start of the arc; NaN: numbers overflowed
  std::optional<Ending> ending;  // none: the motion goes on
  CableSet cables;               // that become taut
  bool is_step = false;          // where a series ends, and nothing happens
};

/// The earliest of: a contact, a release, the reach of a series, a limit of the case's validity,
/// the end of the duration, which is `left` [s] away. `held`: the motion on taut cables; none:
/// flight.
template <class Real>
[[nodiscard]] Stop<Real> next_stop(const BasicCase<Real>& the_case, const BasicState<Real>& state,
                                   const BasicTouching<Real>& touching,
                                   const std::optional<BasicHold<Real>>& held, const Real& left) {
  Stop<Real> stop{left, Ending::reached_duration, {}};
  if (held) {
    const auto change = first_change(the_case, *held, stop.dt);
    if (!(change.dt >= stop.dt) || !change.cables.empty()) {
      stop = {change.dt, std::nullopt, change.cables,
              change.cables.empty() && change.dt == held->reach};
    }
  } else if (const auto search = first_contact(the_case, state, touching, stop.dt);
             search.contact) {
    stop = {search.contact->dt, std::nullopt, search.contact->cables};
  }
  if (isnan(stop.dt)) {
    return stop;
  }
  if (const auto dt = held ? time_to_angle_limit(the_case, held->motion, stop.dt)
                           : time_to_angle_limit(the_case, state, stop.dt)) {
    stop = {*dt, Ending::angle_limit, {}};
  }
  if (const auto dt = held ? time_to_ceiling(the_case, held->motion, stop.dt)
                           : time_to_ceiling(the_case, state, stop.dt)) {
    stop = {*dt, Ending::ceiling, {}};
  }
  return stop;
}

}  // namespace tautline
