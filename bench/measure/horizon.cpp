#include "bench/measure/horizon.hpp"

#include "tautline/sensitivity.hpp"

namespace tautline::bench {

double predictability_horizon(const Case& the_case, const Solution& solution, ImpactLaw law,
                              double local_error, double visible) {
  return Sensitivity(the_case, solution, law)
      .horizon(visible, local_error)
      .value_or(solution.end_time());
}

}  // namespace tautline::bench
