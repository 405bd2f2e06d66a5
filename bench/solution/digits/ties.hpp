#pragma once

#include <optional>

#include "tautline/multiprecision.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

/// Where the tension of a cable touches zero as far as the digits of a solution tell.
struct NumberTie {
  std::size_t cable;
  Multi time;  // [s], from which on it may have let go
};

/// The first of `solution`, which was computed with numbers of `digits`; none if there is none. A
/// quarter of the digits is left to what the motion makes of their rounding.
[[nodiscard]] inline std::optional<NumberTie> first_tie(const BasicCase<Multi>& the_case,
                                                        const BasicSolution<Multi>& solution,
                                                        int digits) {
  const Multi part = pow(Multi(10), -(3 * digits) / 4);  // [-], of the forces of the motion
  for (std::size_t index = 0; index < solution.arcs().size(); ++index) {
    const BasicArc<Multi>& arc = solution.arcs()[index];
    const Multi force = the_case.body.mass * acceleration_scale(the_case, arc.initial);
    for (const BasicTouch<Multi>& touch : touches(the_case, solution, index)) {
      if (abs(touch.tension) <= part * force) {
        // it may let go as long before the least tension as that is within rounding
        const Multi width = sqrt(Multi(2 * (abs(touch.tension) + part * force) / touch.bend));
        return NumberTie{touch.cable, touch.time - width};
      }
    }
  }
  return std::nullopt;
}

/// The tie that two solutions of one case have, so that digits do not decide it.
[[nodiscard]] inline std::optional<NumberTie> common_tie(const std::optional<NumberTie>& a,
                                                         const std::optional<NumberTie>& b) {
  constexpr double same = 1e-6;  // [-], of the time: two digits of a tie are the root of one
  const bool alike =
      a && b && a->cable == b->cable && abs(Multi(a->time - b->time)) <= same * (1 + abs(b->time));
  return alike ? b : std::nullopt;
}

}  // namespace tautline::bench
