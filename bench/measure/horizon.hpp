#pragma once

#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/solution.hpp"
#include "tautline/system.hpp"

namespace tautline::bench {

/// The predictability horizon [s]: the first instant at which a run that started `local_error` away
/// from the exact one can be `visible` away, to first order, in the metric of
/// analytic/README.md, Eq. 45 [m]. Beyond it, differences say nothing about an engine. The end of
/// `solution`, which solves `the_case` under `law`, if the error does not grow that much.
[[nodiscard]] double predictability_horizon(const Case& the_case, const Solution& solution,
                                            ImpactLaw law = ImpactLaw::simultaneous,
                                            double local_error = 1e-12, double visible = 1e-3);

/// In a system it is the first of some instants, evenly spread, at which a body of a motion that
/// starts `local_error` [m/s] faster is `visible` [m] away. Three such starts are followed.
[[nodiscard]] double predictability_horizon(const SpatialSystem& system,
                                            const BasicSolution<SpatialSystem>& solution,
                                            ImpactLaw law = ImpactLaw::simultaneous,
                                            double local_error = 1e-12, double visible = 1e-3);

/// The first instant [s] at which the exact position itself is not sure to a tenth of `visible`, so
/// that no run is judged by it: errors of doubles grow along the motion as those of a run do. The
/// end of `solution` if it is sure throughout.
[[nodiscard]] double sure_until(const Case& the_case, const Solution& solution,
                                ImpactLaw law = ImpactLaw::simultaneous, double visible = 1e-3);

}  // namespace tautline::bench
