#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// The tensions [N] that keep the gaps of `taut` at zero, one per cable in rising index order, all
/// >= 0 (Eq. 16). At `state` their gaps and gap rates are zero, and such tensions exist. Those of a
/// redundant set are not determined by statics: these have the smallest sum of squares.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] BasicCableVector<Real> holding_tensions(const TheCase& the_case,
                                                      const StateOf<TheCase>& state, CableSet taut);

}  // namespace tautline
