#include "bench/measure/horizon.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tautline/detail/sensitivity.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {
namespace {

/// How far a body of one state is from the same body of the other, at most [m].
double apart(const SpatialSystemState& a, const SpatialSystemState& b) {
  double result = 0.0;
  for (std::size_t index = 0; index < a.bodies.size(); ++index) {
    result = std::max(result, (a.bodies[index].position - b.bodies[index].position).norm());
  }
  return result;
}

}  // namespace

double predictability_horizon(const Case& the_case, const Solution& solution, ImpactLaw law,
                              double local_error, double visible) {
  return Sensitivity(the_case, solution, law)
      .horizon(visible, local_error)
      .value_or(solution.end_time());
}

double predictability_horizon(const SpatialSystem& system,
                              const BasicSolution<SpatialSystem>& solution, ImpactLaw law,
                              double local_error, double visible) {
  constexpr std::size_t instants = 2000;
  constexpr double second = 1.0;  // [s]
  double horizon = solution.end_time();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    SpatialSystem near = system;
    double side = 1.0;  // bodies part from each other, too
    for (SpatialState& body : near.initial.bodies) {
      body.velocity[axis] += side * local_error / second;  // a place might overstretch a cable
      side = -side;
    }
    const auto other = solve(near, {.law = law});
    for (std::size_t k = 1; k <= instants; ++k) {
      const double time = horizon * static_cast<double>(k) / static_cast<double>(instants);
      if (time > other.end_time()) {
        break;  // it says nothing
      }
      if (apart(solution.at(time), other.at(time)) > visible) {
        horizon = time;
        break;
      }
    }
  }
  return horizon;
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
