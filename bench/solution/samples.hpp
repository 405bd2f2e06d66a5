#pragma once

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tautline/case.hpp"
#include "tautline/solution.hpp"
#include "tautline/uncertainty.hpp"

namespace tautline::bench {

/// A number and a bound of its error, in the number's own unit; < 0 where no digit is right.
struct Bounded {
  double value = 0.0;
  double error = -1.0;
};

/// The coordinates of `state`, each with its error; none of them has a digit without `errors`.
[[nodiscard]] std::vector<Bounded> bounded(const State& state, const std::optional<State>& errors);

/// One cable at one instant.
struct CableSample {
  Bounded gap;       // [m]
  Bounded gap_rate;  // [m/s]
  Bounded tension;   // [N], 0 where it is slack
};

/// Everything that a motion is at one instant.
struct MotionSample {
  Bounded time;                     // [s]
  State state;                      //
  std::optional<State> errors;      // of the state; none beyond the horizon
  std::vector<CableSample> cables;  // of the case, in order
  Bounded energy;                   // [J]
};

/// The cables held at zero gap at `time`, after an event there.
template <class TheCase>
[[nodiscard]] CableSet taut_at(const BasicSolution<TheCase>& solution,
                               const RealOf<TheCase>& time) {
  const auto& arcs = solution.arcs();
  const auto next = std::upper_bound(
      arcs.begin(), arcs.end(), time,
      [](const RealOf<TheCase>& t, const BasicArc<TheCase>& arc) { return t < arc.start; });
  return std::prev(next)->taut;
}

/// What the numbers of a sample are called: of the state, of each cable its gap, the rate of that
/// and its tension, and the energy.
[[nodiscard]] std::vector<std::string> sample_names(const Case& the_case);

/// The sample at `time`, after an event there.
[[nodiscard]] MotionSample sample_at(const Case& the_case, const Solution& solution,
                                     const Uncertainty& uncertainty, double time);

/// The two sides of an event.
enum class Side { before, after };

/// The sample on one side of event `index`.
[[nodiscard]] MotionSample sample_at_event(const Case& the_case, const Solution& solution,
                                           const Uncertainty& uncertainty, std::size_t index,
                                           Side side);

/// The tensions that hold the body in `state` on the cables `taut`, with their errors, given those
/// of the state: one for each cable of the case.
[[nodiscard]] std::vector<Bounded> bounded_tensions(const Case& the_case, const State& state,
                                                    CableSet taut, const CableVector& tensions,
                                                    const std::optional<State>& errors);

/// A table of the motion (CSV, RFC 4180, with a line of names): a row for each of `times`, and two
/// for each impact from the first time to the last, before and after, the second with the impulses
/// [N s]. The columns are
///
///     time, event, x, y, angle, vx, vy, spin, energy,
///     gap_K, gap_rate_K, tension_K, impulse_K for each cable K
///
/// in SI units, or those of the case. `event` is "before impact", "after impact" or empty. Digits
/// that are not certain are left out; a number without a certain digit is an empty cell.
[[nodiscard]] std::string samples_csv(const Case& the_case, const Solution& solution,
                                      const Uncertainty& uncertainty,
                                      std::span<const double> times);

}  // namespace tautline::bench
