#include "bench/judge/step_needed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "bench/judge/allowance.hpp"
#include "tautline/case_or_system.hpp"
#include "tautline/impact.hpp"

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

/// The speed of a `motion`, a turn counting at the end of a cable of `length` [m], of the fastest
/// body [m/s].
double largest_speed(const Eigen::Vector3d& motion, double length) {
  return motion.head<2>().norm() + length * std::abs(motion[2]);
}
double largest_speed(const RowOf<SpatialSystem>& motion, double length) {
  double fastest = 0.0;
  for (Eigen::Index row = 0; row < motion.size(); row += 6) {
    fastest = std::max(fastest,
                       motion.segment<3>(row).norm() + length * motion.segment<3>(row + 3).norm());
  }
  return fastest;
}

/// The first impact before `until` [s] after which the plain scheme has other velocities.
template <class TheReference>
std::optional<double> first_unlike(const TheReference& reference, double until) {
  constexpr double same = 1e-9;  // [-], of the velocities
  const double length = shortest_cable(reference.the_case);
  for (const auto& event : reference.solution.events()) {
    if (event.time > until || reference.law == ImpactLaw::simultaneous) {
      break;
    }
    if (event.kind != EventKind::impact) {
      continue;
    }
    const auto plain =
        resolve_impact(ImpactLaw::simultaneous, reference.the_case, event.before, event.cables)
            .after;
    const decltype(motion_of(plain)) change = motion_of(plain) - motion_of(event.after);
    if (largest_speed(change, length) >
        same * std::max(largest_speed(motion_of(event.before), length),
                        largest_speed(motion_of(event.after), length))) {
      return event.time;
    }
  }
  return std::nullopt;
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

template <class TheReference>
StepNeeded step_needed(const TheReference& reference, double part) {
  StepNeeded result;
  result.part = part;
  result.until = std::min(usual_window, reference.solution.end_time());
  result.unlike = first_unlike(reference, result.until);
  if (result.unlike) {
    return result;
  }
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
  const double safe = step_at(steps, worst, part * length, largest);
  result.longest = safe >= largest;
  result.safe = rounded_down(safe);
  result.typical = rounded_down(step_at(steps, mean, part * length, largest));
  constexpr double shortest = shortest_needed_for<TheReference> / rounding;
  const auto of = [&](double step) { return yardstick(reference, step, {result.until}, length); };
  while (result.safe >= shortest && of(result.safe).worst.back() > part * length) {
    result.safe = next_smaller(result.safe);
    result.longest = false;
  }
  while (result.typical >= shortest && of(result.typical).mean.back() > part * length) {
    result.typical = next_smaller(result.typical);
  }
  result.typical = std::max(result.typical, result.safe);
  return result;
}

template StepNeeded step_needed(const ReferenceCase&, double);
template StepNeeded step_needed(const ReferenceSystem&, double);

}  // namespace tautline::bench
