#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "spread.hpp"
#include "tautline/solution.hpp"
#include "tautline/solve.hpp"

namespace tautline {

// Motions that start within the errors of a solution: where its own order of impacts is one of
// many, they show what the others come to. A sample, not a bound.

/// What lies between neighbours may be this many times as far off as they are [-]: up to 3.02 was
/// seen, over the cases of Table 5.1.
inline constexpr double neighbour_margin = 6.0;

/// The same of the instant at which they lock [-]: up to 1.6 was seen there.
inline constexpr double lock_margin = 3.0;

/// Neighbours are completed with this error of their velocities [-]: they are told apart by far
/// more, and bounce half as often.
inline constexpr double neighbour_completion = 1e-9;

/// The event that makes the set of taut cables on which a solution ends; none if that changes.
[[nodiscard]] const Event* final_set(const Solution& solution);

/// The instant [s] of that event, or of the limit of the accumulation that it completes.
[[nodiscard]] double lock_time(const Solution& solution);

/// From where neighbours start, how long they last [s], and how many there are each way.
struct Origin {
  std::size_t arc;
  const Uncertainty::Spread& spread;  // at the start of the arc
  double duration;
  std::size_t pairs = 1;
};

/// Motions from starts at the bounds of the errors, and at even parts of them, each way along their
/// largest axis, to which the others are small. None if one of them does not end on the taut cables
/// of the solution.
[[nodiscard]] std::vector<Solution> neighbours(const Case& the_case, const Solution& solution,
                                               const SolveOptions& options, const Origin& origin);

/// A bound of the error of the solution's lock [s] from `others`, which start at `from`; none if
/// there are none.
[[nodiscard]] std::optional<double> spread_of_locks(const Solution& solution, double from,
                                                    const std::vector<Solution>& others);

}  // namespace tautline
