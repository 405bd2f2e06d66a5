// What `tautline solve` prints: no digit is wrong, and few right ones are held back.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/cases/literals.hpp"
#include "bench/solution/in_digits.hpp"
#include "bench/solution/many_digits.hpp"
#include "bench/solution/right_digits.hpp"
#include "bench/solution/texts.hpp"
#include "tautline/case_file.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"
#include "tests/analytic/support.hpp"

namespace tautline::bench {
namespace {

/// How many random systems are drawn: more with TAUTLINE_DIGIT_SYSTEMS in the environment, of which
/// 2000 take some minutes, and then all cases of Table 5.1 too.
constexpr int few_systems = 60;
int systems() {
  const char* const wanted = std::getenv("TAUTLINE_DIGIT_SYSTEMS");
  return wanted != nullptr ? std::atoi(wanted) : few_systems;
}

/// Decimal digits of the truth: 100 where time does not matter; what a double has left is far above
/// the rounding of 50 in these systems, too.
unsigned true_digits() { return systems() > few_systems ? 100 : 50; }

/// What completing the accumulations of the truth leaves [-].
constexpr double true_completion = 1e-26;

/// Counts digits that are printed against those that are right.
struct DigitCount {
  long printed = 0;
  long right = 0;
  long wrong = 0;

  /// A number that is shown with at most `most` digits after the point.
  void add(double value, double error, const Multi& truth, int most, const std::string& what) {
    const std::string shown = right_fixed(value, error, most);
    int good = most;
    while (good >= 0 && fixed_digits(value, good) != fixed_digits(truth, good)) {
      --good;
    }
    right += good + 1;
    if (shown == dash) {
      return;
    }
    const std::size_t point = shown.find('.');
    const int after = point == std::string::npos ? 0 : static_cast<int>(shown.size() - point) - 1;
    printed += std::min(after, good) + 1;
    if (shown != fixed_digits(truth, after)) {
      ++wrong;
      ADD_FAILURE() << what << " is printed " << shown << ", is " << truth.str(20) << " (double "
                    << value << " +- " << error << ")";
    }
  }

