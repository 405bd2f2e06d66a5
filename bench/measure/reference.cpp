#include "bench/measure/reference.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "bench/measure/horizon.hpp"
#include "tautline/solve.hpp"

namespace tautline::bench {

std::vector<ReferenceCase> solve_cases(const std::vector<Case>& cases, ImpactLaw law) {
  std::vector<ReferenceCase> references;
  for (const Case& the_case : cases) {
    Solution solution = solve(the_case, {.law = law});
    const double horizon = std::min(predictability_horizon(the_case, solution, law),
                                    sure_until(the_case, solution, law));
    Settling settled = settling(the_case, solution);
    references.push_back({the_case, std::move(solution), std::move(settled), horizon, law});
  }
  return references;
}

double shortest_cable(const Case& the_case) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Cable& cable : the_case.cables) {
    shortest = std::min(shortest, cable.length);
  }
  return shortest;
}

double first_taut(const Solution& solution) {
  const auto& events = solution.events();
  const auto found = std::find_if(events.begin(), events.end(),
                                  [](const Event& event) { return event.kind == EventKind::taut; });
  return found != events.end() ? found->time : solution.end_time();
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
