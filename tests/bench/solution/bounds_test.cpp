// What is said of the errors of a solution: bounds and words.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "bench/solution/in_digits.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/geometry.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"
#include "tests/analytic/support.hpp"

namespace tautline::bench {
namespace {

constexpr std::uint64_t seed = 14;

/// A body on one long cable that it meets nearly along an axis: the gap is a difference of numbers
/// that are large against the body's way.
Case long_cable(tautline::test::Random& random) {
  Case result;
  const double far = std::pow(10.0, random.uniform(0.5, 3.5));  // [m]
  const double aside = far * std::pow(10.0, random.uniform(-6.0, -1.0));
  const double axis = std::floor(random.uniform(0.0, 4.0)) * (std::numbers::pi / 2.0);
  const auto turned = [&](double along, double across) {
    return Vec2(along * std::round(std::cos(axis)) - across * std::round(std::sin(axis)),
                along * std::round(std::sin(axis)) + across * std::round(std::cos(axis)));
  };
  const bool is_point = random.uniform(0.0, 1.0) < 0.3;
  result.name = fmt::format("anchor {} m away, {} aside, axis {}", far, aside, axis);
  result.duration = 2.0;
  result.body = {random.uniform(0.5, 2.0), is_point ? 0.0 : random.uniform(0.01, 0.1)};
  result.gravity = turned(-1.0, random.uniform(-0.1, 0.1));
  result.cables = {
      {turned(far, aside),
       is_point ? Vec2(0.0, 0.0) : Vec2{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)}, 1.0,
       random.uniform(0.0, 1.0)}};
  Cable& cable = result.cables[0];
  cable.length =
      (cable.anchor - cable.attachment).norm() + random.uniform(0.05, 0.3);  // starts slack
  const double nearing = random.uniform(-1.0, 0.0);
  result.initial.velocity = turned(nearing, random.uniform(-0.1, 0.1));
  result.initial.spin = is_point ? 0.0 : random.uniform(-0.5, 0.5);
  return result;
}

TEST(Bounds, TheFirstImpactOnALongCableAlongAnAxisIsWithinItsBounds) {
  tautline::test::Random random(seed);
  double worst = 0.0;  // error, as a part of its bound
  const int count = 200;
  for (int system = 0; system < count; ++system) {
    const Case the_case = long_cable(random);
    const Solution solution = solve(the_case);
    const Uncertainty uncertainty(the_case, solution);
    ASSERT_FALSE(solution.events().empty()) << the_case.name;
    const auto& errors = uncertainty.events().front();
    ASSERT_TRUE(errors) << the_case.name;
    const tautline::Digits precision(50);
    const BasicSolution<BasicCase<Multi>> truth = solve(in_digits(the_case));
    const auto check = [&](double value, double bound, const Multi& right, const char* what) {
      const auto error = static_cast<double>(abs(Multi(right - value)));
      EXPECT_LE(error, bound) << what << " of " << the_case.name;
      worst = std::max(worst, error / bound);
    };
    const auto& shown = solution.events().front();
    const auto& right = truth.events().front();
    check(shown.time, errors->time, right.time, "time");
    check(shown.before.position.x(), errors->before.position.x(), right.before.position.x(), "x");
    check(shown.before.position.y(), errors->before.position.y(), right.before.position.y(), "y");
    check(shown.after.position.x(), errors->after.position.x(), right.after.position.x(), "x");
    check(shown.after.position.y(), errors->after.position.y(), right.after.position.y(), "y");
    check(shown.after.velocity.x(), errors->after.velocity.x(), right.after.velocity.x(), "vx");
    check(shown.after.velocity.y(), errors->after.velocity.y(), right.after.velocity.y(), "vy");
    check(shown.after.angle, errors->after.angle, right.after.angle, "angle");
    check(shown.after.spin, errors->after.spin, right.after.spin, "spin");
  }
  std::printf("errors up to %.2f of their bounds\n", worst);
  EXPECT_GE(worst, 0.02) << "bounds far too wide say nothing";
}

TEST(Bounds, ANumberWithoutARightDigitIsSaidInWords) {
  EXPECT_EQ(number_in_words(0.25, 0.0, 6), "0.25");
  EXPECT_EQ(number_in_words(1e-16, 2e-16, 6), "0 to within 3e-16");
  EXPECT_EQ(number_in_words(0.96, 0.61, 6), "1.0 to within 7e-01");
  EXPECT_EQ(number_in_words(1.0, -1.0, 6), "beyond the horizon");
}

// a sentence must not end with "0 at the start, - at the end"
TEST(Bounds, NoSentenceHasADashForAValue) {
  tautline::test::Random random(seed);
  std::vector<Case> cases = shipped_cases();
  for (int system = 0; system < 60; ++system) {
    tautline::test::Draw draw;
    draw.cables = 1 + static_cast<std::size_t>(system % 3);
    cases.push_back(tautline::test::random_case(random, draw));
  }
  Case still;  // at the height where its energy is 0
  still.gravity = {0.0, -9.81};
  still.cables = {{{0.0, 1.0}, {0.0, 0.0}, 1.25, 0.5}};
  still.body = {1.0, 0.0};
  still.initial.position = {0.75, 0.0};
  still.initial.velocity = {0.0, -1.0};
  cases.push_back(still);
  for (const Case& the_case : cases) {
    SolveOptions options;
    options.max_events = 2'000;
    const Solution solution = solve(the_case, options);
    const std::string text = solution_text(the_case, solution, settling(the_case, solution),
                                           Uncertainty(the_case, solution, options));
    EXPECT_EQ(text.find(dash), std::string::npos) << the_case.name << "\n" << text;
  }
}

/// A level bar of 2 kg that drops by 0.5 m into equal slings at these places [m].
Case bar_in_slings(const std::vector<double>& places, double restitution, double centre = 0.0) {
  Case result;
  result.name = "slings";
  result.duration = 6.0;
  result.body = {2.0, 0.5};
  for (const double place : places) {
    result.cables.push_back({{place, 0.0}, {place - centre, 0.0}, 1.0, restitution});
  }
  result.initial.position = {centre, -0.5};
  return result;
}

std::string text_of(const Case& the_case) {
  const Solution solution = solve(the_case);
  return solution_text(the_case, solution, settling(the_case, solution),
                       Uncertainty(the_case, solution));
}

// impulses (1 + e) m v in all, at v = 1; no moment about the centre; the sum of squares is least
TEST(RedundantSlings, MoveSurelyAndShareTheirImpulseByTheLeastSquares) {
  struct Expected {
    std::vector<double> places;
    double centre;
    std::vector<double> parts;  // of the impulse
  };
  const std::vector<Expected> all = {
      {{-0.5, 0.0, 0.5}, 0.0, {1.0 / 3, 1.0 / 3, 1.0 / 3}},
      {{-0.75, -0.25, 0.25, 0.75}, 0.0, {0.25, 0.25, 0.25, 0.25}},
      {{-0.5, 0.25, 0.5}, 0.0, {11.0 / 26, 8.0 / 26, 7.0 / 26}},
      {{-0.5, 0.0, 0.5}, 0.25, {1.0 / 12, 4.0 / 12, 7.0 / 12}},
  };
  for (const Expected& one : all) {
    for (const double e : {0.0, 0.3, 0.5, 1.0}) {
      const Case the_case = bar_in_slings(one.places, e, one.centre);
      const Solution solution = solve(the_case);
      const Uncertainty uncertainty(the_case, solution);
      EXPECT_FALSE(uncertainty.horizon()) << one.places.size() << " slings, e = " << e;
      const Event& first = solution.events().front();
      const auto& errors = uncertainty.events().front();
      ASSERT_TRUE(errors);
      EXPECT_LE(std::abs(first.time - 1.0), errors->time);
      EXPECT_LE(std::abs(first.after.velocity.y() - e), errors->after.velocity.y());
      EXPECT_EQ(errors->indeterminate, first.cables);
      EXPECT_EQ(indeterminate(ImpactLaw::simultaneous, the_case, first), first.cables);
      for (std::size_t index = 0; index < one.parts.size(); ++index) {
        const auto row = static_cast<Eigen::Index>(index);
        EXPECT_LE(std::abs(first.impulses[row] - 2.0 * (1.0 + e) * one.parts[index]),
                  errors->impulses[row]);
        EXPECT_LE(errors->impulses[row], 1e-12);
      }
      const auto end = uncertainty.at(solution.end_time());
      ASSERT_TRUE(end);
      EXPECT_LE(end->position.norm(), 1e-11);
      EXPECT_NE(text_of(the_case).find("indeterminate"), std::string::npos);
    }
  }
}

TEST(RedundantSlings, AtAnAngleOrInOneLineAreSureToo) {
  Case angled;  // 3, 4 and 5 are exact: all become taut at y = -4
  angled.duration = 8.0;
  angled.body = {1.0, 0.25};
  angled.cables = {{{-3.5, 0.0}, {-0.5, 0.0}, 5.0, 0.5},
                   {{0.0, 0.0}, {0.0, 0.0}, 4.0, 0.5},
                   {{3.5, 0.0}, {0.5, 0.0}, 5.0, 0.5}};
  angled.initial.position = {0.0, -3.0};
  Case line;  // a point on two cables in one line
  line.duration = 8.0;
  line.gravity = {0.0, -9.81};
  line.body = {1.0, 0.0};
  line.cables = {{{0.0, 0.0}, {0.0, 0.0}, 2.0, 0.5}, {{0.0, 1.0}, {0.0, 0.0}, 3.0, 0.5}};
  line.initial.position = {0.0, -1.0};
  for (const Case& the_case : {angled, line}) {
    const Solution solution = solve(the_case);
    const Uncertainty uncertainty(the_case, solution);
    EXPECT_FALSE(uncertainty.horizon());
    const Event& first = solution.events().front();
    EXPECT_EQ(first.cables, CableSet::first(the_case.cables.size()));
    EXPECT_EQ(indeterminate(ImpactLaw::simultaneous, the_case, first), first.cables);
    // z_i in proportion to how far cable i pulls up
    double up = 0.0;
    for (const std::size_t index : first.cables) {
      up += std::pow(gap_gradient(the_case.cables[index], first.before).y(), 2);
    }
    Eigen::Index row = 0;
    const double jump = the_case.body.mass * 1.5 * -first.before.velocity.y();
    for (const std::size_t index : first.cables) {
      const double pull = gap_gradient(the_case.cables[index], first.before).y();
      EXPECT_NEAR(first.impulses[row++], jump * pull / up, 1e-14 * jump);
    }
  }
}

TEST(RedundantSlings, OneThatIsLongerByARoundingIsATieInDoubles) {
  Case the_case = bar_in_slings({-0.5, 0.0, 0.5}, 0.5);
  the_case.cables[2].length = std::nextafter(1.0, 2.0);
  const Solution solution = solve(the_case);
  const Uncertainty uncertainty(the_case, solution);
  ASSERT_TRUE(uncertainty.horizon());
  const auto& tie = uncertainty.unsure().front().tie;
  ASSERT_TRUE(tie);
  EXPECT_EQ(tie->kind, EventKind::impact);
  EXPECT_NE(text_of(the_case).find("is hit first (a tie)"), std::string::npos);
}

}  // namespace
}  // namespace tautline::bench