  void add(const State& value, const State& error, const BasicState<Multi>& truth, int most,
           const std::string& what) {
    add(value.position.x(), error.position.x(), truth.position.x(), most, what + " x");
    add(value.position.y(), error.position.y(), truth.position.y(), most, what + " y");
    add(value.angle, error.angle, truth.angle, most, what + " angle");
    add(value.velocity.x(), error.velocity.x(), truth.velocity.x(), most, what + " vx");
    add(value.velocity.y(), error.velocity.y(), truth.velocity.y(), most, what + " vy");
    add(value.spin, error.spin, truth.spin, most, what + " spin");
  }
};

/// The events in order as long as both have the same, and samples everywhere.
void count_digits(const Case& the_case, DigitCount& count) {
  const Solution solution = solve(the_case);
  const Uncertainty uncertainty(the_case, solution);
  const tautline::Digits precision(true_digits());
  SolveOptions sharper;
  sharper.completion.error = true_completion;
  const BasicSolution<BasicCase<Multi>> truth = solve(in_digits(the_case), sharper);
  constexpr int time_digits = 12;  // as in the table of events
  constexpr int state_digits = 6;
  const std::size_t common = std::min(solution.events().size(), truth.events().size());
  for (std::size_t index = 0; index < common; ++index) {
    const Event& event = solution.events()[index];
    const BasicEvent<BasicCase<Multi>>& other = truth.events()[index];
    const auto& errors = uncertainty.events()[index];
    if (event.kind != other.kind || event.cables != other.cables) {
      break;  // an accumulation that is followed further, or the horizon
    }
    if (errors && event.kind != EventKind::taut) {
      const std::string what = the_case.name + ": event " + std::to_string(index);
      count.add(event.time, errors->time, other.time, time_digits, what + " time");
      count.add(event.after, errors->after, other.after, state_digits, what);
    }
  }
  constexpr int samples = 50;
  const double end = std::min(solution.end_time(), static_cast<double>(truth.end_time()));
  for (int sample = 1; sample < samples; ++sample) {
    const double time = end * sample / samples;
    if (const auto errors = uncertainty.at(time)) {
      count.add(solution.at(time), *errors, truth.at(Multi(time)), time_digits,
                the_case.name + ": t = " + std::to_string(time));
    }
  }
}

constexpr std::uint64_t digit_seed = 14;

/// The next of the random systems, of which `system` have been drawn.
Case next_case(tautline::test::Random& random, int system) {
  tautline::test::Draw draw;
  draw.cables = 1 + static_cast<std::size_t>(system % 3);
  Case the_case = tautline::test::random_case(random, draw);
  the_case.name = "system " + std::to_string(system) + " of seed " + std::to_string(digit_seed);
  return the_case;
}

TEST(Digits, NoneIsWrongAndFourOfFiveRightOnesArePrinted) {
  tautline::test::Random random(digit_seed);
  DigitCount count;
  for (int system = 0; system < systems(); ++system) {
    count_digits(next_case(random, system), count);
  }
  std::printf("%ld digits printed, %ld right, %ld numbers wrong\n", count.printed, count.right,
              count.wrong);
  EXPECT_EQ(count.wrong, 0);
  EXPECT_GE(static_cast<double>(count.printed), 0.8 * static_cast<double>(count.right));
}

// Two cables hit in turn at intervals that fall as squares, below what a double tells apart, while
// the impulses fall by a sixth: doubles resolve what is left at once, and so do all neighbours.
TEST(Digits, WhereRoundingMergesImpactsNeighboursDoNotMakeThemSure) {
  tautline::test::Random random(digit_seed);
  DigitCount count;
  for (int system = 0; system <= 1481; ++system) {
    const Case the_case = next_case(random, system);
    if (system == 851 || system == 1481) {
      count_digits(the_case, count);
    }
  }
  EXPECT_EQ(count.wrong, 0);
}

TEST(Digits, StandardCaseIsPrintedRightToTwiceItsHorizon) {
  DigitCount count;
  count_digits(shipped_cases().front(), count);  // to t = 20; its horizon is near 8.1
  std::printf("%ld digits printed, %ld right, %ld numbers wrong\n", count.printed, count.right,
              count.wrong);
  EXPECT_EQ(count.wrong, 0);
  EXPECT_GE(static_cast<double>(count.printed), 0.8 * static_cast<double>(count.right));
}

TEST(Digits, EveryCaseOfTheTableIsPrintedRight) {
  // all take a minute: TAUTLINE_DIGIT_SYSTEMS=2000 asks for them
  const std::size_t stride = systems() <= few_systems ? 10 : 1;
  DigitCount count;
  std::size_t cases = 0;
  for (const Case& the_case : shipped_cases()) {
    if (the_case.name.starts_with("breakwater/") && cases++ % stride == 0) {
      count_digits(the_case, count);
    }
  }
  EXPECT_EQ(count.wrong, 0);
  EXPECT_GE(static_cast<double>(count.printed), 0.8 * static_cast<double>(count.right));
}

TEST(Digits, StandardCaseLocksAtItsTimeToTwelveDigits) {
  const Case the_case = shipped_cases().front();
  const Solution solution = solve(the_case);
  const std::string doubles =
      many_digits_text(the_case, {}, solution, {12, false, false, {}}, unlimited);
  // 8.1286365121677143 by independent code with 60 digits that follows 614 bounces of cable 1 to
  // their end, the slide on it, and 281 bounces of cable 0 beside it
  EXPECT_NE(doubles.find("Cables 0 and 1 stay taut from t = 8.12863651217 on"), std::string::npos)
      << doubles;
  const std::string decimals =
      many_digits_text(the_case, {}, solution, {7, true, false, {}}, unlimited);
  // of the decimals of Table 5.1, as independent code with 60 digits says
  EXPECT_NE(decimals.find("taut from t = 8.128808 on"), std::string::npos) << decimals;
}

TEST(Digits, DecimalsAreReadWithAllTheirDigits) {
  const std::string file = R"(name = "long"
duration = 2
gravity = [0, -2.0]
body = { mass = 1, inertia = 0 }
cables = [{ anchor = [0, 0], attachment = [0, 0], length = 2.000_000000000000001, restitution = 0 }]
initial = { position = [0, -1] }
)";
  const CaseReading read = read_case_text(file, "long.toml");
  ASSERT_TRUE(read.the_case) << read.problems.front();
  const std::string text = many_digits_text(*read.the_case, {}, solve(*read.the_case),
                                            {20, true, false, literals(file)}, unlimited);
  // it falls by 1 + 1e-18 in the root of that
  EXPECT_NE(text.find("1.0000000000000000005"), std::string::npos) << text;
}

TEST(Digits, WhatIsPrintedIsWhatBothEndsOfTheErrorRoundTo) {
  EXPECT_EQ(right_fixed(8.129857, 1.3e-3, 6), "8.13");
  EXPECT_EQ(right_fixed(0.25, 0.0, 3), "0.250");
  EXPECT_EQ(right_fixed(0.96, 0.6, 6), dash);
  EXPECT_EQ(right_fixed(1.0, -1.0, 6), dash) << "nothing is known";
  EXPECT_EQ(right_fixed(-1e-9, 1e-10, 4), "0.0000");
  EXPECT_EQ(right_scientific(2.516891e-1, 1e-5, 6), "2.517e-01");
  EXPECT_EQ(right_general(0.125, 1e-17, 6), "0.125");
}

TEST(Digits, ManyDigitsAreRoundedAsDoublesAre) {
  EXPECT_EQ(fixed_digits(Multi("0.0488"), 0), "0");
  EXPECT_EQ(fixed_digits(Multi("-0.6"), 0), "-1");
  EXPECT_EQ(fixed_digits(Multi("-0.00967"), 1), "0.0");
  EXPECT_EQ(fixed_digits(Multi("5.3e-15"), 12), "0.000000000000");
  EXPECT_EQ(scientific_digits(Multi("5.36e-15"), 0), "5e-15");
}

TEST(Digits, AnImpactOnMirroredCablesIsSureAndAnAlmostMirroredOneIsOpen) {
  const std::vector<Case> cases = shipped_cases();
  Case beam = *std::find_if(cases.begin(), cases.end(),
                            [](const Case& one) { return one.name == "level-beam"; });
  const Solution solution = solve(beam);
  ASSERT_EQ(solution.events().front().cables.size(), 2U);
  EXPECT_FALSE(Uncertainty(beam, solution).horizon());
  Case beside = beam;  // to both sides alike only as far as differences are rounded
  beside.initial.position.x() = 0.1;
  beside.cables[0].anchor.x() = -2.9;
  beside.cables[1].anchor.x() = 3.1;
  const Solution shifted = solve(beside);
  EXPECT_TRUE(Uncertainty(beside, shifted).horizon());
  beam.gravity.x() = 1e-15;  // less than the instants of both impacts can tell
  const Solution almost = solve(beam);
  ASSERT_EQ(almost.events().front().cables.size(), 2U);
  const auto horizon = Uncertainty(beam, almost).horizon();
  ASSERT_TRUE(horizon) << "which cable is first decides all that follows";
  EXPECT_NEAR(*horizon, almost.events().front().time, 1e-9) << "the fall is sure";
  EXPECT_LE(*horizon, almost.events().front().time);
}

TEST(Digits, AMotionThatStartsOnATautCableHasBounds) {
  Case hung;
  hung.name = "hung";
  hung.duration = 5.0;
  hung.gravity = {0.0, -1.0};
  hung.body = {1.0, 0.1};
  hung.cables = {{{0.0, 0.0}, {0.0, 0.5}, 1.0, 0.5}};
  hung.initial.position = {0.0, -1.5};
  for (const double push : {0.0, 0.1}) {
    hung.initial.velocity.x() = push;
    const Solution solution = solve(hung);
    const auto errors = Uncertainty(hung, solution).at(4.0);
    ASSERT_TRUE(errors) << "pushed by " << push;
    EXPECT_LT(errors->position.norm(), 1e-12);
  }
  hung.initial.velocity.x() = 0.0;
  hung.cables[0].attachment.y() = -0.5;  // below its centre
  hung.initial.position.y() = -0.5;
  const Solution unstable = solve(hung);
  EXPECT_EQ(unstable.ending(), Ending::unstable_rest);
  EXPECT_TRUE(Uncertainty(hung, unstable).at(0.0));
}

/// A pendulum of 1.25 m, of two parallel cables or of one and a point mass: 3, 4 and 5 are exact.
Case exact_pendulum(bool parallel) {
  Case result;
  result.name = parallel ? "two parallel cables" : "one cable";
  result.gravity = {0.0, -9.81};
  result.body = {1.0, parallel ? 0.125 : 0.0};
  result.initial.position = {0.75, 0.0};
  result.cables = {{{0.0, 1.0}, {0.0, 0.0}, 1.25, 0.5}};
  if (parallel) {
    result.cables = {{{-0.5, 1.0}, {-0.5, 0.0}, 1.25, 0.5}, {{0.5, 1.0}, {0.5, 0.0}, 1.25, 0.5}};
  }
  return result;
}

// of period 4 K(sin(a / 2)) sqrt(L / g), by the arithmetic-geometric mean in 40 digits
TEST(Digits, ASwingFromTheStartHasItsPeriod) {
  Case swing = exact_pendulum(true);
  swing.duration = 20.0;
  const Solution solution = solve(swing);
  const std::string text = many_digits_text(swing, {}, solution, {15, false, false, {}}, unlimited);
  EXPECT_NE(text.find("period 2.30231329089341"), std::string::npos) << text;
  const std::string doubles =
      solution_text(swing, solution, settling(swing, solution), Uncertainty(swing, solution));
  EXPECT_NE(doubles.find("Cable 0 swings with amplitude 0.643501 rad"), doubles.npos) << doubles;
}

// an error of the period comes again with it, some 650 times
TEST(Digits, ASwingThatComesAgainForLongStaysWithinItsBounds) {
  std::vector<Case> swings = {exact_pendulum(true), exact_pendulum(false)};
  for (const char* const number : {"1510121100", "1710121100"}) {
    swings.push_back(tautline::test::table_case(number));
  }
  for (Case& swing : swings) {
    swing.duration = 1500.0;
    const Solution solution = solve(swing);
    ASSERT_TRUE(solution.repetition()) << swing.name;
    const Uncertainty uncertainty(swing, solution);
    const tautline::Digits precision(40);
    SolveOptions sharper;
    sharper.completion.error = true_completion;
    const BasicSolution<BasicCase<Multi>> truth = solve(in_digits(swing), sharper);
    double worst = 0.0;   // error, as a part of its bound
    double widest = 0.0;  // bound [m]
    for (int sample = 1; sample < 400; ++sample) {
      const double time = swing.duration * sample / 400;
      const auto bounds = uncertainty.at(time);
      ASSERT_TRUE(bounds) << swing.name << " at " << time;
      const auto right = truth.at(Multi(time));
      const Vec2 found = solution.at(time).position;
      for (const Eigen::Index axis : {0, 1}) {
        const auto error = static_cast<double>(abs(Multi(right.position[axis] - found[axis])));
        worst = std::max(worst, error / bounds->position[axis]);
        widest = std::max(widest, bounds->position[axis]);
      }
    }
    std::printf("%s: errors up to %.2f of their bounds, which are up to %.1e m\n",
                swing.name.c_str(), worst, widest);
    EXPECT_LE(worst, 1.0) << swing.name;
    if (solution.accumulations().empty()) {  // else the doubt of their end grows with time
      EXPECT_LE(widest, 1e-10) << swing.name;
    }
  }
}

// each start one rounding from the case's may be the one that the decimals mean
TEST(Digits, LocksOfStartsARoundingApartLieWithinWhatIsSaidOfEach) {
  tautline::test::Random random(digit_seed);
  for (const char* const number : {"1910121100", "19101211050", "1910121110"}) {
    std::vector<double> locks;
    std::vector<double> bounds;
    for (int start = 0; start < 100; ++start) {
      Case the_case = tautline::test::table_case(number);
      the_case.initial.position *= 1.0 + std::floor(random.uniform(-1.0, 2.0)) * epsilon<double>();
      the_case.initial.angle *= 1.0 + std::floor(random.uniform(-1.0, 2.0)) * epsilon<double>();
      const Solution solution = solve(the_case);
      const auto lock = last_lock(the_case, solution);
      const auto bound = Uncertainty(the_case, solution).lock();
      ASSERT_TRUE(lock && bound) << number;
      locks.push_back(lock->time);
      bounds.push_back(*bound);
    }
    const auto [first, last] = std::minmax_element(locks.begin(), locks.end());
    for (std::size_t start = 0; start < locks.size(); ++start) {
      EXPECT_LE(std::max(*last - locks[start], locks[start] - *first), bounds[start]) << number;
    }
    EXPECT_LE(*std::max_element(bounds.begin(), bounds.end()), 0.03) << number << " [s]";
  }
}

TEST(Digits, AFileIsReadWhateverTheNameOfItsCase) {
  const std::string file = R"(name = "breakwater/1910121100"
duration = 1.5
gravity = [0, -2.0]
body = { mass = 1, inertia = 0 }
cables = [{ anchor = [0, 0], attachment = [0, 0], length = 2, restitution = 0.5 }]
initial = { position = [0, -1] }
)";
  const CaseReading read = read_case_text(file, "own.toml");
  ASSERT_TRUE(read.the_case) << read.problems.front();
  const std::string text = many_digits_text(*read.the_case, {}, solve(*read.the_case),
                                            {6, true, false, literals(file)}, unlimited);
  EXPECT_NE(text.find("t = 1.000000;"), std::string::npos) << text;
}

