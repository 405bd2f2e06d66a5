#include "shortcuts/swing_ahead.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "shortcuts/cosine_sum.hpp"
#include "support.hpp"
#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"
#include "tautline/impact.hpp"
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
double swing_difference(const Swing& a, const Swing& b) {
  return std::max({std::abs(a.energy / b.energy - 1.0), std::abs(a.period / b.period - 1.0),
                   std::abs(a.least - b.least) / b.amplitude,
                   std::abs(a.largest - b.largest) / b.amplitude,
                   std::abs(a.amplitude / b.amplitude - 1.0)});
}

/// Of the largest tension of a swing that is told [-].
constexpr double right_tension = 1e-10;

/// How many motions lock, and how many of those are told.
struct Tally {
  int locked = 0;
  int ahead = 0;
  double worst = 0.0;          // of `difference`
  double worst_tension = 0.0;  // [-]

  /// Follows `the_case`, tells it, and compares.
  void add(const Case& the_case) {
    const Solution known = solve(the_case, followed);
    const Solution found = solve(the_case, told);
    ASSERT_EQ(found.events().size(), known.events().size());
    if (known.ending() == Ending::reached_duration && found.ending() == Ending::locked) {
      // the second turning point is in the last step, which the end of the case cuts off
      Case longer = the_case;
      longer.duration *= 2.0;
      const Solution whole = solve(longer, followed);
      EXPECT_EQ(whole.ending(), Ending::locked);
      EXPECT_LE(whole.end_time(), the_case.duration);
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
    const double off = swing_difference(*found.swing(), *known.swing());
    EXPECT_TRUE(std::isfinite(off));
    worst = std::max(worst, off);
    if (is_ahead) {
      expect_turning_one_way(known, found.end_time());
      const double tension = tension_from(known, found.end_time());
      worst_tension =
          std::max(worst_tension, std::abs(found.swing()->largest_tension.value() / tension - 1.0));
    }
  }

 private:
  /// The largest tension of the motion from `lock` [s] on [N].
  static double tension_from(const Solution& known, double lock) {
    std::vector<Arc> swing;
    for (const Arc& arc : known.arcs()) {
      if (arc.start >= lock) {
        swing.push_back(arc);
      }
    }
    return largest_sampled_tension({known.system(), swing, {}, known.ending(), {}});
  }

  /// The turning points of a swing that is told are its largest angles: by the one that is
  /// followed.
  static void expect_turning_one_way(const Solution& known, double lock) {
    const double rounding = 1e-9 * known.swing()->amplitude;
    for (int sample = 0; sample <= 100; ++sample) {
      const double time = std::lerp(lock, known.end_time(), sample / 100.0);
      const double angle = known.at(time).angle;
      EXPECT_LE(angle, known.swing()->largest + rounding);
      EXPECT_GE(angle, known.swing()->least - rounding);
    }
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
  expect_within("difference of its largest tension", tally.worst_tension, right_tension);
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
  expect_within("difference of its largest tension", tally.worst_tension, right_tension);
}

/// [s], of the motion of `the_case`, which starts on a swing: when it is still for the second time.
double time_of_second_turn(const Case& the_case) {
  const Solution whole = solve(the_case);
  const auto is_fast = [&](double time) {
    return kinetic_energy(the_case.body, whole.at(time)) > 1e-6;
  };
  double first = 0.0;  // instant that it is slow again
  double end = 0.0;    // of that
  for (int turn = 0; turn < 2; ++turn) {
    for (first = end; is_fast(first); first += 1e-4) {
    }
    for (end = first; !is_fast(end); end += 1e-4) {
    }
  }
  return (first + end) / 2.0;
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
  for (const double angle : {0.5, -0.5}) {  // let go at rest, which is no turning point
    const Swing swing = told_from(the_case, angle).value();
    EXPECT_FALSE(told_from(the_case, angle, 0.999 * swing.period)) << angle;
    EXPECT_TRUE(told_from(the_case, angle, 1.001 * swing.period)) << angle;
  }
  for (const double sign : {1.0, -1.0}) {  // flung up, or down through the equilibrium
    Case flung = the_case;
    flung.initial = on_linkage(the_case, 0.25);
    flung.initial.velocity.x() = 0.08 * sign;
    flung.initial = projected(the_case, flung.initial, all_cables(the_case));
    flung.duration = 100.0;
    const auto told_in = [&](double left) {
      return swing_ahead(the_case, flung.initial, all_cables(the_case), left);
    };
    ASSERT_TRUE(told_in(100.0));
    const double second = time_of_second_turn(flung);
    EXPECT_FALSE(told_in(second - 1e-3)) << sign;
    EXPECT_TRUE(told_in(second + 1e-3)) << sign;
  }
}

// nearly stretched against each other, cables carry many times the weight, and gaps are as many
// times more of the energy; nearly parallel ones hardly let the body turn; small swings have little
TEST(SwingAhead, HasTenDigitsOfWhatItTells) {
  Random random(20261128);
  int compared = 0;
  double worst = 0.0;
  for (int sample = 0; sample < 4'000; ++sample) {
    const double half = random.log_uniform(1e-3, 1.0);   // [m], of the body
    const double width = random.log_uniform(1e-3, 1.0);  // [m], between anchor and attachment
    const double fall = random.log_uniform(1e-4, 1.0);   // [m]
    Case the_case;
    the_case.body = {1.0, random.log_uniform(0.1, 10.0) * half * half};
    for (const double side : {-1.0, 1.0}) {
      const Vec2 anchor(side * (half + random.uniform(-1.0, 1.0) * width), fall);
      const Vec2 attachment(side * half, 0.0);
      the_case.cables.push_back({anchor, attachment, (anchor - attachment).norm(), 0.5});
    }
    the_case.duration = 1e4;
    const double speed = random.log_uniform(1e-5, 1.0);
    the_case.initial.velocity = {speed, 0.0};
    the_case.initial.spin = random.uniform(-1.0, 1.0) * speed / half;
    const CableSet both = all_cables(the_case);
    if (!independent(the_case, the_case.initial, both)) {
      continue;
    }
    the_case.initial = projected(the_case, the_case.initial, both);
    const auto found = swing_ahead(the_case, the_case.initial, both, the_case.duration);
    const auto known = found ? solve(the_case, followed).swing() : std::nullopt;
    EXPECT_EQ(found.has_value(), known.has_value()) << sample;
    if (found && known) {
      ++compared;
      const double off = swing_difference(*found, *known);
      EXPECT_TRUE(off <= right_to) << sample << ": " << off << ", " << half << " m, " << width
                                   << " m, " << fall << " m, " << speed << " m/s";
      worst = std::max(worst, off);
    }
  }
  std::printf("  %d swings\n", compared);
  EXPECT_GT(compared, 300);
  expect_within("difference from the swing followed", worst, right_to);
}

// Two cables let a body be on two curves, and a curve that turns back passes a place along its
// start twice: there is a swing of the same energy there, too, with its angle from -10.9 to -9.5,
// but it is not this body's.
TEST(SwingAhead, IsNotToldOfAnotherCurveBesideThatOfTheStart) {
  Case the_case;
  the_case.body = {2.815, 0.0312};
  the_case.gravity = {-0.534, 0.437};
  the_case.initial = {{-1.1916, -0.9288}, -2.4182, {0.0378, 0.2056}, 0.382};
  for (const auto& [anchor, attachment] : {std::pair{Vec2(1.429, -1.279), Vec2(-0.184, 0.182)},
                                           std::pair{Vec2(-0.181, -1.647), Vec2(0.293, -0.313)}}) {
    the_case.cables.push_back({anchor, attachment, 0.0, 0.0});
    Cable& cable = the_case.cables.back();
    const Vec2 attached = the_case.initial.position + attachment_arm(the_case.initial, cable);
    cable.length = (attached - anchor).norm();
  }
  the_case.initial = projected(the_case, the_case.initial, all_cables(the_case));
  the_case.duration = 100.0;
  EXPECT_FALSE(swing_ahead(the_case, the_case.initial, all_cables(the_case), 100.0));
  // a cable goes slack on the way
  EXPECT_EQ(solve(the_case, told).ending(), Ending::reached_duration);
  EXPECT_GT(solve(the_case, followed).events().size(), 100U);
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

TEST(CosineSum, FindsAMaximumBetweenNodesAndAtTheEnds) {
  for (const double top : {-0.9, -0.1, 0.02, 0.5, 1.0, 1.3}) {  // of x, up to which it rises
    const auto f = [&](double x) { return 3.0 - (x - top) * (x - top); };
    std::size_t largest = 0;
    for (std::size_t k = 0; k < CosineSum::terms; ++k) {
      const auto at = [&](std::size_t node) { return f(CosineSum::nodes().cosine[node]); };
      largest = at(k) > at(largest) ? k : largest;
    }
    const double found = std::cos(sum_of(f).phase_of_maximum(largest));
    EXPECT_NEAR(f(found), f(std::min(top, 1.0)), 1e-14) << top;
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
  const auto one_infinite = [](double x) { return x > 0.998 ? infinity<double>() : 1.0; };
  EXPECT_FALSE(sum_of(one_infinite).is_known());
  EXPECT_FALSE(sum_of(one_infinite).has_no_zero());
  EXPECT_FALSE(sum_of([](double) { return 0.0; }).has_no_zero());
  EXPECT_TRUE(sum_of([](double x) { return -2.0 + x; }).has_no_zero()) << "of either sign";
}

}  // namespace
}  // namespace tautline::test
