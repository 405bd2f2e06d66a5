#include <numbers>

#include "tautline/detail/hold.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/settling.hpp"

namespace tautline {
namespace {

/// The pose with `taut` at zero gap and the angle given, from a nearby one; none where the two
/// circles of the attachments do not meet.
std::optional<State> at_angle(const Case& the_case, State state, CableSet taut, double angle) {
  state.angle = angle;
  constexpr int enough = 30;
  constexpr double rounding = 4e-16;  // [-] of a cable's length
  for (int iteration = 0; iteration < enough; ++iteration) {
    Eigen::Matrix2d slope;
    Vec2 gaps;
    double worst = 0.0;
    Eigen::Index row = 0;
    for (const std::size_t index : taut) {
      const Cable& cable = the_case.cables[index];
      slope.row(row) = gap_gradient(cable, state).head<2>().transpose();
      gaps[row] = gap(cable, state);
      worst = std::max(worst, std::abs(gaps[row++]) / cable.length);
    }
    if (worst <= rounding) {
      return state;
    }
    state.position -= slope.inverse() * gaps;
    if (!state.position.allFinite()) {
      return std::nullopt;
    }
  }
  constexpr double acceptable =
      1e-14;  // [-], where rounding keeps Newton's method from its last bit
  for (const std::size_t index : taut) {
    const Cable& cable = the_case.cables[index];
    if (std::abs(gap(cable, state)) > acceptable * cable.length) {
      return std::nullopt;
    }
  }
  return state;
}

/// The pose at `angle`, followed from `equilibrium` in small turns.
std::optional<State> linkage(const Case& the_case, const State& equilibrium, CableSet taut,
                             double angle) {
  constexpr int turns = 64;
  std::optional<State> pose = equilibrium;
  for (int turn = 1; turn <= turns && pose; ++turn) {
    pose = at_angle(the_case, *pose, taut,
                    equilibrium.angle + (angle - equilibrium.angle) * turn / turns);
  }
  return pose;
}

}  // namespace

std::optional<CriticalSwing> critical_swing(const Case& the_case, const State& equilibrium) {
  CableSet taut;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    if (std::abs(gap(the_case.cables[index], equilibrium)) <=
        gap_rounding * the_case.cables[index].length) {
      taut.insert(index);
    }
  }
  if (taut.size() != 2 || is_point_mass(the_case)) {
    return std::nullopt;
  }
  const auto keeps_taut = [&](double angle) {
    const auto pose = linkage(the_case, equilibrium, taut, angle);
    return pose && swing(the_case, *pose).has_value();
  };
  constexpr double first = 1e-3;  // [rad]
  double low = equilibrium.angle + first;
  double high = equilibrium.angle + std::numbers::pi;
  if (!keeps_taut(low)) {
    return std::nullopt;
  }
  constexpr int steps = 64;  // of the search for a release that loses a cable
  double lost = low;
  for (int step = 1; step <= steps; ++step) {
    lost = low + (high - low) / (steps + 1 - step);
    if (!keeps_taut(lost)) {
      break;
    }
    low = lost;
    if (step == steps) {
      return std::nullopt;
    }
  }
  high = lost;
  while (high - low > 4.0 * epsilon<double>() * high) {
    const double middle = low + 0.5 * (high - low);
    if (middle == low || middle == high) {
      break;
    }
    (keeps_taut(middle) ? low : high) = middle;
  }
  const auto pose = linkage(the_case, equilibrium, taut, low);
  return CriticalSwing{low, energy(the_case, *pose) - energy(the_case, equilibrium)};
}

}  // namespace tautline
