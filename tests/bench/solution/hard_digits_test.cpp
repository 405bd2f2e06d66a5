// What is said of hard systems is true: held against the same systems in many digits.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "bench/solution/in_digits.hpp"
#include "hard/hard_families.hpp"
#include "tautline/multiprecision.hpp"
#include "tautline/solve.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {
namespace {

/// How many systems of each family: more with TAUTLINE_HARD_DIGITS in the environment.
int systems_of_a_family() {
  const char* const wanted = std::getenv("TAUTLINE_HARD_DIGITS");
  return wanted != nullptr ? std::atoi(wanted) : 3;
}

/// So many events and steps are compared: what comes later is beyond most horizons, and many digits
/// take a thousand times as long as doubles.
constexpr std::size_t most_events = 400;
constexpr std::size_t most_steps = 2'000;

/// Decimal digits: enough that the truth's own rounding, times what a system makes of it, is below
/// that of a double in every family.
constexpr unsigned hard_digits = 80;
constexpr double hard_completion = 1e-26;  // what completing its accumulations leaves [-]

/// Numbers that are said with a bound of their error, and by how much the worst lies outside.
struct Bounds {
  long numbers = 0;
  long outside = 0;
  double widest_use = 0.0;  // the largest error in parts of its bound [-]

  void add(double value, double bound, const Multi& truth, const std::string& what) {
    const auto error = std::abs(static_cast<double>(Multi(value - truth)));
    ++numbers;
    widest_use = bound > 0.0 ? std::max(widest_use, error / bound) : widest_use;
    if (!(error <= bound)) {
      ++outside;
      ADD_FAILURE() << what << " is " << truth.str(20) << ", said to be " << value << " +- "
                    << bound;
    }
  }
  void add(const State& value, const State& bound, const BasicState<Multi>& truth,
           const std::string& what) {
    add(value.position.x(), bound.position.x(), truth.position.x(), what + " x");
    add(value.position.y(), bound.position.y(), truth.position.y(), what + " y");
    add(value.angle, bound.angle, truth.angle, what + " angle");
    add(value.velocity.x(), bound.velocity.x(), truth.velocity.x(), what + " vx");
    add(value.velocity.y(), bound.velocity.y(), truth.velocity.y(), what + " vy");
    add(value.spin, bound.spin, truth.spin, what + " spin");
  }
};

void compare(const tautline::test::HardSystem& system, Bounds& bounds) {
  SolveOptions options{system.law, {}, most_events, most_steps};
  const Case& the_case = system.the_case;
  const Solution solution = solve(the_case, options);
  const Uncertainty uncertainty(the_case, solution, options);
  const tautline::Digits precision(hard_digits);
  options.completion.error = hard_completion;
  const BasicSolution<BasicCase<Multi>> truth = solve(in_digits(the_case), options);
  const std::size_t common = std::min(solution.events().size(), truth.events().size());
  for (std::size_t index = 0; index < common; ++index) {
    const Event& event = solution.events()[index];
    const BasicEvent<BasicCase<Multi>>& other = truth.events()[index];
    const auto& errors = uncertainty.events()[index];
    if (event.kind != other.kind || event.cables != other.cables) {
      break;  // an accumulation that is followed further, or the horizon
    }
    if (errors && event.kind != EventKind::taut) {
      const std::string what = "event " + std::to_string(index);
      bounds.add(event.time, errors->time, other.time, what + " time");
      bounds.add(event.before, errors->before, other.before, what + " before");
      bounds.add(event.after, errors->after, other.after, what + " after");
    }
  }
  constexpr int samples = 20;
  const double end = std::min(solution.end_time(), static_cast<double>(truth.end_time()));
  for (int sample = 1; sample < samples; ++sample) {
    const double time = end * sample / samples;
    if (const auto errors = uncertainty.at(time)) {
      bounds.add(solution.at(time), *errors, truth.at(Multi(time)), "t = " + std::to_string(time));
    }
  }
  const bool whole = solution.ending() != Ending::event_limit &&
                     solution.ending() != Ending::step_limit &&
                     truth.ending() != Ending::event_limit && truth.ending() != Ending::step_limit;
  if (whole && uncertainty.unsure().empty()) {
    EXPECT_EQ(to_string(solution.ending()), to_string(truth.ending()));
  }
}

class HardDigits : public ::testing::TestWithParam<tautline::test::HardFamily> {};

TEST_P(HardDigits, AreWithinWhatIsSaidOfThem) {
  tautline::test::Random random(tautline::test::hard_seed);
  Bounds bounds;
  for (int sample = 0; sample < systems_of_a_family(); ++sample) {
    SCOPED_TRACE("sample " + std::to_string(sample));
    if (const auto system = tautline::test::hard_system(random, GetParam(), sample)) {
      compare(*system, bounds);
    }
  }
  std::printf("%ld numbers, %ld outside, at most %.3g of the bound\n", bounds.numbers,
              bounds.outside, bounds.widest_use);
  EXPECT_GT(bounds.numbers, 0);
}

INSTANTIATE_TEST_SUITE_P(Random, HardDigits, ::testing::ValuesIn(tautline::test::hard_families()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace tautline::bench
