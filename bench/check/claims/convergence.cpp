#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

/// A first-order method has a slope of 1. Where an impact falls in its step scatters it by 0.1, and
/// a spring contact brings it down to 0.8.
constexpr double slope_limit = 0.3;  // below 1

/// What rounding alone leaves of impacts that are located [m]: in double a few thousand roundings,
/// in float up to 7e-6 m. A step of 1e-3 s without location leaves 1e-4 m and more.
constexpr double exact_limit = 1e-11;
constexpr double exact_limit_in_float = 2e-5;

/// The slope of log(deviation) over log(step): the order of a method.
double order(const std::vector<double>& steps, const std::vector<double>& deviations) {
  const auto count = static_cast<double>(steps.size());
  double mean_x = 0.0;
  double mean_y = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    mean_x += std::log(steps[k]) / count;
    mean_y += std::log(deviations[k]) / count;
  }
  double across = 0.0;
  double square = 0.0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    across += (std::log(steps[k]) - mean_x) * (std::log(deviations[k]) - mean_y);
    square += (std::log(steps[k]) - mean_x) * (std::log(steps[k]) - mean_x);
  }
  return across / square;
}

/// The largest distance from the exact motion over a run of two seconds [m].
double deviation(const Subject& subject, const Case& the_case, const Solution& exact, double step) {
  const auto simulation = subject.start(the_case, step);
  double largest = 0.0;
  run_whole(*simulation, step, 2.0, [&](const Moment& moment) {
    largest = worse(largest, (moment.after.position - exact.at(moment.time).position).norm());
  });
  return largest;
}

}  // namespace

Convergence convergence(const Subject& subject) {
  const Case the_case = standard_breakwater(0.9);
  const Solution exact = solve(the_case);
  Convergence result;
  // below 1e-3 the rounding of positions in float is as large as the error of the step
  result.steps = subject.in_double() ? std::vector<double>{1e-2, 1e-3, 1e-4}
                                     : std::vector<double>{1e-2, 3e-3, 1e-3};
  for (const double step : result.steps) {
    result.deviations.push_back(deviation(subject, the_case, exact, step));
  }
  const double largest =
      std::accumulate(result.deviations.begin(), result.deviations.end(), 0.0, worse);
  result.exact = largest <= (subject.in_double() ? exact_limit : exact_limit_in_float);
  result.slope = order(result.steps, result.deviations);
  return result;
}

Measure measure_convergence(const Subject& subject) {
  const Convergence run = convergence(subject);
  if (run.exact) {
    return {0.0, slope_limit,
            fmt::format("exact at every step, to {:.2g} m",
                        *std::max_element(run.deviations.begin(), run.deviations.end()))};
  }
  const double found = std::max(0.0, 1.0 - run.slope);
  const std::string numbers = fmt::format(
      "off by {:.2g} m at a step of {:g} s and by {:.2g} m at {:g} s, a slope of {:.2f}",
      run.deviations.front(), run.steps.front(), run.deviations.back(), run.steps.back(),
      run.slope);
  return {
      std::isnan(run.slope) ? run.slope : found, slope_limit,
      found <= slope_limit ? numbers : "smaller steps do not bring it to the motion: " + numbers};
}

}  // namespace tautline::bench
