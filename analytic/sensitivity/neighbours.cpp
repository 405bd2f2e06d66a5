#include "neighbours.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "tautline/detail/projection.hpp"
#include "tautline/geometry.hpp"

namespace tautline {
namespace {

/// `state` with its numbers changed, and cables closed that it would overstretch or that were
/// closed.
State displaced(const Case& the_case, State state, const StateVector& by, CableSet closed) {
  state.position += by.head<2>();
  state.angle += by[2];
  state.velocity += by.segment<2>(3);
  state.spin += by[5];
  for (std::size_t round = 0; round < the_case.cables.size(); ++round) {    // closing one may take
    for (std::size_t index = 0; index < the_case.cables.size(); ++index) {  // another too far
      if (gap(the_case.cables[index], state) < 0.0) {
        closed.insert(index);
      }
    }
    state = with_zero_gaps(the_case, state, closed);
  }
  return state;
}

}  // namespace

const Event* final_set(const Solution& solution) {
  const auto& events = solution.events();
  return !events.empty() && events.back().kind == EventKind::taut ? &events.back() : nullptr;
}

double lock_time(const Solution& solution) {
  const Event* const set = final_set(solution);
  const auto& accumulations = solution.accumulations();
  const bool completes =
      set != nullptr && !accumulations.empty() && accumulations.back().start == set->time;
  return completes ? accumulations.back().time : set != nullptr ? set->time : 0.0;
}

std::vector<Solution> neighbours(const Case& the_case, const Solution& solution,
                                 const SolveOptions& options, const Origin& origin) {
  const Arc& arc = solution.arcs()[origin.arc];
  CableSet closed = arc.taut;
  for (const Event& event : solution.events()) {
    closed = event.time == arc.start ? closed | event.cables : closed;
  }
  StateVector rate;
  rate << arc.initial.velocity, arc.initial.spin, the_case.gravity, 0.0;
  const Eigen::SelfAdjointEigenSolver<StateMatrix> split(at_instant(origin.spread, rate));
  const StateVector largest = bound(split.eigenvalues()[5]) * split.eigenvectors().col(5);
  constexpr std::size_t few = 1'000;  // [-]
  SolveOptions patient = options;     // with what does as the solution does, not with more
  patient.completion.error = std::max(options.completion.error, neighbour_completion);
  patient.max_events = std::min(options.max_events, few + 2 * solution.events().size());
  patient.max_steps = std::min(options.max_steps, few + 2 * solution.arcs().size());
  Case neighbour = the_case;
  neighbour.duration = origin.duration;
  std::vector<Solution> result;
  std::vector<double> parts;
  for (std::size_t pair = 1; pair <= origin.pairs; ++pair) {
    const double part = static_cast<double>(pair) / static_cast<double>(origin.pairs);
    parts.insert(parts.end(), {-part, part});
  }
  for (const double part : parts) {
    neighbour.initial = displaced(the_case, arc.initial, part * largest, closed);
    if (!problems(neighbour).empty()) {
      return {};
    }
    result.push_back(solve(neighbour, patient));
    const Solution& motion = result.back();
    if (final_set(motion) == nullptr || motion.arcs().back().taut != solution.arcs().back().taut ||
        motion.end_time() < neighbour.duration) {
      return {};
    }
  }
  return result;
}

std::optional<double> spread_of_locks(const Solution& solution, double from,
                                      const std::vector<Solution>& others) {
  if (others.empty() || final_set(solution) == nullptr) {
    return std::nullopt;
  }
  double result = 0.0;
  for (const Solution& motion : others) {
    result = std::max(result, std::abs(from + lock_time(motion) - lock_time(solution)));
  }
  return lock_margin * result;
}

}  // namespace tautline
