#include "bench/judge/step_needed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/judge/allowance.hpp"

namespace tautline::bench {
namespace {

/// Steps whose errors are known, as parts of the window.
constexpr std::array parts_of_window = {1e-2 / usual_window, 1e-3 / usual_window,
                                        1e-4 / usual_window};

constexpr double largest_part = 3e-2 / usual_window;  // a longer step is not looked at
constexpr double rounding = 1.0 + 1e-9;               // 0.01 from a logarithm is 0.01

/// The step at which the error is `allowed`; `steps` fall.
double step_at(const std::array<double, 3>& steps, const std::array<double, 3>& errors,
               double allowed, double largest) {
  if (errors.back() > allowed) {  // of first order from there on
    return steps.back() * allowed / errors.back();
  }
  for (std::size_t place = errors.size() - 1; place-- > 0;) {
    if (errors[place] > allowed) {
      const double slope = std::log(errors[place] / errors[place + 1]);
      const double part = slope > 0.0 ? std::log(allowed / errors[place + 1]) / slope : 0.0;
      return steps[place + 1] * std::pow(steps[place] / steps[place + 1], part);
    }
  }
  return std::min(largest, errors.front() > 0.0 ? steps.front() * allowed / errors.front()
                                                : std::numeric_limits<double>::infinity());
}

}  // namespace

double rounded_down(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step * rounding)));
  for (const double times : {5.0, 2.0}) {
    if (times * power <= step * rounding) {
      return times * power;
    }
  }
  return power;
}

double next_smaller(double step) { return rounded_down(0.9 * step); }

StepNeeded step_needed(const ReferenceCase& reference, double part) {
  StepNeeded result;
  result.part = part;
  result.until = std::min(usual_window, reference.solution.end_time());
  const double length = shortest_cable(reference.the_case);
  std::array<double, 3> steps{};
  std::array<double, 3> worst{};
  std::array<double, 3> mean{};
  for (std::size_t place = 0; place < steps.size(); ++place) {
    steps[place] = parts_of_window[place] * result.until;
    const Yardstick plain = yardstick(reference, steps[place], {result.until}, length);
    worst[place] = plain.worst.back();
    mean[place] = plain.mean.back();
  }
  const double largest = largest_part * result.until;
  result.safe = rounded_down(step_at(steps, worst, part * length, largest));
  result.typical = rounded_down(step_at(steps, mean, part * length, largest));
  return result;
}

}  // namespace tautline::bench
