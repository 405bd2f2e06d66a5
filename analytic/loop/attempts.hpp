#pragma once

#include <vector>

#include "slow_bounces.hpp"
#include "tautline/detail/accumulation.hpp"
#include "tautline/detail/rounding.hpp"
#include "tautline/geometry.hpp"

namespace tautline {

/// When the bounces on a cable are tried as the end of an accumulation, and when again: `tried` of
/// each cable is what `NextAttempt` says of it.
template <class TheCase>
class Attempts {
 public:
  using Real = RealOf<TheCase>;

  Attempts(std::size_t cables, const CompletionLimits& limits)
      : limits_(limits), tried_(cables, infinity<Real>()) {}

  /// True where the bounces on the touching `cables` are to be tried now, or one does not open.
  [[nodiscard]] bool are_due(const TheCase& the_case, const StateOf<TheCase>& state,
                             const TouchingOf<TheCase>& touching, CableSet cables) {
    const Scales<Real> scale = scales_of(the_case, state, limits_.margin);
    for (const std::size_t index : cables) {
      const CableOf<TheCase>& cable = the_case.cables[index];
      const Real rebound = gap_rate(cable, state);
      const auto next =
          next_attempt(restitution_up_to(cable, rebound), rounding_of_gap(cable, state),
                       touching.rounding(cable), rebound, tried_[index], limits_, scale);
      tried_[index] = next.tried;
      if (next.is_due) {
        return true;
      }
    }
    return false;
  }

  /// The bounces on `cables` have been tried, in vain.
  void note(const TheCase& the_case, const StateOf<TheCase>& state, CableSet cables) {
    for (const std::size_t index : cables) {
      tried_[index] = gap_rate(the_case.cables[index], state);
    }
  }

  [[nodiscard]] const Real& tried(std::size_t index) const { return tried_[index]; }  // [m/s]
  void set_tried(std::size_t index, const Real& tried) { tried_[index] = tried; }

 private:
  const CompletionLimits& limits_;
  std::vector<Real> tried_;
};

}  // namespace tautline
