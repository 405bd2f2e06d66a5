#pragma once

#include <optional>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/detail/swing.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// The last impact faster than a threshold.
template <class Real>
struct BasicLastImpact {
  Real speed;                // [m/s], of closing, the threshold
  std::optional<Real> time;  // [s]; none: no impact is that fast
};
using LastImpact = BasicLastImpact<double>;

/// The last impacts of `solution`, which solves `the_case`, faster than 1e-2 and 1e-3 [m/s].
template <class TheCase>
[[nodiscard]] std::vector<BasicLastImpact<RealOf<TheCase>>> last_impacts(
    const TheCase& the_case, const BasicSolution<TheCase>& solution) {
  using Real = RealOf<TheCase>;
  std::vector<BasicLastImpact<Real>> result = {{Real(1) / 100, std::nullopt},
                                               {Real(1) / 1000, std::nullopt}};
  for (const BasicEvent<TheCase>& event : solution.events()) {
    if (event.kind == EventKind::impact) {
      const Real fastest = closing_speed(the_case, event.cables, event.before);
      for (BasicLastImpact<Real>& last : result) {
        if (fastest > last.speed) {
          last.time = event.time;
        }
      }
    }
  }
  return result;
}

/// The final set of taut cables.
template <class Real>
struct BasicLock {
  Real time;         // [s], from which on they are taut; the limit of the last accumulation
  Real uncertainty;  // [s], of `time`; 0 where no accumulation led here
  CableSet cables;   // that stay taut
  /// True where no tension falls to zero ever after: the body rests, or its swing is known from one
  /// turning point to the other, without a release.
  bool permanent;
  bool rests;                             // nothing is left to swing
  std::optional<BasicSwing<Real>> swing;  // with one degree of freedom left, and no rest
};
using Lock = BasicLock<double>;

/// What settling means (analytic/README.md section 7).
template <class Real>
struct BasicSettling {
  std::vector<BasicLastImpact<Real>> last_impacts;  // for 1e-2 and 1e-3 [m/s]
  std::optional<BasicLock<Real>> lock;              // none: the motion ends with all cables slack
};
using Settling = BasicSettling<double>;

/// Settling of `solution`, which solves `the_case`. Looks past the end of the solution until
/// the swing has turned twice, if the solution does not say what swing it is.
template <class Real>
[[nodiscard]] BasicSettling<Real> settling(const BasicCase<Real>& the_case,
                                           const BasicSolution<BasicCase<Real>>& solution);

/// The lock alone, which asks far less of a solution than all of its settling.
template <class Real>
[[nodiscard]] std::optional<BasicLock<Real>> last_lock(
    const BasicCase<Real>& the_case, const BasicSolution<BasicCase<Real>>& solution);

/// The swing on the cables that are taut at `state`; none if one becomes slack or is hit, or if the
/// motion has not one degree of freedom.
template <class Real>
[[nodiscard]] std::optional<BasicSwing<Real>> swing(const BasicCase<Real>& the_case,
                                                    const BasicState<Real>& state);

/// The largest swing without a release: let go at rest at `angle`, a tension just touches zero.
struct CriticalSwing {
  double angle;   // [rad], of the release; `state` was at the equilibrium
  double energy;  // [J], above the equilibrium
};

/// Of the swing on the two cables that are taut at `equilibrium`, a state of rest, released on the
/// side of positive angles; none if `equilibrium` is none, or no release up to pi loses a cable.
[[nodiscard]] std::optional<CriticalSwing> critical_swing(const Case& the_case,
                                                          const State& equilibrium);

}  // namespace tautline
