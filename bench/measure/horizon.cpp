#include "bench/measure/horizon.hpp"

#include "tautline/sensitivity.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

double predictability_horizon(const Case& the_case, const Solution& solution, ImpactLaw law,
                              double local_error, double visible) {
  return Sensitivity(the_case, solution, law)
      .horizon(visible, local_error)
      .value_or(solution.end_time());
}

double sure_until(const Case& the_case, const Solution& solution, ImpactLaw law, double visible) {
  constexpr double part = 0.1;  // [-], of what is judged by it
  const Uncertainty uncertainty(the_case, solution, {.law = law});
  for (const Arc& arc : solution.arcs()) {
    const auto errors = uncertainty.at(arc.end);
    if (!errors || errors->position.norm() > part * visible) {
      return arc.start;
    }
  }
  return solution.end_time();
}

}  // namespace tautline::bench
