#pragma once

#include "tautline/case.hpp"

namespace tautline {

/// How the impulse of an impact is shared out where its cables could do so in more than one way.
template <class Real>
struct Split {
  CableSet cables;  // among which it is not determined; empty: there is one way
  BasicCableVector<Real>
      least;  // [N s], the split of smallest size, one per cable; empty: the same
};

/// Of an impact of `cables` that takes `before` to `after` with these `impulses` and keeps to
/// Newton's law (Eq. 14): what they do to the body is unique, and every split that does the same
/// and pulls at no cable that opens faster than its restitution says is as right. `of_corner`: the
/// cables that pull are independent, so that all of them pulling is the one way, found fast.
template <class TheCase, class Real = RealOf<TheCase>>
[[nodiscard]] Split<Real> split(const TheCase& the_case, const StateOf<TheCase>& before,
                                const StateOf<TheCase>& after, CableSet cables,
                                const BasicCableVector<Real>& impulses, bool of_corner);

}  // namespace tautline
