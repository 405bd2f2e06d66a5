#pragma once

#include <array>
#include <optional>
#include <vector>

#include "peer.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"

namespace tautline::peers {

/// What the general integrators share: a state as six numbers, its rate, and what an impact does.
using Numbers = std::array<double, 6>;  // x, y [m], angle [rad] and their rates

[[nodiscard]] inline State state_of(const Numbers& n) {
  State result;
  result.position = Vec2(n[0], n[1]);
  result.angle = n[2];
  result.velocity = Vec2(n[3], n[4]);
  result.spin = n[5];
  return result;
}

[[nodiscard]] inline Numbers numbers_of(const State& s) {
  return {s.position.x(), s.position.y(), s.angle, s.velocity.x(), s.velocity.y(), s.spin};
}

/// Of a cable, where only the pose matters.
[[nodiscard]] inline double gap_at(const Cable& cable, const double* numbers) {
  State pose;
  pose.position = Vec2(numbers[0], numbers[1]);
  pose.angle = numbers[2];
  return gap(cable, pose);
}

/// A cable whose gap is this small when another is struck is struck with it [-], of its length: a
/// hundred times what a located instant may be off.
[[nodiscard]] inline double touch(const Effort& effort) { return 100.0 * effort.tolerance; }

/// A peer's root of a gap.
struct Root {
  double time;      // [s] from the start of the run
  State state;      // there
  CableSet cables;  // whose gaps have it
};

/// `found` with the cables that close at the same instant.
[[nodiscard]] inline CableSet struck_with(const Case& the_case, const Root& found,
                                          const Effort& effort) {
  CableSet result = found.cables;
  for (std::size_t index = 0; index < the_case.cables.size(); ++index) {
    const Cable& cable = the_case.cables[index];
    if (gap(cable, found.state) <= touch(effort) * cable.length &&
        gap_rate(cable, found.state) < 0.0) {
      result.insert(index);
    }
  }
  return result;
}

/// Flies from root to root. `next(state, time)` finds the first root after `time`, as an
/// std::optional<Root>.
template <class Next>
[[nodiscard]] std::vector<Located> follow(const Case& the_case, const Stop& stop,
                                          const Effort& effort, const Next& next) {
  std::vector<Located> result;
  State state = the_case.initial;
  double time = 0.0;
  while (result.size() < stop.most) {
    const std::optional<Root> found = next(state, time);
    if (!found) {
      break;
    }
    const CableSet cables = struck_with(the_case, *found, effort);
    result.push_back({found->time, cables});
    time = found->time;
    state = resolve_impact(ImpactLaw::simultaneous, the_case, found->state, cables).after;
  }
  return result;
}

}  // namespace tautline::peers
