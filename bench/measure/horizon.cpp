#include "bench/measure/horizon.hpp"

#include <cmath>

#include "tautline/detail/sensitivity.hpp"
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
  const auto sure_at = [&](double time) {
    const auto errors = uncertainty.at(time);
    return errors && errors->position.norm() <= part * visible;
  };
  const double last = std::nextafter(uncertainty.horizon().value_or(solution.end_time()), 0.0);
  for (const Arc& arc : solution.arcs_until(solution.end_time())) {
    if (!sure_at(arc.end)) {
      return last > arc.start && last < arc.end && sure_at(last) ? last : arc.start;
    }
  }
  return solution.end_time();
}

}  // namespace tautline::bench