TEST(Digits, RestIsSaidFromTheEndOfTheBouncesOn) {
  const std::vector<Case> cases = shipped_cases();
  Case ball = *std::find_if(cases.begin(), cases.end(),
                            [](const Case& one) { return one.name == "bouncing-ball"; });
  const auto text = [&](double until) {
    ball.duration = until;
    const Solution solution = solve(ball);
    return solution_text(ball, solution, settling(ball, solution), Uncertainty(ball, solution));
  };
  EXPECT_NE(text(4.0).find("at rest from t = 3.0000000"), std::string::npos) << text(4.0);
  EXPECT_NE(text(2.9999999999).find("during the last bounces"), std::string::npos);
}

TEST(Digits, EventsBeyondTheHorizonAreOneRow) {
  const Case the_case = shipped_cases().front();
  const Solution solution = solve(the_case);
  const Uncertainty uncertainty(the_case, solution);
  ASSERT_TRUE(uncertainty.horizon());
  const std::string text = events_text(the_case, solution, uncertainty, true, unlimited);
  const std::string row = "beyond the horizon: one of many motions";
  EXPECT_NE(text.find(row), std::string::npos);
  EXPECT_EQ(text.find(row), text.rfind(row));
  EXPECT_EQ(text.find("-0.0000000"), std::string::npos);
}

}  // namespace
}  // namespace tautline::bench
