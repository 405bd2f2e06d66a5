#include "bench/solution/certify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tautline/scenarios.hpp"

namespace tautline::bench {
namespace {

Case standard_case() { return shipped_cases().front(); }

Certificate certificate_of(const Case& the_case, int digits = default_digits) {
  const SolveOptions options;
  return certify(the_case, options, solve(the_case, options), digits);
}

/// The last time with all of that many correct digits.
double correct_until(const Certificate& certificate, int digits) {
  for (const CorrectDigits& correct : certificate.correct) {
    if (correct.digits == digits) {
      return correct.until.value_or(std::numeric_limits<double>::infinity());
    }
  }
  ADD_FAILURE() << "nothing is said of " << digits << " digits";
  return 0.0;
}

TEST(Certify, StandardCaseIsRightToNineDigitsUntilItsBouncesAreSmall) {
  const Certificate certificate = certificate_of(standard_case());
  EXPECT_EQ(certificate.digits, 50);
  EXPECT_GT(correct_until(certificate, 9), 7.0);
  EXPECT_GE(correct_until(certificate, 6), correct_until(certificate, 9));
  EXPECT_GE(correct_until(certificate, 3), correct_until(certificate, 6));
  EXPECT_GT(certificate.events.until, 7.0);
  EXPECT_GT(certificate.events.count, 79U) << "the counted impacts alone are 79";
  EXPECT_EQ(certificate.ending, Ending::reached_duration);
}

TEST(Certify, LedgerOfTheStandardCaseHasNoResidualBeyondRounding) {
  const Case the_case = standard_case();
  const EnergyLedger in_double = energy_ledger(the_case, solve(the_case));
  const EnergyLedger in_digits = certificate_of(the_case).energy;
  EXPECT_LT(std::abs(in_double.residual), 1e-14);
  EXPECT_LT(std::abs(in_digits.residual), 1e-45);
  EXPECT_NE(in_digits.residual, 0.0) << "not of 50 digits";
  EXPECT_NEAR(in_digits.end, 0.019679140, 1e-8);  // with 60 digits
  EXPECT_NEAR(in_double.end, in_digits.end, 1e-8);
  EXPECT_LT(in_digits.completions, in_double.completions) << "followed further";
}

TEST(Certify, SaysWhatTheStandardCaseSettlesInto) {
  const Settling settling = certificate_of(standard_case()).settling;
  ASSERT_TRUE(settling.lock && settling.lock->swing);
  // the lock of the chapter's decimals is at 8.1288076; rounding them to doubles moves it by 1.7e-4
  EXPECT_NEAR(settling.lock->time, 8.1288076, 3e-4);
  EXPECT_TRUE(settling.lock->permanent);
  EXPECT_NEAR(settling.lock->swing->energy, 0.0196791403, 1e-10);
  EXPECT_NEAR(settling.lock->swing->amplitude, 0.650266, 1e-6);
  ASSERT_EQ(settling.last_impacts.size(), 2U);
  EXPECT_NEAR(*settling.last_impacts[1].time, 8.114010, 1e-6);
}

TEST(Certify, BouncingBallIsRightToTheEnd) {
  for (const double restitution : {0.5, 0.0, 1.0}) {
    const Certificate certificate = certificate_of(bouncing_ball(restitution));
    for (const CorrectDigits& correct : certificate.correct) {
      EXPECT_FALSE(correct.until) << restitution << ": " << correct.digits << " digits until "
                                  << *correct.until;
    }
    EXPECT_TRUE(certificate.events.all) << restitution;
  }
  EXPECT_GT(certificate_of(bouncing_ball(0.5)).event_count,
            solve(bouncing_ball(0.5)).events().size())
      << "the bounces are followed no further than in double";
}

/// A solution that is right up to 1, and from its first impact there on that of a ball which
/// rebounds less.
TEST(Certify, FindsWhereAWrongSolutionLeavesTheRightOne) {
  const Case ball = bouncing_ball(0.5);
  const double less = 1e-4;
  const Certificate certificate =
      certify(ball, {}, solve(bouncing_ball(0.5 - less)), default_digits);
  // the rebound from speed 1 is wrong by 1e-4 at once: three digits of velocity are still right
  EXPECT_NEAR(correct_until(certificate, 9), 1.0, 1e-9);
  EXPECT_NEAR(correct_until(certificate, 6), 1.0, 1e-9);
  EXPECT_GT(correct_until(certificate, 3), 1.0 + 1e-9);
  // a shift is seen from the start
  Case shifted = ball;
  shifted.initial.position.x() += 1e-7;
  const Certificate from_the_start = certify(ball, {}, solve(shifted), default_digits);
  EXPECT_EQ(correct_until(from_the_start, 9), 0.0);
  EXPECT_GT(correct_until(from_the_start, 6), 1.0);
}

TEST(Certify, NamesTheFirstEventThatDiffers) {
  Case ball = bouncing_ball(0.5);
  Case shorter = ball;
  shorter.duration = 2.2;  // between the second impact and the third, at 2.5
  const Certificate certificate = certify(ball, {}, solve(shorter), default_digits);
  EXPECT_FALSE(certificate.events.all);
  EXPECT_EQ(certificate.events.count, 2U);
  EXPECT_DOUBLE_EQ(certificate.events.until, 2.0);
  EXPECT_FALSE(certificate.events.in_double);
  ASSERT_TRUE(certificate.events.in_digits);
  EXPECT_DOUBLE_EQ(certificate.events.in_digits->time, 2.5);
  EXPECT_EQ(certificate.events.in_digits->kind, EventKind::impact);
}

TEST(Certify, MoreDigitsSayTheSame) {
  const Certificate few = certificate_of(standard_case(), 30);
  const Certificate many = certificate_of(standard_case(), 60);
  EXPECT_NEAR(correct_until(few, 9), correct_until(many, 9), 1e-9);
  EXPECT_EQ(few.events.count, many.events.count);
  EXPECT_NEAR(few.settling.lock->time, many.settling.lock->time, 1e-8);
  EXPECT_GT(std::abs(few.energy.residual), std::abs(many.energy.residual));
}

TEST(Certify, DigitsOutOfRangeAreRefusedWithTheRange) {
  EXPECT_FALSE(digits_problem(least_digits));
  EXPECT_FALSE(digits_problem(most_digits));
  EXPECT_EQ(digits_problem(least_digits - 1), "--digits 19: must be 20 to 1000");
  EXPECT_EQ(digits_problem(most_digits + 1), "--digits 1001: must be 20 to 1000");
}

}  // namespace
}  // namespace tautline::bench
