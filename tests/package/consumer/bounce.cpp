// A ball on a slack cable, dropped: the cable is taut for the first time after sqrt(2 h / g).

#include <cmath>
#include <cstdio>
#include <limits>

#include "tautline/solve.hpp"

int main() {
  const double gravity = 9.81;  // [m/s^2]
  const double height = 0.75;   // [m], the gap the ball falls through

  tautline::Case ball;
  ball.name = "a ball of my own";
  ball.body = {.mass = 2.0, .inertia = 0.0};
  ball.cables = {{.length = 1.0, .restitution = 0.5}};
  ball.gravity = {0.0, -gravity};
  ball.initial.position = {0.0, height - 1.0};
  ball.duration = 1.0;
  for (const auto& problem : tautline::problems(ball)) {
    std::printf("problem: %s\n", problem.c_str());
    return 1;
  }

  const auto solution = tautline::solve(ball);
  if (solution.events().empty()) {
    std::printf("no event in %g s\n", ball.duration);
    return 1;
  }
  const auto& first = solution.events().front();
  const double expected = std::sqrt(2.0 * height / gravity);
  const double tolerance = 1e-12;  // the solver locates events to rounding; this leaves it room
  std::printf("first impact at %.17g s, expected %.17g s\n", first.time, expected);
  return first.kind == tautline::EventKind::impact && std::abs(first.time - expected) <= tolerance
             ? 0
             : 1;
}
