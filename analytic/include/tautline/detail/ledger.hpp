#pragma once

#include "tautline/case.hpp"
#include "tautline/geometry.hpp"
#include "tautline/solution.hpp"

namespace tautline {

/// Where the energy of a motion has gone [J]. start = end + impacts + completions + residual.
template <class Real>
struct BasicEnergyLedger {
  Real start;        // of the initial state
  Real impacts;      // lost in impacts followed one by one
  Real completions;  // lost in the impacts that completing an accumulation stands for
  Real end;          // of the last state
  Real residual;     // what rounding has made of flight and taut motion, which keep energy
};
using EnergyLedger = BasicEnergyLedger<double>;

/// The ledger of `solution`, which solves `the_case`.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicEnergyLedger<Real> energy_ledger(const TheCase& the_case,
                                                    const BasicSolution<TheCase>& solution) {
  BasicEnergyLedger<Real> ledger{energy(the_case, the_case.initial), Real(0), Real(0),
                                 energy(the_case, solution.at(solution.end_time())), Real(0)};
  for (const BasicEvent<TheCase>& event : solution.events()) {
    const Real lost = energy(the_case, event.before) - energy(the_case, event.after);
    (event.kind == EventKind::impact ? ledger.impacts : ledger.completions) += lost;
  }
  ledger.residual = ledger.start - ledger.impacts - ledger.completions - ledger.end;
  return ledger;
}

}  // namespace tautline
