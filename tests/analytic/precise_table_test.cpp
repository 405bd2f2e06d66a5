#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <vector>

#include "support.hpp"
#include "swing_table.hpp"
#include "tautline/geometry.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/settling.hpp"
#include "tautline/solve.hpp"

namespace tautline::test {
namespace {

class PreciseTable : public ::testing::TestWithParam<SwingRow> {};

BasicCase<Multi> precise_case(std::string_view number) {
  for (const auto& row : table_5_1<Multi>()) {
    if (row.number == number) {
      return breakwater(row.parameters, std::string(number));
    }
  }
  throw std::invalid_argument("Table 5.1 has no case " + std::string(number));
}

/// In 60 digits, completed from rebounds of 1e-9, the locks of the square boxes are up to 6e-5 off.
bool is_square(std::string_view number) { return number[2] == number[3]; }

TEST_P(PreciseTable, EveryPrintedDigitIsRight) {
  constexpr double last_digit = 1e-6;
  constexpr double four_digits = 0.51e-4;  // are known of these last impacts
  const SwingRow& row = GetParam();
  const Digits digits(is_square(row.number) ? 100 : 60);
  BasicCase<Multi> the_case = precise_case(row.number);
  SolveOptions options;
  options.completion.speed = 1e-12;  // 1e-9 moves the lock of 1910121101 by 3e-3
  for (const ImpactLaw law : {ImpactLaw::simultaneous, ImpactLaw::sequential}) {
    options.law = law;
    const Energies& known = law == ImpactLaw::sequential ? row.sequential : row.simultaneous;
    the_case.duration = Multi(known.lock + 0.5);
    const auto found = settling(the_case, solve(the_case, options));
    ASSERT_TRUE(found.lock.has_value() && found.lock->swing.has_value());
    EXPECT_TRUE(found.lock->permanent);
    const double lock = static_cast<double>(found.lock->time);
    const double energy = static_cast<double>(found.lock->swing->energy);
    std::cout << "  " << row.number << " lock " << lock << " swing " << energy << '\n';
    EXPECT_NEAR(energy, known.energy, 0.51e-9);
    EXPECT_NEAR(lock, known.lock, last_digit + row.loose);
    const auto& fast = found.last_impacts.at(1);  // than 1e-3
    ASSERT_TRUE(fast.time.has_value());
    EXPECT_NEAR(static_cast<double>(*fast.time), known.last,
                is_square(row.number) ? four_digits : last_digit);
    if (law == ImpactLaw::sequential) {  // the reference is the largest of many samples
      const double beyond = static_cast<double>(found.lock->swing->amplitude) - row.amplitude;
      EXPECT_GE(beyond, -0.5e-5);
      EXPECT_LE(beyond, 6e-5);
    }
  }
}

#ifdef TAUTLINE_SANITIZED
constexpr std::ptrdiff_t rows_tested = 3;  // sanitizers slow this down tenfold
#else
constexpr std::ptrdiff_t rows_tested = std::ssize(swing_table);
#endif

INSTANTIATE_TEST_SUITE_P(Table51, PreciseTable,
                         ::testing::ValuesIn(swing_table.begin(),
                                             swing_table.begin() + rows_tested),
                         [](const auto& param) {
                           return "Case" + std::string(param.param.number);
                         });

TEST(PreciseTable, ThePointMassComesToRestWhenItMust) {
  const Digits digits(60);
  BasicCase<Multi> the_case = precise_case("1900461100");
  the_case.duration = Multi(30);
  SolveOptions options;
  options.completion.speed = 1e-9;
  const auto solution = solve(the_case, options);
  EXPECT_EQ(solution.ending(), Ending::rest);
  const auto found = settling(the_case, solution);
  EXPECT_NEAR(static_cast<double>(found.lock->time), 29.2015, 0.5e-4);
  EXPECT_NEAR(static_cast<double>(*found.last_impacts[1].time), 29.1757, 0.5e-4);
}

/// The state at the end of `the_case`, its accumulations completed at `speed`, and the largest rate
/// that the last completion took away.
struct Completed {
  BasicState<Multi> end;
  double rate;
};
Completed completed(const BasicCase<Multi>& the_case, double speed) {
  SolveOptions options;
  options.completion.speed = speed;
  const auto solution = solve(the_case, options);
  const auto& last = solution.accumulations().back();
  double rate = 0.0;
  for (const auto& event : solution.events()) {
    if (event.kind == EventKind::taut && event.time == last.start) {
      for (const std::size_t index : event.cables) {
        const Multi removed = gap_rate(the_case.cables[index], event.before);
        rate = std::max(rate, std::abs(static_cast<double>(removed)));
      }
    }
  }
  return {solution.at(the_case.duration), rate};
}

/// The slope of log y over log x.
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double n = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double a = std::log(x[k]);
    const double b = std::log(y[k]);
    n += 1.0;
    sx += a;
    sy += b;
    sxx += a * a;
    sxy += a * b;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// The order with which the completed state converges, over rates from 1e-4 to 1e-9, each `ratio`
/// times the one before.
double completion_order(BasicCase<Multi> the_case, double time, double ratio) {
  the_case.duration = Multi(time);
  const auto exact = completed(the_case, 1e-14).end;
  std::vector<double> rates;
  std::vector<double> errors;
  for (double speed = 1e-4; speed > 1e-9; speed *= ratio) {
    const auto [state, rate] = completed(the_case, speed);
    const Multi change = (state.position - exact.position).norm() + abs(state.angle - exact.angle) +
                         (state.velocity - exact.velocity).norm() + abs(state.spin - exact.spin);
    rates.push_back(rate);
    errors.push_back(static_cast<double>(change));
  }
  return slope(rates, errors);
}

class CompletionOrder : public ::testing::TestWithParam<int> {};  // restitution in tenths

TEST_P(CompletionOrder, IsThreeOnOneCable) {
  const Digits digits(60);
  auto row = table_5_1<Multi>().front().parameters;
  row.e = Multi(GetParam()) / 10;
  BasicCase<Multi> the_case = breakwater(row, "one cable");
  the_case.cables.resize(1);  // the left one alone: its bounces accumulate, then it swings on it
  the_case.initial.position = {Multi(0), Multi(0)};
  the_case.initial.angle = Multi(0);
  the_case.initial.velocity = {Multi(1) / 10, Multi(1) / 20};
  const double order = completion_order(the_case, 2.0, 0.5);
  std::cout << "  order " << order << '\n';
  EXPECT_GE(order, 2.9);
  EXPECT_LE(order, 3.1);
}

TEST_P(CompletionOrder, IsThreeOnTwoCables) {
  const Digits digits(60);
  auto row = table_5_1<Multi>().front().parameters;
  row.e = Multi(GetParam()) / 10;
  row.initial = {};
  row.initial.velocity = {Multi(0), Multi(1) / 20};
  row.initial.spin = Multi(1) / 5;
  // which cable bounces last, and how high the other is then, scatters the error by a factor of
  // ten: three times as many rates as on one cable make the order sure to 0.05
  const double order = completion_order(breakwater(row, "two cables"), 6.0, 0.8);
  std::cout << "  order " << order << '\n';
  EXPECT_GE(order, 2.9);
  EXPECT_LE(order, 3.1);
}

INSTANTIATE_TEST_SUITE_P(Restitution, CompletionOrder, ::testing::Values(5, 9));

TEST(AccumulationTime, IsRightToSecondOrder) {
  // one cable off the centre: its pull changes while it bounces
  const Digits digits(60);
  auto row = table_5_1<Multi>().front().parameters;
  row.e = Multi(1) / 2;
  BasicCase<Multi> the_case = breakwater(row, "one cable");
  the_case.cables.resize(1);
  the_case.initial.position = {Multi(0), Multi(0)};
  the_case.initial.velocity = {Multi(1) / 10, Multi(1) / 20};
  the_case.duration = Multi(2);
  const auto limit = [&](double speed) {
    SolveOptions options;
    options.completion.speed = speed;
    return solve(the_case, options).accumulations().front();
  };
  const Multi exact = limit(1e-14).time;
  const auto relative = [&](double speed) {
    const auto found = limit(speed);
    EXPECT_LE(abs(found.time - exact), found.uncertainty) << "the promise, at " << speed;
    return static_cast<double>(abs(found.time - exact) / (exact - found.start));
  };
  std::vector<double> speeds;
  std::vector<double> errors;
  for (double speed = 1e-3; speed > 1e-8; speed *= 0.5) {
    speeds.push_back(speed);
    errors.push_back(relative(speed));
  }
  const double order = slope(speeds, errors);
  std::cout << "  order of the relative error " << order << '\n';
  EXPECT_GE(order, 1.9);
  EXPECT_LE(order, 2.1);
}

}  // namespace
}  // namespace tautline::test
