#include "tautline/detail/first_contact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "dense_search.hpp"
#include "support.hpp"
#include "tautline/detail/flight.hpp"
#include "tautline/geometry.hpp"

namespace tautline::test {
namespace {

#ifdef TAUTLINE_SANITIZED
constexpr int arcs = 20'000;  // sanitizers slow this down twentyfold
#else
constexpr int arcs = 1'000'000;
#endif
constexpr std::uint64_t flight_seed = 1001;
constexpr double horizon = 3.0;
constexpr int coarse = 300;  // samples: ten per radian at the fastest spin
constexpr int fine = 20'000;

/// Rounding of a gap in double, by the cable's length [-]: a few ulp of positions and length.
constexpr double gap_noise = 2e-15;

Case random_arc(Random& random) {
  Case result = random_case(random, {1, 0.01, 0.0});
  result.initial.spin = random.uniform(-4.0, 4.0);
  return result;
}

/// An arc whose gap dips below zero for about `apart`, or stays `above` zero at its minimum.
std::optional<Case> tangent_arc(Random& random, double apart, double above) {
  Case result = random_arc(random);
  const auto farthest = first_farthest(result, horizon, coarse);
  if (!farthest) {
    return std::nullopt;
  }
  const double dip = farthest->curvature * apart * apart / 8.0;
  result.cables.front().length = farthest->distance - dip + above;
  if (gap(result.cables.front(), result.initial) < 1e-3 * farthest->distance) {
    return std::nullopt;  // not slack at the start any more
  }
  return result;
}

/// What went wrong over many arcs.
struct FlightTally {
  int searched = 0;
  int skipped = 0;      // roots passed over
  int invented = 0;     // roots where there is none
  int undecidable = 0;  // the gap's minimum is within its rounding of zero
  long steps = 0;
  int most_steps = 0;
  double worst_time = 0.0;  // [s], error of a root with gap rate above 0.01
};

void print(const FlightTally& tally) {
  std::cout << "  seed " << flight_seed << ": " << tally.searched << " arcs, " << tally.skipped
            << " skipped, " << tally.invented << " invented, " << tally.undecidable
            << " undecidable, " << static_cast<double>(tally.steps) / std::max(1, tally.searched)
            << " steps on average, " << tally.most_steps << " at most\n";
}

/// Compares one arc with the dense method.
void compare(const Case& the_case, FlightTally& tally) {
  const FirstContactSearch search = first_contact(the_case, the_case.initial, {}, horizon);
  ++tally.searched;
  tally.steps += search.steps;
  tally.most_steps = std::max(tally.most_steps, search.steps);
  const auto agree = [&](const std::optional<DenseContact>& expected) {
    if (expected.has_value() != search.contact.has_value()) {
      return false;
    }
    if (!expected) {
      return true;
    }
    // noise of the gap moves a root by noise / rate; near a tangent point by its square root
    const double noise = gap_noise * the_case.cables.front().length;
    const double allowed = 1e-15 * horizon + 2.0 * noise / expected->closing;
    const double error = std::abs(search.contact->dt - expected->time);
    if (expected->closing > 0.01) {
      tally.worst_time = std::max(tally.worst_time, error);
    }
    return error <= allowed;
  };
  if (agree(dense_first_contact(the_case, horizon, coarse))) {
    return;
  }
  // either the samples were too coarse, or the search is wrong
  const auto expected = dense_first_contact(the_case, horizon, fine);
  if (agree(expected)) {
    return;
  }
  const bool late = expected && (!search.contact || search.contact->dt > expected->time);
  // a dip no deeper than rounding: its depth is rate^2 / (2 curvature), the curvature at least 0.1
  const double noise = gap_noise * the_case.cables.front().length;
  if (late && expected->closing * expected->closing / 0.2 <= noise) {
    ++tally.undecidable;
    return;
  }
  if (!late && std::abs(precise_gap(the_case, search.contact->dt)) <= noise) {
    ++tally.undecidable;  // touches zero within rounding: as good a root as any
    return;
  }
  ++(late ? tally.skipped : tally.invented);
}

TEST(FirstContact, SkipsNoRootOfAMillionRandomArcs) {
  Random random(flight_seed);
  FlightTally tally;
  for (int arc = 0; arc < arcs; ++arc) {
    compare(random_arc(random), tally);
  }
  print(tally);
  EXPECT_EQ(tally.skipped, 0);
  EXPECT_EQ(tally.invented, 0);
  constexpr double accepted_steps = 6.0;
  expect_within("steps on average", static_cast<double>(tally.steps) / arcs, accepted_steps);
  expect_within("worst error of a root [s]", tally.worst_time, 1e-12);  // 2e-15 / 0.01 and rounding
}

TEST(FirstContact, SeparatesTwoRootsDownTo1e7Apart) {
  for (const double apart : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 3e-7, 1e-7}) {
    Random random(flight_seed);
    FlightTally tally;
    for (int arc = 0; arc < arcs / 50; ++arc) {
      if (const auto the_case = tangent_arc(random, apart, 0.0)) {
        compare(*the_case, tally);
      }
    }
    std::cout << "  roots " << apart << " apart\n";
    print(tally);
    EXPECT_EQ(tally.skipped, 0) << "roots " << apart << " apart";
    EXPECT_EQ(tally.invented, 0) << "roots " << apart << " apart";
  }
}

TEST(FirstContact, PassesAMinimumOfTheGapThatStaysAboveZero) {
  for (const double above : {1e-4, 1e-8, 1e-12}) {
    Random random(flight_seed);
    FlightTally tally;
    for (int arc = 0; arc < arcs / 50; ++arc) {
      if (const auto the_case = tangent_arc(random, 0.0, above)) {
        compare(*the_case, tally);
      }
    }
    std::cout << "  minimum of the gap " << above << '\n';
    print(tally);
    EXPECT_EQ(tally.skipped, 0) << "minimum " << above;
    EXPECT_EQ(tally.invented, 0) << "minimum " << above;
  }
}

TEST(FirstContact, OfAGrazeIsNoneOrTooSlowToMatter) {
  // thrown straight away from the anchor so that it turns at the cable's end: rate 0 there, and the
  // gap opens again. Whether the rounded gap dips below zero is chance; if so the closing rate is
  // sqrt(2 g noise). Missing such a dip would be worse: it could be a real one.
  for (const double length : {2.0, 1.7, 3.1, 0.4, 1.3, 0.9}) {
    Case the_case = bouncing_ball(0.5);
    the_case.gravity = Vec2(0.0, -2.0);
    the_case.cables.front().anchor = Vec2(0.0, 0.0);
    the_case.cables.front().length = length;
    const double speed = std::sqrt(2.0 * length);  // rises by length / 2
    the_case.initial = {Vec2(0.0, 0.5 * length), 0.0, Vec2(0.0, speed), 0.0};
    const FirstContactSearch search = first_contact(the_case, the_case.initial, {}, 0.75 * speed);
    EXPECT_LE(search.steps, 100) << "length " << length;
    if (search.contact) {
      const State there = fly(the_case.initial, the_case.gravity, search.contact->dt);
      EXPECT_LE(-gap_rate(the_case.cables.front(), there),
                std::sqrt(2.0 * 2.0 * gap_noise * length))
          << "length " << length;
    }
  }
}

TEST(FirstContact, OfAJustHitCableIsItsReturn) {
  Case ball = bouncing_ball(0.5);
  ball.initial.position.y() = 0.0;
  for (const double speed : {1.0, 1e-3, 1e-6, 1e-9, 1e-12}) {
    ball.initial.velocity.y() = speed;
    const auto contact = first_contact(ball, ball.initial, {CableSet::of(0), 0.0}, 10.0).contact;
    ASSERT_TRUE(contact.has_value()) << "speed " << speed;
    EXPECT_NEAR(contact->dt / (2.0 * speed), 1.0, 1e-14) << "speed " << speed;
  }
}

TEST(FirstContact, OfAJustHitCableMayNotCome) {
  Case ball = bouncing_ball(0.5);
  ball.gravity.setZero();
  ball.initial.position.y() = 0.0;
  ball.initial.velocity.y() = 1.0;  // through the anchor and out on the other side: at 4
  const Touching touching{CableSet::of(0), 0.0};
  EXPECT_FALSE(first_contact(ball, ball.initial, touching, 3.99).contact.has_value());
  const auto beyond = first_contact(ball, ball.initial, touching, 5.0).contact;
  ASSERT_TRUE(beyond.has_value());
  EXPECT_NEAR(beyond->dt, 4.0, 1e-14);
}

TEST(FirstContact, SearchEndsForAStationaryBodyWithoutGravity) {
  Case ball = bouncing_ball(0.5);
  ball.gravity.setZero();
  EXPECT_FALSE(first_contact(ball, ball.initial, {}, 1e6).contact.has_value());
  ball.initial.position.y() = 0.0;
  const FirstContactSearch search = first_contact(ball, ball.initial, {CableSet::of(0), 0.0}, 1e6);
  EXPECT_FALSE(search.contact.has_value());
  EXPECT_LE(search.steps, 2000);
  ball.initial.spin = 2.0;  // about the attachment: the gap stays zero
  const FirstContactSearch spinning =
      first_contact(ball, ball.initial, {CableSet::of(0), 0.0}, 10.0);
  EXPECT_FALSE(spinning.contact.has_value());
  EXPECT_LE(spinning.steps, 2000);
}

TEST(FirstContact, OfTwoCablesAtOnceNamesBoth) {
  Breakwater p;
  p.initial = {Vec2(0.0, 0.3), 0.0, Vec2(0.0, 0.0), 0.0};
  const Case the_case = breakwater(p, "symmetric fall");
  const auto contact = first_contact(the_case, the_case.initial, {}, 10.0).contact;
  ASSERT_TRUE(contact.has_value());
  EXPECT_EQ(contact->cables.size(), 2U);
  EXPECT_NEAR(contact->dt, std::sqrt(0.6), 1e-15);
}

}  // namespace
}  // namespace tautline::test
