#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support.hpp"
#include "system/systems.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solve.hpp"

// The general kernel in double against itself in 40 digits, of the same numbers.

namespace tautline::test {
namespace {

/// The largest difference of times and states over the first `count` impacts.
double error_after(const System& system, std::size_t count) {
  const Digits digits(40);
  SolveOptions options;
  options.max_events = 200;
  const auto rounded = solve(system, options);
  const auto exact = solve(converted<Multi>(system), options);
  double most = 0.0;
  std::size_t impacts = 0;
  for (std::size_t i = 0; i < std::min(rounded.events().size(), exact.events().size()); ++i) {
    const auto& one = rounded.events()[i];
    const auto& other = exact.events()[i];
    EXPECT_EQ(one.kind, other.kind) << "event " << i;
    most = std::max(most, std::abs(one.time - static_cast<double>(other.time)));
    for (std::size_t body = 0; body < system.bodies.size(); ++body) {
      const auto& truth = other.after.bodies[body];
      const auto number = [](const Multi& value) { return static_cast<double>(value); };
      most = std::max(most, difference(one.after.bodies[body],
                                       {{number(truth.position.x()), number(truth.position.y())},
                                        number(truth.angle),
                                        {number(truth.velocity.x()), number(truth.velocity.y())},
                                        number(truth.spin)}));
    }
    impacts += one.kind == EventKind::impact ? 1U : 0U;
    if (impacts == count) {
      return most;
    }
  }
  return most;
}

TEST(SystemDigits, AgreeOverTwentyImpacts) {
  expect_within("shaken", error_after(shaken<double>(), 20), 1e-11);
  expect_within("waves", error_after(waves<double>(), 20), 1e-11);
  expect_within("winch", error_after(winch<double>(), 12), 1e-11);
  expect_within("plastic", error_after(plastic<double>(), 3), 1e-11);
  expect_within("pulley", error_after(pulley<double>(), 20), 1e-11);
  expect_within("in series", error_after(in_series<double>(), 20), 1e-11);
  expect_within("chain", error_after(chain<double>(0.9), 18), 1e-11);
}

}  // namespace
}  // namespace tautline::test
