#include <gtest/gtest.h>

#include <Eigen/LU>
#include <sstream>
#include <string>

#include "support.hpp"
#include "tautline/detail/sensitivity.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

// Derivatives against differences of whole solutions in 60 digits. With steps of 1e-20 the
// differences are right to 1e-30 or so; nothing but a wrong derivative is left to see.

namespace tautline::test {
namespace {

using Matrix = BasicStateMatrix<Multi>;

constexpr unsigned digits_used = 60;
constexpr double agreement = 1e-12;  // [-] of the largest entry: what is claimed

/// What happened, without when: solutions that share it are differentiable into each other.
std::string order_of_events(const BasicSolution<BasicCase<Multi>>& solution) {
  std::string result;
  for (const BasicEvent<BasicCase<Multi>>& event : solution.events()) {
    result += to_string(event.kind);
    for (const std::size_t index : event.cables) {
      result += ' ' + std::to_string(index);
    }
    result += '\n';
  }
  return result;
}

/// d state(time) / d initial state by central differences.
Matrix difference_quotients(const BasicCase<Multi>& the_case, const SolveOptions& options,
                            const std::string& order, const Multi& time) {
  const Multi step("1e-20");
  Matrix result;
  for (int axis = 0; axis < 6; ++axis) {
    const auto run = [&](const Multi& by) {
      BasicCase<Multi> nearby = the_case;
      BasicState<Multi>& start = nearby.initial;
      Multi* const number[] = {&start.position.x(), &start.position.y(), &start.angle,
                               &start.velocity.x(), &start.velocity.y(), &start.spin};
      *number[axis] += by;
      const auto solution = solve(nearby, options);
      EXPECT_EQ(order_of_events(solution), order) << "axis " << axis;
      const BasicState<Multi> state = solution.at(time);
      Eigen::Matrix<Multi, 6, 1> numbers;
      numbers << state.position, state.angle, state.velocity, state.spin;
      return numbers;
    };
    result.col(axis) = (run(step) - run(-step)) / (2 * step);
  }
  return result;
}

double relative(const Matrix& reached, const Matrix& expected) {
  return static_cast<double>(Multi((reached - expected).norm() / expected.norm()));
}

/// Compares at the end of `the_case`. Returns what happened up to there.
std::string expect_derivative(const std::string& what, const BasicCase<Multi>& the_case,
                              const SolveOptions& options) {
  const auto solution = solve(the_case, options);
  std::string order = order_of_events(solution);
  const Multi& time = solution.end_time();
  const BasicSensitivity<Multi> sensitivity(the_case, solution, options.law);
  expect_within(
      what, relative(sensitivity.at(time), difference_quotients(the_case, options, order, time)),
      agreement);
  return order;
}

BasicCase<Multi> table_case_until(std::string_view number, const char* duration) {
  for (auto& row : table_5_1<Multi>()) {
    if (row.number == number) {
      row.parameters.duration = Multi(duration);
      return breakwater(row.parameters, std::string(number));
    }
  }
  throw std::invalid_argument("Table 5.1 has no case " + std::string(number));
}

/// A body that a plastic cable catches, swings up on it and leaves it.
BasicCase<Multi> whip(const char* speed, const char* duration) {
  BasicCase<Multi> result;
  result.name = "whip";
  result.body = {Multi(1), Multi("0.3")};
  result.cables.push_back({BasicVec2<Multi>(Multi(0), Multi(0)),
                           BasicVec2<Multi>(Multi("0.1"), Multi("0.2")), Multi(1), Multi(0)});
  result.initial = {
      {Multi("0.5"), Multi("-0.8")}, Multi("0.1"), {Multi(speed), Multi("0.6")}, Multi("0.3")};
  result.duration = Multi(duration);
  return result;
}

bool has(const std::string& order, const std::string& event) {
  return order.find(event) != std::string::npos;
}

constexpr ImpactLaw all_laws[] = {ImpactLaw::simultaneous, ImpactLaw::poisson,
                                  ImpactLaw::sequential, ImpactLaw::energetic};

}  // namespace

TEST(PreciseSensitivity, OfImpactsAgreesWithDifferences) {
  const Digits digits(digits_used);
  for (const char* const number : {"1910121100", "1911121100", "2921121100"}) {
    expect_derivative(std::string("impacts of ") + number, table_case_until(number, "2"), {});
  }
}

TEST(PreciseSensitivity, OfAnImpactScalesVolumeByTheSquareOfRestitution) {
  const Digits digits(digits_used);
  const auto the_case = table_case_until("1910121100", "7");
  const BasicSensitivity<Multi> sensitivity(the_case, solve(the_case));
  const Multi expected = Multi(81) / 100;
  Multi worst(0);
  for (const auto& saltation : sensitivity.saltations()) {
    worst = max(worst, Multi(abs(Multi(saltation.matrix.determinant() - expected))));
  }
  EXPECT_GT(sensitivity.saltations().size(), 40U);
  expect_within("determinant - e^2", static_cast<double>(worst), 1e-50);
}

TEST(PreciseSensitivity, OfACompletedAccumulationAgreesWithDifferences) {
  const Digits digits(digits_used);
  SolveOptions options;
  options.completion.speed = 1e-6;
  const auto the_case = table_case_until("1510121100", "1.08");
  const std::string order =
      expect_derivative("accumulation and slide of 1510121100", the_case, options);
  EXPECT_TRUE(has(order, "taut 0\n") || has(order, "taut 1\n")) << order;
}

TEST(PreciseSensitivity, OfACompletedAccumulationConvergesToThatOfAllItsImpacts) {
  // both are off by the cube of the speed, times third derivatives: 70 of the state (measured in an
  // independent calculation), a few times that of its derivative
  const Digits digits(digits_used);
  const auto the_case = table_case_until("1510121100", "1.08");
  const auto derivative = [&](double speed) {
    SolveOptions options;
    options.completion.speed = speed;
    return BasicSensitivity<Multi>(the_case, solve(the_case, options)).at(the_case.duration);
  };
  const Matrix limit = derivative(1e-12);
  for (const double speed : {1e-3, 1e-5, 1e-7}) {
    std::ostringstream what;
    what << "derivative, completed at " << speed;
    expect_within(what.str(), relative(derivative(speed), limit), 500 * speed * speed * speed);
  }
}

TEST(PreciseSensitivity, OfAnImpactWhileAnotherCableIsTautAgreesWithDifferences) {
  const Digits digits(digits_used);
  for (const ImpactLaw law : all_laws) {
    SolveOptions options;
    options.law = law;
    options.completion.speed = 1e-6;
    const std::string order = expect_derivative("law " + std::to_string(static_cast<int>(law)),
                                                table_case_until("1510121100", "1.2"), options);
    EXPECT_TRUE(has(order, "impact 0 1\n")) << order;
  }
}

TEST(PreciseSensitivity, OfASwingOnTwoCablesAgreesWithDifferences) {
  const Digits digits(digits_used);
  SolveOptions options;
  options.completion.speed = 1e-4;
  const std::string order =
      expect_derivative("swing", table_case_until("1510121100", "2.5"), options);
  EXPECT_TRUE(has(order, "taut 0 1\n")) << order;
}

TEST(PreciseSensitivity, OfAReleaseAgreesWithDifferences) {
  const Digits digits(digits_used);
  const std::string released = expect_derivative("release", whip("3", "2.5"), {});
  EXPECT_TRUE(has(released, "slack 0\n")) << released;
  const std::string caught = expect_derivative("release, and caught", whip("3.5", "3.2"), {});
  EXPECT_TRUE(has(caught, "slack 0\nimpact 0\ntaut 0\n")) << caught;
}

}  // namespace tautline::test
