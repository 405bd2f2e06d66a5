#include "bench/check/claims/flight.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// An angle that an engine advances by an infinitesimal turn lags by (spin dt)^3 / 12 in each step:
/// 1.4e-4 rad at the end of the fall below.
constexpr double flight_limit = 1e-3;
constexpr double flight_limit_in_float = 5e-3;  // 500 roundings of numbers up to 15

/// Steps and ends of the two falls [s]; each ends with a step that is shorter than the others.
struct Fall {
  double step;
  double end;
};
constexpr Fall falls[] = {{1e-2, 5.0}, {1e-3, 1.0}};
constexpr double last_part = 0.4;  // [-], of a step

/// How far a fall was from each of the flights, and how far the body went in its first step.
struct Fallen {
  double from[std::size(flights)] = {};        // the largest difference, whole steps only
  double short_step[std::size(flights)] = {};  // over the short last one, from where it began
  double first_move = 0.0;                     // [m]
  double largest_impulse = 0.0;                // [N s]
};

Fallen fall(const Subject& subject, const Fall& plan) {
  const Case the_case = spinning_on_one_cable(50.0);
  const auto simulation = subject.start(the_case, plan.step);
  std::vector<State> wanted(std::size(flights), the_case.initial);
  Fallen result;
  run_whole(*simulation, plan.step, plan.end, [&](const Moment& moment) {
    for (std::size_t k = 0; k < std::size(flights); ++k) {
      wanted[k] = slack_step(wanted[k], the_case.gravity, plan.step, flights[k]);
      result.from[k] = std::max(result.from[k], largest_difference(moment.after, wanted[k]));
    }
    result.largest_impulse = worse(result.largest_impulse, std::abs(simulation->impulses()[0]));
    if (result.first_move == 0.0) {
      result.first_move = (moment.after.position - moment.before.position).norm();
    }
  });
  const State before = simulation->state();
  simulation->step(last_part * plan.step);
  for (std::size_t k = 0; k < std::size(flights); ++k) {
    const State after = slack_step(before, the_case.gravity, last_part * plan.step, flights[k]);
    result.short_step[k] = largest_difference(simulation->state(), after);
  }
  return result;
}

/// What is wrong with a fall that is like none of the flights, in words.
std::string defect(const Fallen& coarse, const Fallen& fine, std::size_t nearest) {
  if (coarse.largest_impulse > 0.0 || fine.largest_impulse > 0.0) {
    return fmt::format("a slack cable pulls, with an impulse of {:.2g} N s",
                       std::max(coarse.largest_impulse, fine.largest_impulse));
  }
  if (!std::isfinite(coarse.from[nearest] + fine.from[nearest])) {
    return "the state is not a number, or beyond all numbers, before the fall ends";
  }
  if (coarse.first_move < 2.0 * fine.first_move) {  // ten times as far, or nearly, is right
    return fmt::format(
        "the step is ignored: one of {:g} s moves the body by {:.3g} m, one of {:g} s by {:.3g} m",
        falls[0].step, coarse.first_move, falls[1].step, fine.first_move);
  }
  const double whole = std::max(coarse.from[nearest], fine.from[nearest]);
  if (std::max(coarse.short_step[nearest], fine.short_step[nearest]) > 0.5 * whole) {
    return "a last step that is shorter than the others is not taken as it is given";
  }
  return fmt::format("drifts: a body that no cable pulls is off by {:.2g} after {:g} s, from {}",
                     coarse.from[nearest], falls[0].end, to_string(flights[nearest]));
}

}  // namespace

Measure measure_flight(const Subject& subject) {
  const Fallen coarse = fall(subject, falls[0]);
  const Fallen fine = fall(subject, falls[1]);
  const auto apart = [&](std::size_t k) {
    return std::max({coarse.from[k], fine.from[k], coarse.short_step[k], fine.short_step[k]});
  };
  const double limit = subject.in_double() ? flight_limit : flight_limit_in_float;
  // where it is near none of them, the one that its first step looks like
  auto nearest = static_cast<std::size_t>(subject.flight());
  for (std::size_t k = 0; k < std::size(flights); ++k) {
    nearest = apart(k) <= limit ? k : nearest;
  }
  double found = apart(nearest);
  if (coarse.largest_impulse > 0.0 || fine.largest_impulse > 0.0) {
    found = std::numeric_limits<double>::infinity();
  }
  return {found, limit,
          found <= limit ? fmt::format("flies {}", to_string(flights[nearest]))
                         : defect(coarse, fine, nearest)};
}

}  // namespace tautline::bench
