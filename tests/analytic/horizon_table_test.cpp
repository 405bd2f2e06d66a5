#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "support.hpp"
#include "tautline/detail/sensitivity.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/scenarios.hpp"
#include "tautline/solve.hpp"

// Horizons against an independent calculation in 70 digits: copies of the motion, 1e-30 apart, by a
// solver that integrates taut motion with a different formulation. It looked at the growth once
// every 0.0503, up to the instant from which on both cables stay taut.

namespace tautline::test {
namespace {

constexpr double tolerance = 1e-2;
constexpr double sampling = 0.0503;  // of the calculation
constexpr double none = 0.0;         // not before both cables stay taut

constexpr std::array<double, 5> local_errors = {1e-3, 1e-6, 1e-9, 1e-12, 1e-16};

/// Times at which each local error has grown to the tolerance.
struct Row {
  const char* number;
  const char* duration;  // past the last of them, or past the lock
  std::array<double, local_errors.size()> horizons;
  double rounding = 0.0055;  // half a unit of the last digit; it was rounded to three digits before
};

constexpr double one_digit = 0.055;
constexpr double for_two_cases = 0.06;  // one figure was printed for both: 15 % of it

constexpr Row rows[] = {
    {"1910121100", "8.2", {0.45, 7.95, 8.10, none, none}},
    {"2910121100", "10.2", {0.91, 5.48, 8.05, 8.95, none}},
    {"1911121100", "10.2", {0.10, 4.98, 7.70, 8.85, 9.86}},
    {"2911121100", "11.6", {0.25, 6.79, 8.80, 10.26, 11.27}},
    {"1921121100", "7.95", {0.45, 4.63, 6.84, 7.54, 7.85}},
    {"1920121100", "8.9", {1.21, 6.64, 8.35, 8.50, 8.75}},
    {"1933121100", "9.3", {0.85, 4.98, 6.59, 7.90, 9.05}},
    {"1710121100", "2.5", {0.4, none, none, none, none}, for_two_cases},
    {"1510121100", "1.5", {0.4, none, none, none, none}, for_two_cases},
    {"1110121100", "26", {0.50, 8.40, 12.07, 15.89, 25.70}},
    {"1900461100", "27", {3.62, 16.5, 22.0, 25.2, 26.5}, one_digit},
};

/// The case, its law and how far its bounces were followed, as in that calculation.
SolveOptions options_of_the_table() {
  SolveOptions options;
  options.law = ImpactLaw::sequential;
  options.completion.speed = 1e-8;
  return options;
}

template <class Real>
BasicCase<Real> case_of(const Row& row) {
  for (auto& entry : table_5_1<Real>()) {
    if (entry.number == row.number) {
      entry.parameters.duration = Real(std::stod(row.duration));
      return breakwater(entry.parameters, row.number);
    }
  }
  throw std::invalid_argument(std::string("Table 5.1 has no case ") + row.number);
}

/// When both cables are taut for the first time, or the end.
double lock_time(const BasicSolution<BasicCase<Multi>>& solution) {
  for (const auto& arc : solution.arcs()) {
    if (arc.taut.size() == 2) {
      return static_cast<double>(arc.start);
    }
  }
  return static_cast<double>(solution.end_time());
}

/// As the calculation found it: the first of its samples, `none` if none.
double sampled_horizon(const BasicSensitivity<Multi>& sensitivity, double local_error, double end) {
  for (int sample = 1; sample * sampling < end; ++sample) {
    const double time = sample * sampling;
    if (local_error * static_cast<double>(sensitivity.growth(Multi(time))) >= tolerance) {
      return time;
    }
  }
  return none;
}

class HorizonTable : public ::testing::TestWithParam<Row> {};

}  // namespace

TEST_P(HorizonTable, IsReproducedAtItsSamples) {
  const Digits digits(40);
  const auto the_case = case_of<Multi>(GetParam());
  const auto solution = solve(the_case, options_of_the_table());
  const BasicSensitivity<Multi> sensitivity(the_case, solution, ImpactLaw::sequential);
  for (std::size_t column = 0; column < local_errors.size(); ++column) {
    const double expected = GetParam().horizons[column];
    const double reached = sampled_horizon(sensitivity, local_errors[column], lock_time(solution));
    expect_within("local error " + std::to_string(-std::log10(local_errors[column])) + ", at " +
                      std::to_string(reached),
                  std::abs(reached - expected), GetParam().rounding);
  }
}

TEST_P(HorizonTable, IsMetWithinFifteenPercentOrASample) {
  const Digits digits(40);
  const auto the_case = case_of<Multi>(GetParam());
  const auto solution = solve(the_case, options_of_the_table());
  const BasicSensitivity<Multi> sensitivity(the_case, solution, ImpactLaw::sequential);
  const double lock = lock_time(solution);
  for (std::size_t column = 0; column < local_errors.size(); ++column) {
    const auto horizon = sensitivity.horizon(Multi(tolerance), Multi(local_errors[column]));
    const double reached = horizon ? std::min(lock, static_cast<double>(*horizon)) : lock;
    const double printed = GetParam().horizons[column];
    const double expected = printed == none ? lock : printed;
    // a horizon between two samples, or a growth that had gone back at the first of them
    const double allowed = std::max(0.15 * expected, sampling);
    expect_within("local error " + std::to_string(-std::log10(local_errors[column])) + ", at " +
                      std::to_string(reached),
                  std::abs(reached - expected), allowed);
  }
}

TEST_P(HorizonTable, IsKnownInDouble) {
  // ten roundings move a double solution by 1e-15 times the growth: by 1e-5 at the horizon of 1e-12
  constexpr std::size_t known = 4;
  constexpr double difference = 1e-5;  // [-]
  const Digits digits(40);
  const auto precise_case = case_of<Multi>(GetParam());
  const auto precise = solve(precise_case, options_of_the_table());
  const BasicSensitivity<Multi> expected(precise_case, precise, ImpactLaw::sequential);
  const Case the_case = case_of<double>(GetParam());
  const Solution solution = solve(the_case, {ImpactLaw::sequential, {}, 1'000'000});
  const Sensitivity reached(the_case, solution, ImpactLaw::sequential);
  const double lock = lock_time(precise);
  for (std::size_t column = 0; column < known; ++column) {
    const auto right = expected.horizon(Multi(tolerance), Multi(local_errors[column]));
    const double right_time = right ? std::min(lock, static_cast<double>(*right)) : lock;
    const double time =
        std::min(lock, reached.horizon(tolerance, local_errors[column]).value_or(lock));
    expect_within("local error " + std::to_string(-std::log10(local_errors[column])) + ", at " +
                      std::to_string(time),
                  std::abs(time - right_time) / right_time, difference);
  }
}

INSTANTIATE_TEST_SUITE_P(Table51, HorizonTable, ::testing::ValuesIn(rows),
                         [](const auto& row) { return "Case" + std::string(row.param.number); });

}  // namespace tautline::test
