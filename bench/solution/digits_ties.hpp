#pragma once

#include <optional>

#include "tautline/multiprecision.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

/// Where a tension touches zero, or taut cables pass a dead point, as far as the digits of a
/// solution tell.
struct NumberTie {
  Tie tie;
  Multi time;  // [s], from which on more than one motion may go on
};

/// The first of `solution`, which was computed with numbers of `digits`; none if there is none. A
/// quarter of the digits is left to what the motion makes of their rounding; beside a dead point,
/// where a cable is let go, two thirds.
[[nodiscard]] inline std::optional<NumberTie> first_tie(
    const BasicCase<Multi>& the_case, const BasicSolution<BasicCase<Multi>>& solution, int digits) {
  const Multi part = pow(Multi(10), -(3 * digits) / 4);  // [-], of the forces of the motion
  // a cable is let go by rounding where that is as large as the fourth power of the sine
  const Multi at_release = pow(Multi(10), -digits / 3);  // [-], of the square of a sine
  for (std::size_t index = 0; index < solution.arcs().size(); ++index) {
    const BasicArc<BasicCase<Multi>>& arc = solution.arcs()[index];
    const Multi force = the_case.body.mass * acceleration_scale(the_case, arc.initial);
    std::optional<NumberTie> first;
    for (const BasicTouch<Multi>& touch : touches(the_case, solution, index)) {
      const Multi least = touch.kind == EventKind::slack ? Multi(part * force)
                          : touch.time == arc.end        ? at_release
                                                         : part;
      if (abs(touch.value) <= least) {
        // it decides as long before the least value as that is within rounding
        const Multi width = sqrt(Multi(2 * (abs(touch.value) + least) / touch.bend));
        const Multi time = touch.time - width;
        if (!first || time < first->time) {
          first = NumberTie{{touch.kind, touch.cables}, time};
        }
      }
    }
    if (first) {
      return first;
    }
  }
  return std::nullopt;
}

/// The tie that two solutions of one case have, so that digits do not decide it.
[[nodiscard]] inline std::optional<NumberTie> common_tie(const std::optional<NumberTie>& a,
                                                         const std::optional<NumberTie>& b) {
  constexpr double same = 1e-6;  // [-], of the time: two digits of a tie are the root of one
  const bool alike = a && b && a->tie.kind == b->tie.kind && a->tie.cables == b->tie.cables &&
                     abs(Multi(a->time - b->time)) <= same * (1 + abs(b->time));
  return alike ? b : std::nullopt;
}

}  // namespace tautline::bench
