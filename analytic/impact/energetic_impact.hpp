#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// The impulses of springs, and what they cost.
template <class Real>
struct SpringImpulses {
  BasicCableVector<Real> impulses;  // [N s], one per cable
  int steps = 0;                    // from one change of a spring to the next, or a radian [-]
};

/// The impulses [N s] of Stronge's law, one per cable of `cables`, each at zero gap and closing or
/// resting (analytic/README.md section 4). Every cable is a linear spring, equally stiff:
///
///   force   largest -      /|     loading: force = compression
///                         / |     returning: e^2 as steep as the loading line is flat, so that
///                        /  /     e^2 of the work comes back; back along it up to the largest
///           0 ----------/--/---   compression so far, and on along the loading line
///
/// The motion is linear between the instants at which a cable turns back, parts or comes back; it
/// is a Taylor series there, and the next such instant its first root. It ends when no cable pulls
/// or closes. NaN where numbers overflow.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] SpringImpulses<Real> energetic_impulses(const TheCase& the_case,
                                                      const StateOf<TheCase>& before,
                                                      CableSet cables);

}  // namespace tautline
