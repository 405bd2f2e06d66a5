#pragma once

#include <optional>

#include "tautline/detail/first_contact.hpp"
#include "tautline/detail/hold.hpp"

namespace tautline {

/// Where a motion is now.
template <class TheCase>
struct Present {
  using Real = RealOf<TheCase>;

  const TheCase& the_case;
  const StateOf<TheCase>& state;
  const TouchingOf<TheCase>& touching;
  CableSet taut;                                  // as far as recorded
  const std::optional<BasicHold<TheCase>>& held;  // the motion on taut cables; none: free flight
  Real remaining;                                 // [s], to the duration of the case

  /// True where the body flies, and touches one cable at most.
  [[nodiscard]] bool is_free() const {
    return !held && taut.empty() && touching.cables.size() <= 1;
  }
};

}  // namespace tautline
