// What adapters share: the clock, the unwrapped angle, when and how fast a cable acts, and
// impulses.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analytic/support.hpp"
#include "tautline/cable_row.hpp"
#include "tautline/clock.hpp"
#include "tautline/impulses_by_hand.hpp"
#include "tautline/model_table.hpp"
#include "tautline/unwrap.hpp"

namespace tautline {
namespace {

TEST(Clock, ReadsWholeStepsToTheLastBit) {
  Clock clock;
  double plain = 0.0;
  constexpr double step = 1e-4;
  constexpr int steps = 200'000;
  for (int k = 0; k < steps; ++k) {
    clock.advance(step);
    plain += step;
  }
  const double wanted = steps * step;
  std::cout << "  a plain sum is off by " << std::abs(plain - wanted) << '\n';
  test::expect_within("clock error [s]", std::abs(clock.now() - wanted), std::ldexp(wanted, -52));
}

TEST(Unwrap, AddsTheTurnsAnEngineForgets) {
  constexpr double turn = 2.0 * std::numbers::pi;
  for (int k = -80; k < 80; ++k) {
    const double angle = 0.37 * k;
    const double wrapped = std::remainder(angle, turn);
    EXPECT_NEAR(unwrap(wrapped, angle + 0.4), angle, 1e-14 * (1.0 + std::abs(angle)));
  }
  EXPECT_EQ(unwrap(0.3, -0.2), 0.3);  // exactly: no turn is added
}

CableRow row_with(double gap, double rate) { return {Vec2::Zero(), Vec2::UnitY(), 0.0, gap, rate}; }

TEST(CableRow, RaisesTheGapAlongItsDirection) {
  const Cable cable{Vec2(0.5, 2.0), Vec2(0.3, -0.2), 3.0, 0.5};
  const State state{Vec2(0.1, 0.2), 0.7, Vec2(0.4, -0.3), 1.1};
  const CableRow row = cable_row(cable, state);
  const double rate = row.towards.dot(state.velocity) + row.moment * state.spin;
  EXPECT_NEAR(rate, row.rate, 1e-15);
  EXPECT_NEAR((row.point + (cable.length - row.gap) * row.towards - cable.anchor).norm(), 0.0,
              1e-15);
}

TEST(Activation, RowWaitsForTheOverstretchAndEarlyDoesNot) {
  const CableRow about_to_cross = row_with(0.01, -2.0);
  EXPECT_FALSE(acts(about_to_cross, Activation::overstretched, 0.01));
  EXPECT_TRUE(acts(about_to_cross, Activation::crossing, 0.01));
  EXPECT_FALSE(acts(about_to_cross, Activation::crossing, 0.004));
  EXPECT_FALSE(acts(row_with(0.01, 2.0), Activation::crossing, 0.01));
  EXPECT_TRUE(acts(row_with(-0.01, 2.0), Activation::overstretched, 0.01));
}

TEST(WantedRate, IsTheLargerOfBounceAndCorrectionAndNotTheirSum) {
  EXPECT_DOUBLE_EQ(wanted_rate(row_with(-0.01, -2.0), 0.5, 20.0), 1.0);
  EXPECT_DOUBLE_EQ(wanted_rate(row_with(-0.1, -2.0), 0.5, 20.0), 2.0);
  EXPECT_DOUBLE_EQ(wanted_rate(row_with(-0.0, 3.0), 0.5, 20.0), 0.0);
}

TEST(WantedRate, CorrectsNoFasterThanItMay) {
  EXPECT_DOUBLE_EQ(wanted_rate(row_with(-0.1, -2.0), 0.0, 20.0, 0.01), 0.01);
  EXPECT_DOUBLE_EQ(wanted_rate(row_with(-0.1, -2.0), 0.5, 20.0, 0.01), 1.0);
  EXPECT_DOUBLE_EQ(wanted_rate(row_with(-1e-4, 0.0), 0.0, 20.0, 0.01), 2e-3);
}

/// A body on a cable of 1 m straight above it, `gap` [m] from its end.
Case hanging(double gap) {
  Case result;
  result.body = {2.0, 0.1};
  result.gravity = Vec2(0.0, -10.0);
  result.cables = {{.anchor = Vec2(0.0, 1.0), .length = 1.0}};
  result.initial.position = Vec2(0.0, gap);
  return result;
}

TEST(ChangeInStep, IsOfGravityAndOfTheSwing) {
  Case the_case = hanging(0.0);
  EXPECT_DOUBLE_EQ(change_in_step(the_case, 0, the_case.initial, 0.01), 0.1);
  the_case.initial.velocity = Vec2(2.0, 0.0);
  EXPECT_DOUBLE_EQ(change_in_step(the_case, 0, the_case.initial, 0.01), 0.1 + 0.01 * 4.0);
}

TEST(OutOfOverstretch, MovesABodyThatRestsAndLeavesItsVelocity) {
  const Case the_case = hanging(-0.1);
  // 20 / s of 0.1 m are 2 m/s; a row takes the 0.1 m/s that gravity gives in this step, a move the
  // rest
  const auto moved = out_of_overstretch(the_case, the_case.initial, 20.0, 0.01);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->position.y(), -0.1 + 0.01 * (2.0 - 0.1), 1e-15);
  EXPECT_EQ(moved->velocity, Vec2::Zero());
  EXPECT_EQ(moved->spin, 0.0);
}

TEST(OutOfOverstretch, LeavesABodyThatIsHitOrReboundsToItsVelocity) {
  Case the_case = hanging(-0.1);
  for (const double rate : {-0.2, 2.1}) {  // of the gap: upwards it opens
    the_case.initial.velocity = Vec2(0.0, rate);
    EXPECT_FALSE(out_of_overstretch(the_case, the_case.initial, 20.0, 0.01)) << rate;
  }
  the_case.initial.velocity = Vec2(0.0, 1.0);  // half as fast as it should be
  const auto moved = out_of_overstretch(the_case, the_case.initial, 20.0, 0.01);
  ASSERT_TRUE(moved);
  EXPECT_NEAR(moved->position.y(), -0.1 + 0.01 * (2.0 - 1.0), 1e-15);
  EXPECT_FALSE(out_of_overstretch(hanging(0.1), hanging(0.1).initial, 20.0, 0.01)) << "slack";
  EXPECT_FALSE(out_of_overstretch(hanging(-1e-3), hanging(-1e-3).initial, 20.0, 0.01))
      << "a row alone does it";
}

TEST(OutOfOverstretch, OfOneCableDoesNotStretchTheOther) {
  Case the_case = hanging(-0.1);
  the_case.cables.push_back({.anchor = Vec2(0.0, -1.1), .length = 1.0});  // at its end below
  const auto moved = out_of_overstretch(the_case, the_case.initial, 20.0, 0.01);
  if (moved) {
    EXPECT_NEAR(moved->position.y(), -0.1, 1e-12);
  }
}

TEST(Correction, IsNoFasterInAShortLastStep) {
  EXPECT_DOUBLE_EQ(correction_in_step(1e-3, 1e-3), 0.2);
  EXPECT_DOUBLE_EQ(correction_in_step(1e-9, 1e-3) / 1e-9, 0.2 / 1e-3);
}

TEST(ModelTable, NamesItsModelsWhenAskedForAnother) {
  const std::vector<ModelEntry> table = {{{"row", "A row.", {}}, {}}, {{"event", "All.", {}}, {}}};
  try {
    (void)start_model(table, "rope", Case{}, 1e-3);
    FAIL() << "accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "model rope is unknown; there are row, event");
  }
}

TEST(ImpulsesByHand, GiveWhatTheRatesAreShortOf) {
  const CableMatrix one = CableMatrix::Constant(1, 1, 2.0);
  const auto impulse = [&](double excess) {
    return impulses_by_hand(one, CableVector::Constant(1, excess), 0.0)[0];
  };
  EXPECT_EQ(impulse(-4.0), 2.0);
  EXPECT_EQ(impulse(4.0), 0.0);
}

TEST(ImpulsesByHand, LeaveOutACableThatAsksForNothingWhereThereIsNoSolutionWithIt) {
  CableMatrix opposed(2, 2);
  opposed << 1.0, -1.0, -1.0, 1.0;
  const CableVector both_cannot_open = (CableVector(2) << -1.0, 0.5).finished();
  const CableVector impulses = impulses_by_hand(opposed, both_cannot_open, 0.0);
  EXPECT_EQ(impulses[0], 1.0);
  EXPECT_EQ(impulses[1], 0.0);
  const CableVector both_close = CableVector::Constant(2, -1.0);
  EXPECT_EQ(impulses_by_hand(opposed, both_close, 0.0).cwiseAbs().maxCoeff(), 0.0);
}

}  // namespace
}  // namespace tautline
