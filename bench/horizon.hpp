#pragma once

#include "tautline/case.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// The predictability horizon [s]: the first instant at which an exact run that started `apart`
/// away has moved `visible` away from `solution` of the same case, in position [m]. Beyond it,
/// differences say nothing about an engine. If none moves that far, the instant at which the first
/// of them ends. The runs are started `apart` to either side in each of the six initial values, in
/// units of the case, as far as those starts are admissible.
[[nodiscard]] double predictability_horizon(const Case& the_case, const Solution& solution,
                                            double apart = 1e-12, double visible = 1e-3);

}  // namespace tautline::bench
