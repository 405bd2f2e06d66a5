#include "bench/measure/reference.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "bench/base/listed.hpp"
#include "bench/measure/horizon.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

ReferenceCase solve_case(const Case& the_case, ImpactLaw law) {
  Solution solution = solve(the_case, {.law = law});
  const double horizon = std::min(predictability_horizon(the_case, solution, law),
                                  sure_until(the_case, solution, law));
  Settling settled = settling(the_case, solution);
  return {the_case, std::move(solution), std::move(settled), horizon, law};
}

ReferenceSystem solve_case(const SpatialSystem& system, ImpactLaw law) {
  auto solution = solve(system, {.law = law});
  const double horizon = predictability_horizon(system, solution, law);
  SystemSettling settled = settling(system, solution);
  return {system, std::move(solution), std::move(settled), horizon, law};
}

std::vector<ReferenceCase> solve_cases(const std::vector<Case>& cases, ImpactLaw law) {
  return listed(cases, [law](const Case& one) { return solve_case(one, law); });
}

std::vector<Reference> solve_all(const std::vector<BenchCase>& cases, ImpactLaw law) {
  return listed(cases, [law](const BenchCase& any) {
    return std::visit([law](const auto& one) { return Reference(solve_case(one, law)); }, any);
  });
}

double shortest_cable(const Case& the_case) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Cable& cable : the_case.cables) {
    shortest = std::min(shortest, cable.length);
  }
  return shortest;
}

double shortest_cable(const SpatialSystem& system) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const SpatialCable& cable : system.cables) {
    shortest = std::min(shortest, cable.length.at(system.initial.time)[0]);
  }
  return shortest;
}

double exact_sample_time(const Solution& solution, std::size_t index) {
  constexpr std::size_t last = exact_samples - 1;
  return index == last
             ? solution.end_time()
             : solution.end_time() * static_cast<double>(index) / static_cast<double>(last);
}

std::vector<Point> samples(const ReferenceCase& reference) {
  const Solution& solution = reference.solution;
  std::vector<Point> points;
  auto event = solution.events().begin();
  for (std::size_t index = 0; index < exact_samples; ++index) {
    const double time = exact_sample_time(solution, index);
    for (; event != solution.events().end() && event->time <= time; ++event) {
      points.push_back({event->time, event->after});
    }
    points.push_back({time, solution.at(time)});
  }
  return points;
}

}  // namespace tautline::bench
