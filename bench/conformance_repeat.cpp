// Whether a model does the same again, the same in a mirror, and nearer to the exact motion with
// smaller steps.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/conformance.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {
namespace {

constexpr double usual_step = 1e-3;  // [s]

/// Solvers that go from cable to cable leave 1e-6 by their order in ten sweeps; what rounding
/// grows to is below, in double.
constexpr double mirror_limit = 1e-5;
constexpr double mirror_limit_in_float = 0.1;

/// A first-order method has a slope of 1. Where an impact falls in its step scatters it by 0.1, and
/// a spring contact brings it down to 0.8.
constexpr double slope_limit = 0.3;  // below 1

/// Deviations this many roundings large say nothing of a slope: the model is exact.
constexpr double exact_roundings = 1e4;

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

Measure measure_mirror_symmetry(const Subject& subject) {
  double found = 0.0;
  for (const std::string_view name :
       {"breakwater/19101211150", "tilted-gravity", "plate-four-cables"}) {
    const Case the_case = shipped_case(name);
    const auto original = subject.start(the_case, usual_step);
    const auto image = subject.start(mirrored(the_case), usual_step);
    run(*original, usual_step, 0.5, [&](const Moment& moment) {
      image->step(usual_step);
      if (!image->stopped()) {
        found = std::max(found, largest_difference(moment.after, mirrored(image->state())));
      }
    });
  }
  // a fall onto both cables at once stays on the mirror's line
  Case symmetric = standard_breakwater(0.9);
  symmetric.initial = {Vec2(0.0, 0.3), 0.0, Vec2::Zero(), 0.0};
  const auto simulation = subject.start(symmetric, usual_step);
  run(*simulation, usual_step, 2.0, [&](const Moment& moment) {
    found = worse(found, std::abs(moment.after.position.x()));
    found = worse(found, std::abs(moment.after.spin));
  });
  const double limit = subject.in_double() ? mirror_limit : mirror_limit_in_float;
  return {found, limit,
          found <= limit ? fmt::format("the mirrored case moves in the mirror, to {:.2g}", found)
                         : fmt::format("the mirrored case does not move in the mirror: off by "
                                       "{:.2g}; left and right, or the order of cables, matter",
                                       found)};
}

Measure measure_determinism(const Subject& subject) {
  const Case the_case = shipped_case("plate-four-cables");
  std::vector<State> first;
  const auto one = subject.start(the_case, usual_step);
  run(*one, usual_step, 3.0, [&](const Moment& moment) { first.push_back(moment.after); });
  const auto other = subject.start(the_case, usual_step);
  double found = 0.0;
  double since = -1.0;
  std::size_t index = 0;
  run(*other, usual_step, 3.0, [&](const Moment& moment) {
    const double apart = index < first.size() ? largest_difference(moment.after, first[index])
                                              : std::numeric_limits<double>::infinity();
    ++index;
    if (apart != 0.0 && since < 0.0) {
      since = moment.time;
    }
    found = std::max(found, apart);
  });
  return {found, 0.0,
          found == 0.0 ? "a second run is the same, bit by bit"
                       : fmt::format("not deterministic: a second run of the same case differs, "
                                     "from t = {:.4g} on, by up to {:.2g}",
                                     since, found)};
}

Measure measure_convergence(const Subject& subject) {
  const Case the_case = standard_breakwater(0.9);
  const Solution exact = solve(the_case);
  // below 1e-3 the rounding of positions in float is as large as the error of the step
  const std::vector<double> steps = subject.in_double() ? std::vector<double>{1e-2, 1e-3, 1e-4}
                                                        : std::vector<double>{1e-2, 3e-3, 1e-3};
  std::vector<double> deviations;
  deviations.reserve(steps.size());
  for (const double step : steps) {
    deviations.push_back(deviation(subject, the_case, exact, step));
  }
  if (deviations.front() <= exact_roundings * subject.rounding()) {
    return {0.0, slope_limit,
            fmt::format("exact whatever the step, to {:.2g} m", deviations.front())};
  }
  const double slope = order(steps, deviations);
  const double found = std::max(0.0, 1.0 - slope);
  const std::string numbers = fmt::format(
      "off by {:.2g} m at a step of {:g} s and by {:.2g} m at {:g} s, a slope of {:.2f}",
      deviations.front(), steps.front(), deviations.back(), steps.back(), slope);
  return {
      std::isnan(slope) ? slope : found, slope_limit,
      found <= slope_limit ? numbers : "smaller steps do not bring it to the motion: " + numbers};
}

}  // namespace tautline::bench
