#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "tautline/settling.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// The largest of what a cable does in a run, where it is first.
template <class Real>
struct BasicPeak {
  Real value;  // [N] or [N s]
  Real time;   // [s]
};
using Peak = BasicPeak<double>;

/// The share of one cable in a run.
template <class Real>
struct BasicCableUse {
  Real taut_share = Real(0);                              // [-], of the run; or engaged
  std::optional<BasicPeak<Real>> tension = std::nullopt;  // [N], the largest; none: always slack
  /// [N s], the largest: its snap, or, of an elastic cable, a contact that ends.
  std::optional<BasicPeak<Real>> impulse = std::nullopt;
};
using CableUse = BasicCableUse<double>;

/// The cables that are taut at the end, where nothing given varies any more.
template <class Real>
struct BasicSystemLock {
  Real time;         // [s], from which on they are taut; the limit of the last accumulation
  Real uncertainty;  // [s], of `time`
  CableSet cables;   // that stay taut, or engaged
  /// No tension falls to zero ever after: the bodies rest, or their energy is too low for that
  /// (E11). Else it is observed.
  bool certain;
  bool at_rest;  // the bodies rest
  /// [J], kinetic and above the equilibrium on these cables, at the end of the run; none where that
  /// equilibrium is on others, or there is none.
  std::optional<Real> residual_energy;
  /// [s], when drag and dampers have taken 99 % of what that energy is at `time`; none: they have
  /// not yet, or there are none.
  std::optional<Real> one_percent;
  /// [s], in which the stretch of a damped elastic cable rings down to 1/e of what it is beyond its
  /// mean, the longest of these cables; none: there is none.
  std::optional<Real> ring_down = std::nullopt;
};
using SystemLock = BasicSystemLock<double>;

/// A motion under waves of one common period.
template <class Real>
struct BasicForcedMotion {
  Real period;   // [s], common to all waves
  Real impacts;  // [-], in a period: the mean of the last ones
  /// It repeats after N periods: its end does so three times, to 1e-9 of its scales.
  std::optional<std::size_t> repeats;
};
using ForcedMotion = BasicForcedMotion<double>;

/// The settling of a system (analytic/README.md section 11).
template <class Real>
struct BasicSystemSettling {
  std::vector<BasicLastImpact<Real>> last_impacts;  // for 1e-2 and 1e-3 [m/s]
  std::vector<BasicCableUse<Real>> cables;          // one for each of the system
  std::optional<BasicSystemLock<Real>> lock;        // none: no cable is taut, or something varies
  std::optional<BasicForcedMotion<Real>> forced;    // none: nothing varies, or without a period
};
using SystemSettling = BasicSystemSettling<double>;

/// The settling of `solution`, which solves `system`.
template <class Real, int D>
[[nodiscard]] BasicSystemSettling<Real> settling(
    const BasicSystem<Real, D>& system, const BasicSolution<BasicSystem<Real, D>>& solution);

/// The shortest time after which all waves of `system` come again [s]; none where it has none, or
/// more than 64 periods of the slowest do not suffice.
template <class Real, int D>
[[nodiscard]] std::optional<Real> common_period(const BasicSystem<Real, D>& system);

}  // namespace tautline
