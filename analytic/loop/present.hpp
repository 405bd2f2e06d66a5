#pragma once

#include <optional>

#include "tautline/first_contact.hpp"
#include "tautline/hold.hpp"

namespace tautline {

/// Where a motion is now.
template <class Real>
struct Present {
  const BasicCase<Real>& the_case;
  const BasicState<Real>& state;
  const BasicTouching<Real>& touching;
  CableSet taut;                               // as far as recorded
  const std::optional<BasicHold<Real>>& held;  // the motion on taut cables; none: free flight
  Real remaining;                              // [s], to the duration of the case

  /// True where the body flies, and touches one cable at most.
  [[nodiscard]] bool is_free() const {
    return !held && taut.empty() && touching.cables.size() <= 1;
  }
};

}  // namespace tautline
