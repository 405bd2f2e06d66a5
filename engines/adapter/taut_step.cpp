#include "taut_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "system/kernel.hpp"
#include "tautline/geometry.hpp"
#include "tautline/system_geometry.hpp"

namespace tautline {
namespace {

/// Passes of the search for the impulses; each takes away all of a gap but a part that shrinks with
/// the step. A step that needs more is too long and is halved.
constexpr int most_passes = 20;

/// A step is halved at most this often.
constexpr int most_halvings = 10;

/// The gaps and rates that the cables of a move are asked for.
struct Wanted {
  CableVector gaps;   // [m], after the move
  CableVector rates;  // [m/s], before it: the first guess
  double farthest;    // [m/s], of a rate from its first guess
};

/// A move asks for gaps of zero. A short move has no time for that: what rounding has left of a
/// gap, divided by a tiny step, is a violent speed. So a gap shrinks at a speed that rounding
/// hardly shows, and no rate goes farther from its guess than that speed and the accelerations
/// explain.
template <class TheCase>
Wanted wanted_of(const TheCase& the_case, const StateOf<TheCase>& start, CableSet held, double dt,
                 double rate_rounding) {
  constexpr double generous = 4.0;  // [-]: what the middle of a long move adds to its start
  const double acceleration = acceleration_scale(the_case, start);
  const double shrinking =
      std::sqrt(rate_rounding * acceleration * shortest_length(the_case, start));  // [m/s]
  const auto count = static_cast<Eigen::Index>(held.size());
  Wanted result{CableVector(count), CableVector(count), shrinking + generous * dt * acceleration};
  Eigen::Index row = 0;
  for (const std::size_t index : held) {
    const double opening = gap(the_case.cables[index], start);
    result.gaps[row] = opening - std::clamp(opening, -dt * shrinking, dt * shrinking);
    result.rates[row] = -0.5 * dt * free_gap_acceleration(the_case, index, start);
    ++row;
  }
  return result;
}

/// The largest distance from its wanted gap among the cables of `held` that pull or are
/// overstretched, against `gap_scale` [-]. Lowers their `rates` by what would have closed it.
template <class TheCase>
double correct(const TheCase& the_case, const StateOf<TheCase>& state, CableSet held,
               const CableVector& impulses, double dt, const Wanted& wanted, CableVector& rates) {
  double worst = 0.0;
  Eigen::Index row = 0;
  for (const std::size_t index : held) {
    const auto& cable = the_case.cables[index];
    const double opening = gap(cable, state) - wanted.gaps[row];
    if (impulses[row] > 0.0 || opening < 0.0) {
      worst = std::max(worst, std::abs(opening) / gap_scale(cable, state));
      rates[row] = std::clamp(rates[row] - opening / dt, wanted.rates[row] - wanted.farthest,
                              wanted.rates[row] + wanted.farthest);
    }
    ++row;
  }
  return worst;
}

/// Flies with the impulses before it that leave the gaps of `held` as wanted after it, and returns
/// them. None where they are not found; the body is then anywhere.
template <class TheCase>
std::optional<CableVector> fly_held(const TheCase& the_case, BasicEventAdapter<TheCase>& adapter,
                                    CableSet held, double dt) {
  const StateOf<TheCase> start = adapter.state();
  const auto [allowed, rate_rounding] = adapter.rounding();
  const Wanted wanted = wanted_of(the_case, start, held, dt, rate_rounding);
  CableVector rates = wanted.rates;
  double before = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < most_passes; ++pass) {
    adapter.place(start);
    CableVector impulses = adapter.solve(held, rates);
    adapter.fly(dt);
    const double worst = correct(the_case, adapter.state(), held, impulses, dt, wanted, rates);
    constexpr double near_rounding = 100.0;  // [-], where more passes help no more
    if (worst <= allowed || (worst <= near_rounding * allowed && worst > 0.5 * before)) {
      return impulses;
    }
    before = worst;
  }
  return std::nullopt;
}

/// `taut_step` with `halvings` left.
template <class TheCase>
std::optional<CableVector> step_or_halves(const TheCase& the_case,
                                          BasicEventAdapter<TheCase>& adapter, CableSet held,
                                          double dt, int halvings) {
  const StateOf<TheCase> start = adapter.state();
  if (std::optional<CableVector> impulses = fly_held(the_case, adapter, held, dt)) {
    *impulses += adapter.solve(held, CableVector::Zero(static_cast<Eigen::Index>(held.size())));
    return impulses;
  }
  if (halvings == 0) {
    return std::nullopt;
  }
  adapter.place(start);
  std::optional<CableVector> impulses =
      step_or_halves(the_case, adapter, held, 0.5 * dt, halvings - 1);
  const std::optional<CableVector> more =
      impulses ? step_or_halves(the_case, adapter, held, 0.5 * dt, halvings - 1) : std::nullopt;
  if (!more) {
    return std::nullopt;
  }
  *impulses += *more;
  return impulses;
}

}  // namespace

template <class TheCase>
std::optional<CableVector> taut_step(const TheCase& the_case, BasicEventAdapter<TheCase>& adapter,
                                     CableSet held, double dt) {
  return step_or_halves(the_case, adapter, held, dt, most_halvings);
}

template std::optional<CableVector> taut_step(const Case&, EventAdapter&, CableSet, double);
template std::optional<CableVector> taut_step(const SpatialSystem&, SystemEventAdapter&, CableSet,
                                              double);

}  // namespace tautline
