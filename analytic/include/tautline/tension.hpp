#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// The tensions [N] that keep the gaps of `taut` at zero, one per cable in rising index order, all
/// >= 0 (Eq. 16). At `state` their gaps and gap rates are zero, and such tensions exist. Those of a
/// redundant set are not determined by statics: these have the smallest sum of squares.
template <class Real>
[[nodiscard]] BasicCableVector<Real> holding_tensions(const BasicCase<Real>& the_case,
                                                      const BasicState<Real>& state, CableSet taut);

}  // namespace tautline
