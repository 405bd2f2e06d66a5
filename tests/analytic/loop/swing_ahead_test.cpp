#include "loop/swing_ahead.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "loop/cosine_sum.hpp"
#include "support.hpp"
#include "tautline/geometry.hpp"
#include "tautline/projection.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

// A swing that is told ahead is the one that follows, and none is told where anything else does.

namespace tautline::test {
namespace {

constexpr SolveOptions followed{.until_locked = true};
constexpr SolveOptions told{.until_locked = true, .swing_ahead = true};

/// What solve.hpp promises, of the size of each number of a swing.
constexpr double right_to = 1e-10;

/// The largest difference of two swings, of their sizes [-].
double difference(const Swing& a, const Swing& b) {
  return std::max({std::abs(a.energy / b.energy - 1.0), std::abs(a.period / b.period - 1.0),
                   std::abs(a.least - b.least) / b.amplitude,
                   std::abs(a.largest - b.largest) / b.amplitude,
                   std::abs(a.amplitude / b.amplitude - 1.0)});
}

/// How many motions lock, and how many of those are told.
struct Tally {
  int locked = 0;
  int ahead = 0;
  double worst = 0.0;  // of `difference`

  /// Follows `the_case`, tells it, and compares.
  void add(const Case& the_case) {
    const Solution known = solve(the_case, followed);
    const Solution found = solve(the_case, told);
    ASSERT_EQ(found.events().size(), known.events().size());
    if (known.ending() == Ending::reached_duration && found.ending() == Ending::locked) {
      // the second turning point is in the last step, which the end of the case cuts off
      EXPECT_TRUE(last_lock(the_case, known).value().permanent);
      return;
    }
    ASSERT_EQ(found.ending(), known.ending());
    if (known.ending() != Ending::locked) {
      EXPECT_EQ(found.end_time(), known.end_time());
      return;
    }
    ++locked;
    ASSERT_TRUE(found.swing() && known.swing());
    EXPECT_EQ(found.arcs().back().taut, known.arcs().back().taut);
    const bool is_ahead = found.end_time() < known.end_time();
    ahead += is_ahead ? 1 : 0;
    if (is_ahead) {
      EXPECT_EQ(found.end_time(), found.events().back().time) << "the lock";
    }
    worst = std::max(worst, difference(*found.swing(), *known.swing()));
  }
};

TEST(SwingAhead, IsTheSwingThatIsFollowed) {
  Random random(20261125);
  Tally tally;
  for (const TableRow& row : table_5_1()) {
    for (int sample = 0; sample < 20; ++sample) {
      Case the_case = breakwater(row.parameters, std::string(row.number));
      the_case.duration = 20.0;
      the_case.initial.position += random.in_square(1e-3);
      the_case.initial.spin += random.uniform(-1e-3, 1e-3);
      SCOPED_TRACE(the_case.name);
      tally.add(the_case);
    }
  }
  std::printf("  %d of %d swings are told\n", tally.ahead, tally.locked);
  EXPECT_GT(tally.locked, 350);
  EXPECT_GT(tally.ahead, tally.locked * 9 / 10) << "most are";
  expect_within("difference from the swing followed", tally.worst, right_to);
}

TEST(SwingAhead, IsTheSwingThatIsFollowedInRandomSystems) {
  Random random(20261126);
  Tally tally;
  for (int sample = 0; sample < 600; ++sample) {
    Case the_case = random_case(random, {2 + static_cast<std::size_t>(sample % 3), 0.0, 0.5});
    the_case.duration = random.log_uniform(3.0, 60.0);
    if (random.chance(0.2)) {  // of other sizes
      the_case.gravity *= random.log_uniform(1e-2, 1e2);
    }
    SCOPED_TRACE(sample);
    tally.add(the_case);
  }
  std::printf("  %d of %d swings are told\n", tally.ahead, tally.locked);
  EXPECT_GT(tally.locked, 50);
  EXPECT_GT(tally.ahead, tally.locked / 3);
  expect_within("difference from the swing followed", tally.worst, right_to);
}

/// The standard case, let go at rest at `angle` [rad] on its taut cables.
std::optional<Swing> told_from(const Case& the_case, double angle, double left = 100.0) {
  return swing_ahead(the_case, on_linkage(the_case, angle), all_cables(the_case), left);
}

TEST(SwingAhead, IsNotToldWhereATensionFallsToZero) {
  for (const char* const number : {"1910121100", "1933121100"}) {
    const Case the_case = table_case(number);
    const double critical = critical_swing(the_case, State{}).value().angle;
    for (const double part : {1.0 + 1e-9, 1.001, 1.01, 1.1}) {
      EXPECT_FALSE(told_from(the_case, part * critical)) << number << " " << part;
    }
    const double told_at = 0.5 * critical;  // of larger ones too little is known
    const auto found = told_from(the_case, told_at);
    ASSERT_TRUE(found) << number;
    EXPECT_NEAR(found->largest, told_at, right_to);
  }
}

TEST(SwingAhead, IsNotToldWhereAnotherCableCloses) {
  const Case two = table_case("1910121100");
  const double angle = 0.5;
  const Vec2 anchor(0.0, -3.0);  // holds the centre from below
  double farthest = 0.0;         // on the swing
  for (int k = 0; k <= 1000; ++k) {
    const State state = on_linkage(two, angle * (k / 500.0 - 1.0));
    farthest = std::max(farthest, (state.position - anchor).norm());
  }
  for (const double spare : {-1e-3, -1e-6, 1e-3, 1e-1}) {
    Case three = two;
    three.cables.push_back({anchor, Vec2::Zero(), farthest + spare, 0.5});
    const State start = on_linkage(two, angle);
    const bool is_told = swing_ahead(three, start, all_cables(two), 100.0).has_value();
    EXPECT_EQ(is_told, spare > 0.0) << spare;
  }
}

TEST(SwingAhead, IsNotToldWhereTheCaseEndsBeforeItsSecondTurningPoint) {
  const Case the_case = table_case("1910121100");
  const Swing swing = told_from(the_case, 0.5).value();
  EXPECT_FALSE(told_from(the_case, 0.5, 0.49 * swing.period)) << "let go at one of the two";
  EXPECT_TRUE(told_from(the_case, 0.5, 1.01 * swing.period));
  // from the equilibrium, either way: a quarter to the first, half to the second
  State fast = on_linkage(the_case, 0.0);
  fast.velocity.x() = 0.05;
  fast = projected(the_case, fast, all_cables(the_case));
  ASSERT_GT(kinetic_energy(the_case.body, fast), 1e-6);
  for (const double sign : {1.0, -1.0}) {
    fast.velocity *= sign;
    fast.spin *= sign;
    const auto told_in = [&](double left) {
      return swing_ahead(the_case, fast, all_cables(the_case), left);
    };
    const auto whole = told_in(100.0);
    ASSERT_TRUE(whole);
    EXPECT_FALSE(told_in(0.74 * whole->period));
    EXPECT_TRUE(told_in(0.76 * whole->period));
  }
}

TEST(SwingAhead, IsNotToldOfWhatIsNone) {
  Case the_case = table_case("1910121100");
  const State start = on_linkage(the_case, 0.5);
  EXPECT_FALSE(swing_ahead(the_case, on_linkage(the_case, 0.0), all_cables(the_case), 100.0))
      << "it rests";
  EXPECT_FALSE(swing_ahead(the_case, on_linkage(the_case, 1e-7), all_cables(the_case), 100.0))
      << "so small that ten digits cannot be told";
  EXPECT_FALSE(swing_ahead(the_case, start, CableSet::of(0), 100.0));
  Case limited = the_case;
  limited.angle_limit = 0.6;
  EXPECT_FALSE(swing_ahead(limited, start, all_cables(the_case), 100.0));
  limited = the_case;
  limited.ceiling = 10.0;
  EXPECT_FALSE(swing_ahead(limited, start, all_cables(the_case), 100.0));
  Case weightless = the_case;
  weightless.gravity.setZero();
  State flung = start;
  flung.velocity.x() = 0.1;
  EXPECT_FALSE(swing_ahead(weightless, projected(weightless, flung, all_cables(weightless)),
                           all_cables(weightless), 100.0));
  for (const double huge : {1e60, 1e150}) {  // numbers overflow
    State wild = start;
    wild.spin = huge;
    EXPECT_FALSE(swing_ahead(the_case, wild, all_cables(the_case), 100.0));
  }
}

/// Values of `f` over the place x from -1 to 1 at the nodes.
template <class Function>
CosineSum sum_of(const Function& f) {
  CosineSum::Values values{};
  for (std::size_t k = 0; k < CosineSum::terms; ++k) {
    values[k] = f(CosineSum::nodes().cosine[k]);
  }
  return CosineSum(values);
}

TEST(CosineSum, KnowsIntegralsOverThePhase) {
  const CosineSum sum = sum_of([](double x) { return std::exp(x); });
  // the mean is the Bessel function I_0(1)
  EXPECT_NEAR(sum.mean(), 1.26606587775200834, 1e-15);
  EXPECT_NEAR(sum.integral(std::numbers::pi), std::numbers::pi * sum.mean(), 1e-15);
  // of x + 2 x^2 = cos p + 1 + cos 2 p
  const CosineSum low = sum_of([](double x) { return x + 2.0 * x * x; });
  for (const double phase : {0.3, 1.0, 2.5}) {
    EXPECT_NEAR(low.integral(phase), std::sin(phase) + phase + std::sin(2.0 * phase) / 2.0, 1e-14);
  }
}

TEST(CosineSum, SaysThatThereIsNoZeroWhereThereIsNone) {
  Random random(20261127);
  int certain = 0;
  for (int sample = 0; sample < 1'500; ++sample) {
    std::array<double, 9> a{};
    for (std::size_t j = 1; j < a.size(); ++j) {
      a[j] = random.uniform(-1.0, 1.0) / static_cast<double>(j * j);
    }
    const auto f = [&](double x) {
      double value = 0.0;
      for (std::size_t j = 0; j < a.size(); ++j) {
        value += a[j] * std::cos(static_cast<double>(j) * std::acos(x));
      }
      return value;
    };
    double least = infinity<double>();
    for (int k = 0; k <= 1000; ++k) {
      least = std::min(least, f(k / 500.0 - 1.0));
    }
    const double above = random.uniform(-0.1, 0.1);
    a[0] = above - least;  // its least value is `above`
    const bool has_none = sum_of(f).has_no_zero();
    EXPECT_FALSE(has_none && above <= -1e-5) << above;
    EXPECT_TRUE(has_none || above <= 0.05) << above;
    certain += has_none ? 1 : 0;
  }
  EXPECT_GT(certain, 500);
}

TEST(CosineSum, SaysNothingOfWhatItDoesNotKnow) {
  EXPECT_FALSE(sum_of([](double x) { return 1.1 - std::abs(x); }).has_no_zero()) << "a corner";
  EXPECT_FALSE(sum_of([](double x) { return 1.0 / (1e-3 + x * x); }).has_no_zero()) << "a peak";
  EXPECT_FALSE(sum_of([](double) { return not_a_number<double>(); }).has_no_zero());
  EXPECT_FALSE(sum_of([](double) { return infinity<double>(); }).has_no_zero());
  EXPECT_FALSE(sum_of([](double) { return 0.0; }).has_no_zero());
  EXPECT_TRUE(sum_of([](double x) { return -2.0 + x; }).has_no_zero()) << "of either sign";
}

}  // namespace
}  // namespace tautline::test
