// The return of a bounce is found from its start alone where that says it: never a later one.

#include <gtest/gtest.h>

#include <cmath>

#include "flight/gap_along_flight.hpp"
#include "support.hpp"

namespace tautline::test {
namespace {

constexpr std::uint64_t return_seed = 20261125;

/// A body that leaves its one cable at some speed between next to none and fast.
struct LeavingBody {
  Cable cable;
  State state;
  Vec2 gravity;

  explicit LeavingBody(Random& random) {
    const double direction = random.uniform(-3.2, 3.2);
    const Vec2 along(std::cos(direction), std::sin(direction));
    cable.length = random.log_uniform(0.05, 20.0);
    cable.attachment = random.log_uniform(1e-3, 2.0) * random.in_square(1.0);
    gravity = 10.0 * random.in_square(1.0);
    state.position = random.in_square(2.0);
    state.angle = random.uniform(-3.2, 3.2);
    state.spin = random.log_uniform(1e-3, 30.0) * (random.chance(0.5) ? 1.0 : -1.0);
    state.velocity = random.log_uniform(1e-8, 10.0) * random.in_square(1.0);
    cable.anchor = attachment_point(state, cable) - cable.length * along;
    state.velocity += (gap_rate(cable, state) - random.log_uniform(1e-9, 1.0)) * along;
  }

  [[nodiscard]] Flight<double> flight() const {
    return {pair<double>(state.position), direction(state.angle),
            pair<double>(state.velocity), state.spin,
            pair<double>(gravity),        gravity.norm(),
            state.velocity.norm(),        state.spin * state.spin};
  }

  /// What rounding leaves of the gap after a way of `t` [s].
  [[nodiscard]] double rounding(double t) const {
    const double speed = state.velocity.norm() + std::abs(state.spin) * cable.attachment.norm();
    return 5e-15 * (speed + gravity.norm() * t) * t;
  }
};

TEST(ShortReturn, IsTheFirstOne) {
  Random random(return_seed);
  constexpr int flights = 20'000;
  int short_ones = 0;
  for (int k = 0; k < flights; ++k) {
    const LeavingBody body(random);
    const Flight<double> flight = body.flight();
    const GapAlongFlight<double> f(flight, flight_cable(body.cable), true, 0.0);
    if (!newton_is_certain_of_return(f, without_first_root(f.at_start()))) {
      continue;
    }
    ++short_ones;
    const double root = first_roots(f, infinity<double>(), true).root;
    ASSERT_TRUE(std::isfinite(root)) << "flight " << k;
    EXPECT_LE(std::abs(f.at(root).value), body.rounding(root)) << "flight " << k;
    EXPECT_LT(f.at(root).rate, 0.0) << "flight " << k;
    constexpr int samples = 100;
    for (int sample = 1; sample < samples; ++sample) {
      const double t = root * sample / samples;
      ASSERT_GE(f.at(t).value, -body.rounding(t))
          << "flight " << k << " at " << t << " of " << root;
    }
  }
  EXPECT_GT(short_ones, flights / 4) << "the short way is worth its lines";
}

// where rounding is all that there is, f may rise at its root, and Newton's method gets lost
TEST(ShortReturn, OfARateOfRoundingIsAnInstant) {
  Random random(return_seed);
  for (int k = 0; k < 20'000; ++k) {
    LeavingBody body(random);
    const double rate = gap_rate(body.cable, body.state);
    const Vec2 along =
        (attachment_point(body.state, body.cable) - body.cable.anchor) / body.cable.length;
    body.state.velocity += (rate - random.log_uniform(1e-18, 1e-14)) * along;
    const Flight<double> flight = body.flight();
    const GapAlongFlight<double> f(flight, flight_cable(body.cable), true, 0.0);
    for (const double horizon : {0.0, 1e-20, 1.0}) {
      EXPECT_GE(first_roots(f, horizon, true).root, 0.0)
          << "flight " << k << " of rate " << gap_rate(body.cable, body.state) << " to " << horizon;
    }
  }
}

}  // namespace
}  // namespace tautline::test
