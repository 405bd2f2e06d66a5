#include "taut_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/system_geometry.hpp"

namespace tautline {
namespace {

/// Passes of the search for the impulses; each takes away all of a gap but a part that shrinks with
/// the step. A step that needs more is too long and is halved.
constexpr int most_passes = 20;

/// A step is halved at most this often.
constexpr int most_halvings = 10;

/// The largest gap among the cables of `held` that pull or are overstretched, against `gap_scale`
/// [-]. Lowers their `rates` by what would have closed them.
template <class TheCase>
double correct(const TheCase& the_case, const StateOf<TheCase>& state, CableSet held,
               const CableVector& impulses, double dt, CableVector& rates) {
  double worst = 0.0;
  Eigen::Index row = 0;
  for (const std::size_t index : held) {
    const auto& cable = the_case.cables[index];
    const double opening = gap(cable, state);
    if (impulses[row] > 0.0 || opening < 0.0) {
      worst = std::max(worst, std::abs(opening) / gap_scale(cable, state));
      rates[row] -= opening / dt;
    }
    ++row;
  }
  return worst;
}

/// Flies with the impulses before it that leave the gaps of `held` at zero after it, and returns
/// them. None where they are not found; the body is then anywhere.
template <class TheCase>
std::optional<CableVector> fly_held(const TheCase& the_case, BasicEventAdapter<TheCase>& adapter,
                                    CableSet held, double dt) {
  const StateOf<TheCase> start = adapter.state();
  const double allowed = adapter.rounding().gap;
  CableVector rates(static_cast<Eigen::Index>(held.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : held) {
    rates[row++] = -0.5 * dt * free_gap_acceleration(the_case, index, start);
  }
  double before = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < most_passes; ++pass) {
    adapter.place(start);
    CableVector impulses = adapter.solve(held, rates);
    adapter.fly(dt);
    const double worst = correct(the_case, adapter.state(), held, impulses, dt, rates);
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
