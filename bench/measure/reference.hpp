#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "bench/cases/bench_case.hpp"
#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"
#include "tautline/system_settling.hpp"

namespace tautline::bench {

/// A case with everything that a run of it is compared with.
template <class TheCase, class TheSettling>
struct BasicReference {
  TheCase the_case;
  BasicSolution<TheCase> solution;
  TheSettling settling;
  double horizon;  // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
};
using ReferenceCase = BasicReference<Case, Settling>;
using ReferenceSystem = BasicReference<SpatialSystem, SystemSettling>;

/// The exact side of a case.
[[nodiscard]] ReferenceCase solve_case(const Case& the_case, ImpactLaw law);
/// A system has one, too. Throws std::invalid_argument where its impacts have no such law.
[[nodiscard]] ReferenceSystem solve_case(const SpatialSystem& system, ImpactLaw law);

/// The exact side of every case.
[[nodiscard]] std::vector<ReferenceCase> solve_cases(const std::vector<Case>& cases, ImpactLaw law);

/// The exact side of what engines run, of either kind.
using Reference = std::variant<ReferenceCase, ReferenceSystem>;
[[nodiscard]] std::vector<Reference> solve_all(const std::vector<BenchCase>& cases, ImpactLaw law);

/// The length of the shortest cable [m], at the start.
[[nodiscard]] double shortest_cable(const Case& the_case);
[[nodiscard]] double shortest_cable(const SpatialSystem& system);

/// When the exact motion first has a taut cable [s]; its end without one. A simulation
/// that does not follow the motion on taut cables may stop there.
template <class TheCase>
[[nodiscard]] double first_taut(const BasicSolution<TheCase>& solution) {
  for (const BasicEvent<TheCase>& event : solution.events()) {
    if (event.kind == EventKind::taut) {
      return event.time;
    }
  }
  return solution.end_time();
}

/// Samples of an exact path.
inline constexpr std::size_t exact_samples = 400;

/// The instant of one of them [s].
[[nodiscard]] double exact_sample_time(const Solution& solution, std::size_t index);

/// The exact motion of `reference`: `exact_samples` spread evenly over it, and the state after
/// every event.
[[nodiscard]] std::vector<Point> samples(const ReferenceCase& reference);

}  // namespace tautline::bench
