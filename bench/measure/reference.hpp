#pragma once

#include <cstddef>
#include <vector>

#include "bench/run/record.hpp"
#include "tautline/case.hpp"
#include "tautline/impact.hpp"
#include "tautline/settling.hpp"
#include "tautline/solution.hpp"

namespace tautline::bench {

/// A case with everything that a run of it is compared with.
struct ReferenceCase {
  Case the_case;
  Solution solution;
  Settling settling;
  double horizon;  // [s]
  ImpactLaw law = ImpactLaw::simultaneous;
};

/// The exact side of every case.
[[nodiscard]] std::vector<ReferenceCase> solve_cases(const std::vector<Case>& cases, ImpactLaw law);

/// The length of the shortest cable [m].
[[nodiscard]] double shortest_cable(const Case& the_case);

/// When the exact motion first has a taut cable [s]; its end without one. A simulation
/// that does not follow the motion on taut cables may stop there.
[[nodiscard]] double first_taut(const Solution& solution);

/// Samples of an exact path.
inline constexpr std::size_t exact_samples = 400;

/// The instant of one of them [s].
[[nodiscard]] double exact_sample_time(const Solution& solution, std::size_t index);

/// The exact motion of `reference`: `exact_samples` spread evenly over it, and the state after
/// every event.
[[nodiscard]] std::vector<Point> samples(const ReferenceCase& reference);

}  // namespace tautline::bench
