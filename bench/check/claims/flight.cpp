#include "bench/check/claims/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "bench/check/cases.hpp"
#include "bench/check/stepping.hpp"
#include "tautline/geometry.hpp"

namespace tautline::bench {
namespace {

/// An angle that an engine advances by atan(spin dt) lags by (spin dt)^3 / 3 in each step: 5.6e-4
/// rad at the end of the fall below. Two halves of it, or more, lag by less.
constexpr double flight_limit = 1e-3;
constexpr double flight_limit_in_float = 5e-3;  // 500 roundings of numbers up to 15

/// Steps and ends of the two falls [s]; each ends with a step that is shorter than the others.
struct Fall {
  double step;
  double end;
};
constexpr Fall falls[] = {{1e-2, 5.0}, {1e-3, 1.0}};
constexpr double last_part = 0.4;  // [-], of a step

/// How far a fall was from one flight.
struct Apart {
  double whole = 0.0;  // the largest difference, whole steps only
  double part = 0.0;   // over the short last one, from where it began

  [[nodiscard]] double largest() const { return std::max(whole, part); }
};

/// How far a fall was from each of the flights that are asked about.
struct Fallen {
  std::vector<Apart> from;
  double first_move = 0.0;       // [m], in its first step
  double largest_impulse = 0.0;  // [N s]
};

/// The flight that this engine seems to have, and those that any may have.
std::vector<Flight> flights_of(const Subject& subject) {
  return {subject.flight(),
          {Flight::Scheme::parabola},
          {Flight::Scheme::velocity_first},
          {Flight::Scheme::position_first}};
}

Fallen fall(const Subject& subject, const std::vector<Flight>& flights, const Fall& plan) {
  Case the_case = spinning_on_one_cable(50.0);
  the_case.duration = plan.end + last_part * plan.step;
  const auto simulation = subject.start(the_case, plan.step);
  std::vector<State> wanted(flights.size(), the_case.initial);
  Fallen result;
  result.from.resize(flights.size());
  run_whole(*simulation, plan.step, plan.end, [&](const Moment& moment) {
    for (std::size_t k = 0; k < flights.size(); ++k) {
      wanted[k] = slack_step(wanted[k], the_case.gravity, plan.step, flights[k]);
      result.from[k].whole =
          std::max(result.from[k].whole, largest_difference(moment.after, wanted[k]));
    }
    result.largest_impulse = worse(result.largest_impulse, std::abs(simulation->impulses()[0]));
    if (result.first_move == 0.0) {
      result.first_move = (moment.after.position - moment.before.position).norm();
    }
  });
  const State before = simulation->state();
  simulation->step(last_part * plan.step);
  for (std::size_t k = 0; k < flights.size(); ++k) {
    const State after = slack_step(before, the_case.gravity, last_part * plan.step, flights[k]);
    result.from[k].part = largest_difference(simulation->state(), after);
  }
  return result;
}

/// "; turns by 4 atan(spin dt / 4), 0.0013 rad short of 0.4", or nothing where it turns by spin dt.
std::string turning(const Turn& turn) {
  if (turn.arctangents == 0) {
    return "";
  }
  const std::string law = turn.arctangents == 1
                              ? "atan(spin dt)"
                              : fmt::format("{0} atan(spin dt / {0})", turn.arctangents);
  return fmt::format("; turns by {}, {:.2g} rad short of {:g}", law, turn.short_by, probed_turn);
}

/// What is wrong with a fall that is like none of the flights, in words; `nearest` is the one of
/// them, at `index`.
std::string defect(const Fallen& coarse, const Fallen& fine, std::size_t index,
                   const Flight& nearest) {
  if (coarse.largest_impulse > 0.0 || fine.largest_impulse > 0.0) {
    return fmt::format("a slack cable pulls, with an impulse of {:.2g} N s",
                       std::max(coarse.largest_impulse, fine.largest_impulse));
  }
  if (coarse.first_move < 2.0 * fine.first_move) {  // ten times as far, or nearly, is right
    return fmt::format(
        "the step is ignored: one of {:g} s moves the body by {:.3g} m, one of {:g} s by {:.3g} m",
        falls[0].step, coarse.first_move, falls[1].step, fine.first_move);
  }
  const double whole = std::max(coarse.from[index].whole, fine.from[index].whole);
  if (std::max(coarse.from[index].part, fine.from[index].part) > 0.5 * whole) {
    return "a last step that is shorter than the others is not taken as it is given";
  }
  return fmt::format("drifts: a body that no cable pulls is off by {:.2g} after {:g} s, from {}",
                     coarse.from[index].whole, falls[0].end, to_string(nearest));
}

}  // namespace

Measure measure_flight(const Subject& subject) {
  const std::vector<Flight> flights = flights_of(subject);
  const Fallen coarse = fall(subject, flights, falls[0]);
  const Fallen fine = fall(subject, flights, falls[1]);
  const auto apart = [&](std::size_t k) {
    return std::max(coarse.from[k].largest(), fine.from[k].largest());
  };
  const double limit = subject.in_double() ? flight_limit : flight_limit_in_float;
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < flights.size(); ++k) {
    nearest = apart(k) < apart(nearest) ? k : nearest;
  }
  double found = apart(nearest);
  if (coarse.largest_impulse > 0.0 || fine.largest_impulse > 0.0) {
    found = std::numeric_limits<double>::infinity();
  }
  return {found, limit,
          found <= limit ? "flies " + to_string(flights[nearest]) + turning(subject.turn())
                         : defect(coarse, fine, nearest, flights[nearest])};
}

}  // namespace tautline::bench
