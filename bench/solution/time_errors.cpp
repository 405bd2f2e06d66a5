#include "bench/solution/time_errors.hpp"

#include <algorithm>
#include <cmath>

namespace tautline::bench {

std::optional<double> time_error(const Solution& solution, const Uncertainty& uncertainty,
                                 double time, EventKind kind) {
  for (std::size_t index = solution.events().size(); index-- > 0;) {
    const Event& event = solution.events()[index];
    if (event.time == time && event.kind == kind) {
      const auto& errors = uncertainty.events()[index];
      return errors ? std::optional(errors->time) : std::nullopt;
    }
  }
  return std::nullopt;
}

const Accumulation* accumulation_at(const Solution& solution, const Event& event) {
  const auto& all = solution.accumulations();
  const auto found = std::lower_bound(
      all.begin(), all.end(), event.time,
      [](const Accumulation& accumulation, double time) { return accumulation.start < time; });
  const bool completes = event.kind == EventKind::taut && found != all.end() &&
                         found->start == event.time && found->cables == event.cables;
  return completes ? &*found : nullptr;
}

std::optional<double> limit_error(const Solution& solution, const Uncertainty& uncertainty,
                                  const Accumulation& accumulation) {
  auto error = time_error(solution, uncertainty, accumulation.start, EventKind::taut);
  if (error && &accumulation == &solution.accumulations().back()) {
    error = uncertainty.lock().value_or(*error);
  }
  return error ? std::optional(*error + std::abs(accumulation.uncertainty)) : std::nullopt;
}

std::optional<double> lock_error(const Solution& solution, const Settling& settling,
                                 const Uncertainty& uncertainty) {
  if (!settling.lock || solution.events().empty()) {
    return std::nullopt;
  }
  auto error = uncertainty.lock();
  if (!error) {
    error = time_error(solution, uncertainty, solution.events().back().time, EventKind::taut);
  }
  return error ? std::optional(*error + settling.lock->uncertainty) : std::nullopt;
}

}  // namespace tautline::bench
