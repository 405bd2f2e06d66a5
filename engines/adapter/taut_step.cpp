#include "taut_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// Passes of the search for the impulses; each takes away all of a gap but a part that shrinks with
/// the step. A step that needs more is too long and is halved.
constexpr int most_passes = 20;

/// A step is halved at most this often.
constexpr int most_halvings = 10;

/// The largest gap among the cables of `held` that pull or are overstretched, against its cable's
/// length [-]. Lowers their `rates` by what would have closed them.
double correct(const Case& the_case, const State& state, CableSet held, const CableVector& impulses,
               double dt, CableVector& rates) {
  double worst = 0.0;
  Eigen::Index row = 0;
  for (const std::size_t index : held) {
    const Cable& cable = the_case.cables[index];
    const double opening = gap(cable, state);
    if (impulses[row] > 0.0 || opening < 0.0) {
      worst = std::max(worst, std::abs(opening) / cable.length);
      rates[row] -= opening / dt;
    }
    ++row;
  }
  return worst;
}

/// Flies with the impulses before it that leave the gaps of `held` at zero after it. False where
/// they are not found; the body is then anywhere.
bool fly_held(const Case& the_case, EventAdapter& adapter, CableSet held, double dt) {
  const State start = adapter.state();
  const double allowed = adapter.rounding().gap;
  CableVector rates(static_cast<Eigen::Index>(held.size()));
  Eigen::Index row = 0;
  for (const std::size_t index : held) {
    rates[row++] = -0.5 * dt * free_gap_acceleration(the_case, index, start);
  }
  double before = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < most_passes; ++pass) {
    adapter.place(start);
    const CableVector impulses = adapter.solve(held, rates);
    adapter.fly(dt);
    const double worst = correct(the_case, adapter.state(), held, impulses, dt, rates);
    constexpr double near_rounding = 100.0;  // [-], where more passes help no more
    if (worst <= allowed || (worst <= near_rounding * allowed && worst > 0.5 * before)) {
      return true;
    }
    before = worst;
  }
  return false;
}

/// `taut_step` with `halvings` left.
bool step_or_halves(const Case& the_case, EventAdapter& adapter, CableSet held, double dt,
                    int halvings) {
  const State start = adapter.state();
  if (fly_held(the_case, adapter, held, dt)) {
    static_cast<void>(
        adapter.solve(held, CableVector::Zero(static_cast<Eigen::Index>(held.size()))));
    return true;
  }
  if (halvings == 0) {
    return false;
  }
  adapter.place(start);
  return step_or_halves(the_case, adapter, held, 0.5 * dt, halvings - 1) &&
         step_or_halves(the_case, adapter, held, 0.5 * dt, halvings - 1);
}

}  // namespace

bool taut_step(const Case& the_case, EventAdapter& adapter, CableSet held, double dt) {
  return step_or_halves(the_case, adapter, held, dt, most_halvings);
}

}  // namespace tautline
