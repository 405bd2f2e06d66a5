#pragma once

#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline {

/// The energy of a motion over time [J]. No potential energy: what gravity gives is work.
/// end = start + work - impacts - completions - stored - dissipated + residual.
template <class Real>
struct BasicSystemLedger {
  Real start;        // kinetic energy of the initial state
  Real work;         // of gravity, forces, moments and drag, and of what moves ends and lengths
                     // or hooks up a stretched cable
  Real impacts;      // lost in impacts followed one by one
  Real completions;  // lost in the impacts that completing an accumulation replaces
  Real end;          // kinetic energy of the last state
  Real residual;     // of rounding
  Real range;        // the largest kinetic or stored energy, or sum of works, on the way
  Real stored = Real(0);      // in elastic cables at the end, less than at the start if negative
  Real dissipated = Real(0);  // lost in elastic cables: in dampers, while loose, and where cut
};
using SystemLedger = BasicSystemLedger<double>;

/// The ledger of `solution`, which solves `system` (T9).
template <class Real, int D>
[[nodiscard]] BasicSystemLedger<Real> energy_ledger(
    const BasicSystem<Real, D>& system, const BasicSolution<BasicSystem<Real, D>>& solution);

}  // namespace tautline
